// A Stellaris LM3S6965 evaluation board with its OLED: runs a firmware image until it says on UART0 that it is done.

import { readFileSync } from 'node:fs';
import { basename, join, resolve } from 'node:path';

import { Complaint, outcomeFolder, perPixel, runBoard, writePicture, writeReport } from './lib/outcome.mjs';
import { figure, Qemu } from './lib/qemu.mjs';

const WIDTH = 128;
const HEIGHT = 64;

/** The emulated panel is drawn this much larger than it is. */
const SCALE = 4;

/** The firmware's stopwatch ticks at 50 MHz, and an instruction takes a nanosecond. */
const INSTRUCTIONS_PER_TICK = 20;

/** Lowest address and size of the stack, as the linker script lays it out. */
const STACK = { address: 0x20000000, size: 8 * 1024 };

/** The panel's grey levels, a byte a pixel, from a screen dump. */
function panelFrom(ppm) {
  const header = ppm.toString('latin1', 0, 20).match(/^P6\n(\d+) (\d+)\n255\n/);
  if (!header || Number(header[1]) !== WIDTH * SCALE || Number(header[2]) !== HEIGHT * SCALE) {
    throw new Complaint('The screen dump is not that of the panel');
  }
  const raw = Buffer.alloc(WIDTH * HEIGHT);
  for (let y = 0; y < HEIGHT * SCALE; y++) {
    for (let x = 0; x < WIDTH * SCALE; x++) {
      const grey = ppm[header[0].length + 3 * (y * WIDTH * SCALE + x)];
      raw[Math.floor(y / SCALE) * WIDTH + Math.floor(x / SCALE)] = Math.round(grey / 17);
    }
  }
  return { width: WIDTH, height: HEIGHT, format: 'gray4', raw };
}

/** The instructions that firmware with a stopwatch says it took; that of a user has none. */
function instructionsFrom(words) {
  if (!/^rendering /m.test(words)) return undefined;
  const [rendering, sending] = ['rendering', 'sending'].map((name) => figure(words, name) * INSTRUCTIONS_PER_TICK);
  return { instructions: rendering, 'with-panel': rendering + sending };
}

await runBoard(async (image) => {
  const qemu = new Qemu('lm3s6965evb', image, ['-serial', 'stdio']);
  try {
    const words = await qemu.words();
    const screen = join(qemu.scratch, 'screen.ppm');
    await qemu.monitor('screendump', { filename: screen });
    const counts = instructionsFrom(words);
    const stack = await qemu.stackUsed(STACK);
    const pixels = WIDTH * HEIGHT;
    const folder = outcomeFolder(image);
    writePicture(folder, basename(image), panelFrom(readFileSync(screen)));
    writeReport(folder, { image: resolve(image), pixels, ...counts, stack });
    if (counts) {
      console.log(`instructions, rendering: ${perPixel(counts.instructions, pixels)}`);
      console.log(`instructions, with the panel's driver: ${perPixel(counts['with-panel'], pixels)}`);
    }
    console.log(`stack: ${stack} bytes`);
  } finally {
    qemu.stop();
  }
});
