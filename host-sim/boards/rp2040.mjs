// A Raspberry Pi Pico with an ST7789 panel on SPI0: runs a firmware image until it has drawn its frames.

import { basename, resolve } from 'node:path';

import { functionAt, readElf } from './lib/elf.mjs';
import { emulator } from './lib/emulator.mjs';
import { Complaint, outcomeFolder, perPixel, runBoard, writePicture, writeReport } from './lib/outcome.mjs';
import { PIXELS, St7789 } from './lib/st7789.mjs';

const FLASH = 0x10000000;
const VECTORS = FLASH + 0x100;
const PIN = { dataNotCommand: 16, select: 17, backlight: 20, reset: 21, lamp: 25 };

/** The fastest write clock of the ST7789: a cycle takes 16 ns. */
const PANEL_HZ = 62.5e6;

/** Eight times the slowest frame so far (621 million): an image that needs more will never finish. */
const MOST_INSTRUCTIONS = 5e9;

class Pico {
  constructor({ RP2040, GPIOPinState }, elf) {
    this.elf = elf;
    this.chip = new RP2040();
    this.high = GPIOPinState.High;
    this.panel = new St7789();
    this.faults = [];
    this.spans = { instructions: 0, rendering: 0, cycles: 0, deepest: Infinity };
    this.connectPanel();
    this.listenToLog();
    this.load();
  }

  isHigh(pin) {
    return this.chip.gpio[pin].value === this.high;
  }

  connectPanel() {
    const spi = this.chip.spi[0];
    spi.onTransmit = (byte) => {
      if (!this.isHigh(PIN.select)) this.panel.receive(byte, this.isHigh(PIN.dataNotCommand));
      this.fastest = Math.max(this.fastest ?? 0, spi.clockFrequency);
      spi.completeTransmit(0);
    };
    this.chip.gpio[PIN.reset].addListener((state) => {
      if (state !== this.high) this.panel.reset();
    });
    this.chip.gpio[PIN.lamp].addListener((state) => {
      this.lit = state === this.high;
    });
  }

  /** The emulator only logs a bad access and carries on; on the chip it would be a fault. */
  listenToLog() {
    const fault = (part, message) => this.faults.push(`[${part}] ${message}`);
    this.chip.logger = { debug() {}, info() {}, warn: fault, error: fault };
  }

  /** Starts as the boot ROM does once the flash chip answers: stack and entry point from the vector table. */
  load() {
    for (const { address, bytes } of this.elf.segments) this.chip.flash.set(bytes, address - FLASH);
    const { core } = this.chip;
    core.VTOR = VECTORS;
    this.stackTop = this.chip.readUint32(VECTORS);
    core.SP = this.stackTop;
    core.PC = this.chip.readUint32(VECTORS + 4) & ~1;
  }

  /** Runs until `frames` whole pictures have reached the panel and the lamp is dark again. */
  run(frames) {
    const { core, clock } = this.chip;
    const { spans, panel } = this;
    const nanos = 1e9 / this.chip.clkSys;
    let started = false;
    for (let executed = 0; panel.written < frames * PIXELS || this.lit; executed++) {
      const pc = core.PC;
      const cycles = core.executeInstruction();
      clock.tick(cycles * nanos);
      started ||= this.lit;
      if (started) {
        spans.instructions++;
        spans.cycles += cycles;
        if (this.lit) spans.rendering++;
      }
      if (core.SP < spans.deepest) spans.deepest = core.SP;
      if (core.PC === pc || core.waiting || this.faults.length || executed > MOST_INSTRUCTIONS) this.stuck(pc);
    }
  }

  stuck(pc) {
    const where = functionAt(this.elf, pc);
    const why = this.faults.join('\n') || `the firmware stopped in ${where}`;
    throw new Complaint(`${why}\nafter ${this.panel.written} of ${PIXELS} pixels, at ${where}`);
  }
}

function check(pico) {
  if (pico.fastest > PANEL_HZ) throw new Complaint(`SPI clock ${pico.fastest} Hz is faster than the panel takes`);
  if (!pico.isHigh(PIN.backlight)) throw new Complaint('The backlight is off: nobody would see the picture');
}

await runBoard(async (image) => {
  const frames = Number(process.env.SCANRAY_BOARD_FRAMES ?? 1);
  const pico = new Pico(await emulator(), readElf(image));
  pico.run(frames);
  check(pico);
  const { instructions, rendering, cycles, deepest } = pico.spans;
  const pixels = frames * PIXELS;
  const folder = outcomeFolder(image);
  writePicture(folder, basename(image), pico.panel.picture());
  writeReport(folder, {
    image: resolve(image), pixels, instructions: rendering, 'with-panel': instructions, cycles, stack: pico.stackTop - deepest,
  });
  console.log(`instructions, rendering: ${perPixel(rendering, pixels)}`);
  console.log(`instructions, with the panel's driver: ${perPixel(instructions, pixels)}`);
  console.log(`emulated cycles, all: ${perPixel(cycles, pixels)}; stack: ${pico.stackTop - deepest} bytes`);
});
