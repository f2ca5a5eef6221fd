// An Arm MPS2 board (AN386, Cortex-M4F) without a panel: runs the bench and keeps the pictures it hands over.

import { readFileSync } from 'node:fs';
import { join, resolve } from 'node:path';

import { Complaint, outcomeFolder, perPixel, runBoard, writePicture, writeReport } from './lib/outcome.mjs';
import { Qemu } from './lib/qemu.mjs';

const WIDTH = 320;
const HEIGHT = 240;
const PIXELS = WIDTH * HEIGHT;

/** The firmware counts at 25 MHz, and an instruction takes a nanosecond. */
const INSTRUCTIONS_PER_TICK = 40;

/** Lowest address and size of the stack, as the linker script lays it out. */
const STACK = { address: 0x20000000, size: 16 * 1024 };

const SEMIHOSTING = ['-semihosting-config', 'enable=on,target=native', '-serial', 'none'];

function fnv(bytes) {
  return bytes.reduce((sum, byte) => Math.imul(sum ^ byte, 0x01000193) >>> 0, 0x811c9dc5);
}

/** Checks a scene's picture against what the firmware says of it, and returns what to report. */
function takeScene(folder, name, ticks, checksum) {
  const raw = readFileSync(join(folder, `${name}.rgb565`));
  if (raw.length !== 2 * PIXELS || fnv(raw) !== checksum) {
    throw new Complaint(`${name}: the file does not have the checksum ${checksum} that the firmware computed`);
  }
  writePicture(folder, name, { width: WIDTH, height: HEIGHT, format: 'rgb565', raw });
  const instructions = ticks * INSTRUCTIONS_PER_TICK;
  console.log(`${name}: instructions: ${perPixel(instructions, PIXELS)}`);
  return [`${name}.instructions`, instructions];
}

await runBoard(async (image) => {
  const folder = outcomeFolder(image);
  const qemu = new Qemu('mps2-an386', resolve(image), SEMIHOSTING, folder);
  try {
    const words = await qemu.words();
    const scenes = [...words.matchAll(/^(\S+) ticks (\d+)\n\1 checksum (\d+)$/gm)];
    if (scenes.length === 0) throw new Complaint(`the firmware reports no scene:\n${words}`);
    const figures = scenes.map(([, name, ticks, checksum]) => takeScene(folder, name, Number(ticks), Number(checksum)));
    const stack = await qemu.stackUsed(STACK);
    writeReport(folder, { image: resolve(image), pixels: PIXELS, ...Object.fromEntries(figures), stack });
    console.log(`stack: ${stack} bytes`);
  } finally {
    qemu.stop();
  }
});
