// What a run leaves behind: pictures, a report for programs, and a few lines for people.

import { mkdirSync, writeFileSync } from 'node:fs';
import { basename, dirname, join, relative, resolve } from 'node:path';

import { gray4ToRgb, png, rgb565ToRgb } from './png.mjs';

const TO_RGB = { rgb565: rgb565ToRgb, gray4: gray4ToRgb };

/** An error whose message says all a user needs: no stack trace. */
export class Complaint extends Error {}

/**
 * The folder a run writes to: SCANRAY_BOARD_OUT, or `boards/NAME` in the target folder that
 * `image` (TARGET/TRIPLE/PROFILE/NAME, or an example's TARGET/TRIPLE/PROFILE/examples/NAME) lies in.
 */
export function outcomeFolder(image) {
  const beside = dirname(resolve(image));
  const target = join(beside, basename(beside) === 'examples' ? '../../..' : '../..');
  const folder = process.env.SCANRAY_BOARD_OUT ?? join(target, 'boards', basename(image));
  mkdirSync(folder, { recursive: true });
  return folder;
}

/**
 * Writes the picture `name` twice: as PNG, and raw (big-endian RGB565, or a byte for each grey level) to be compared.
 */
export function writePicture(folder, name, { width, height, format, raw }) {
  const path = join(folder, `${name}.png`);
  writeFileSync(join(folder, `${name}.${format}`), raw);
  writeFileSync(path, png(width, height, TO_RGB[format](raw)));
  console.log(`${name}: ${width}x${height} ${format}, ${relative('.', path)}`);
}

/** Writes `report.txt`, a `key value` pair a line. */
export function writeReport(folder, pairs) {
  const lines = Object.entries(pairs).map(([key, value]) => `${key} ${value}\n`);
  writeFileSync(join(folder, 'report.txt'), lines.join(''));
}

/** `count` with the figure a pixel in brackets. */
export function perPixel(count, pixels) {
  return `${count.toLocaleString('en')} (${(count / pixels).toFixed(1)} a pixel)`;
}

/** Runs `main` on the image named on the command line; a complaint ends the program with its message alone. */
export async function runBoard(main) {
  try {
    const image = process.argv[2];
    if (!image) throw new Complaint('Which firmware image? Give its path.');
    await main(image);
  } catch (error) {
    console.error(error instanceof Complaint ? error.message : error);
    process.exitCode = 1;
  }
}
