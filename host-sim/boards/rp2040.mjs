// A Raspberry Pi Pico with an ST7789 panel: runs a firmware image until it has drawn its frames.
//
// SCANRAY_BOARD_FRAMES says how many, SCANRAY_BOARD_SECONDS for how long of the board's own time at least; of more than
// one frame, each is kept. Then the board is reset SCANRAY_BOARD_RESETS times in the middle of what it does, at moments
// that follow from SCANRAY_BOARD_SEED, and the frame it draws after each reset is kept too.

import { basename, resolve } from 'node:path';

import { readElf } from './lib/elf.mjs';
import { emulator } from './lib/emulator.mjs';
import { Complaint, outcomeFolder, perPixel, runBoard, writePicture, writeReport } from './lib/outcome.mjs';
import { Pico } from './lib/pico.mjs';
import { moments, randomFrom } from './lib/resets.mjs';
import { PIXELS } from './lib/st7789.mjs';

/** The number in an environment variable. */
const asked = (name, otherwise) => Number(process.env[`SCANRAY_BOARD_${name}`] ?? otherwise);

/** The cycles of a frame: what the first core traced, what the line carried, and both side by side. */
function frameTimes({ counts, transferCycles }, frames) {
  const [tracing, transfer, frame] = [counts.tracing.cycles, transferCycles, counts.cycles]
    .map((cycles) => Math.round(cycles / frames));
  return { tracing, transfer, frame };
}

function printTimes({ tracing, transfer, frame }, { chip: { clkSys }, line, second }) {
  const row = (name, ...columns) => console.log(name.padEnd(48) + columns.map((text) => text.padStart(14)).join(''));
  const time = (name, cycles) => {
    row(`  ${name}`, cycles.toLocaleString('en'), ((cycles * 1e3) / clkSys).toFixed(1), (cycles / PIXELS).toFixed(1));
  };
  row(`a frame, core at ${clkSys / 1e6} MHz, SPI at ${line.fastest / 1e6} MHz`, 'cycles', 'ms', 'a pixel');
  time(second.running ? "tracing the first core's rows" : 'tracing', tracing);
  time('transfer', transfer);
  time('one after the other', tracing + transfer);
  time('side by side, as it was', frame);
}

/** Stops a board at moments before `end` and starts it anew; keeps the frame that it draws after each. */
function drawAfterResets(pico, end, keep) {
  const random = randomFrom(asked('SEED', 1));
  for (const [number, moment] of moments(asked('RESETS', 0), end, random).entries()) {
    pico.reset(random);
    console.log(`reset ${number} after ${moment.toLocaleString('en')} instructions, in ${pico.run(moment)}`);
    pico.reset(random);
    keep(`reset-${number}`, pico.frame());
  }
}

await runBoard(async (image) => {
  const [least, seconds] = [asked('FRAMES', 1), asked('SECONDS', 0)];
  const pico = new Pico(await emulator(), readElf(image));
  const folder = outcomeFolder(image);
  const name = basename(image);
  const keep = (which, picture) => writePicture(folder, `${name}-${which}`, picture);
  let frames = 0;
  for (; frames < least || pico.seconds < seconds; frames++) {
    if (least > 1 || seconds > 0) keep(frames, pico.frame());
    else writePicture(folder, name, pico.frame());
  }
  const { instructions, tracing } = pico.counts;
  const times = frameTimes(pico, frames);
  const pixels = frames * PIXELS;
  const { stack, second } = pico;
  writeReport(folder, {
    image: resolve(image), frames, pixels, instructions: tracing.instructions, 'with-panel': instructions, ...times, stack,
    ...(second.running && { 'second-stack': second.stack }),
  });
  console.log(`instructions, tracing: ${perPixel(tracing.instructions, pixels)}`);
  console.log(`instructions, with the wait for the panel: ${perPixel(instructions, pixels)}; stack: ${stack} bytes`);
  if (second.running) console.log(`stack of the second core: ${second.stack} bytes`);
  printTimes(times, pico);
  drawAfterResets(pico, Math.floor(pico.executed / frames), keep);
});
