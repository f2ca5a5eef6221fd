// A Raspberry Pi Pico with an ST7789 panel on SPI0, emulated by rp2040js.

import { functionAt } from './elf.mjs';
import { addLeftOut } from './left-out.mjs';
import { Complaint } from './outcome.mjs';
import { SecondCore } from './second-core.mjs';
import { SpiLine } from './spi-line.mjs';
import { PIXELS, St7789 } from './st7789.mjs';

const FLASH = 0x10000000;
const VECTORS = FLASH + 0x100;
const PIN = { dataNotCommand: 16, select: 17, backlight: 20, reset: 21, lamp: 25 };

/** The fastest write clock of the ST7789: a cycle takes 16 ns. */
const PANEL_HZ = 62.5e6;

/** Five times the slowest frame so far (900 million): an image that needs more will never finish. */
const MOST_INSTRUCTIONS = 5e9;

export class Pico {
  constructor({ RP2040, GPIOPinState }, elf) {
    this.elf = elf;
    this.newChip = () => new RP2040();
    this.high = GPIOPinState.High;
    this.panel = new St7789();
    this.start();
  }

  /** Starts a chip that has just got power. */
  start() {
    this.chip = this.newChip();
    this.second = new SecondCore(this.chip);
    addLeftOut(this.chip);
    this.lit = false;
    this.faults = [];
    /** Instructions since the start. */
    this.executed = 0;
    /** Counted from the moment the lamp is first lit; `tracing` is what was done by its light. */
    this.counts = { instructions: 0, cycles: 0, tracing: { instructions: 0, cycles: 0 } };
    this.deepest = Infinity;
    this.connectPanel();
    this.listenToLog();
    this.load();
  }

  /**
   * Resets the chip, wherever it is: its memory then holds whatever `random`, which answers numbers from 0 to 1, says.
   * The panel does not notice: it keeps its picture, its window and the half of a command that it was sent.
   */
  reset(random) {
    this.start();
    const { sram } = this.chip;
    for (let i = 0; i < sram.length; i++) sram[i] = 256 * random();
  }

  isHigh(pin) {
    return this.chip.gpio[pin].value === this.high;
  }

  connectPanel() {
    // The panel looks at select and D/C with the last bit of a byte: a pin that moves too early spoils the byte.
    this.line = new SpiLine(this.chip, this.chip.spi[0], (byte) => {
      if (!this.isHigh(PIN.select)) this.panel.receive(byte, this.isHigh(PIN.dataNotCommand));
    });
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
    // Of SEV the emulator tells its log and nobody else.
    const info = (_, message) => message === 'SEV' && this.second.event();
    this.chip.logger = { debug() {}, info, warn: fault, error: fault };
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

  /** Runs until the panel has all pixels of one more frame and the lamp is dark; returns what the panel shows. */
  frame() {
    const goal = this.panel.written + PIXELS;
    const patience = this.executed + MOST_INSTRUCTIONS;
    while (this.panel.written < goal || this.lit) {
      this.advance();
      if (this.executed > patience) this.stuck(this.chip.core.PC);
    }
    this.check();
    return this.panel.picture();
  }

  /** Runs so many instructions and returns the name of the function that the last led to. */
  run(instructions) {
    for (const end = this.executed + instructions; this.executed < end;) this.advance();
    return functionAt(this.elf, this.chip.core.PC);
  }

  /** Runs one instruction; one that leads nowhere, or would be a fault on the chip, is a complaint. */
  advance() {
    const lost = this.step();
    this.executed++;
    if (lost !== undefined || this.faults.length) this.stuck(lost ?? this.chip.core.PC);
  }

  /** Runs one instruction, and the second core as long; returns the address of one that leads nowhere, if there is one. */
  step() {
    const { second, chip: { core, clock, clkSys } } = this;
    const pc = core.PC;
    const asleep = core.waiting;
    const cycles = asleep ? this.sleepCycles() : core.executeInstruction();
    clock.tick((cycles * 1e9) / clkSys);
    if (this.lit || this.counts.cycles) this.count(cycles);
    if (core.SP < this.deepest) this.deepest = core.SP;
    const lost = second.running ? second.follow(cycles) : undefined;
    // Who sleeps may be woken by the other core, or by a part whose time comes: a timer, the bus, DMA.
    const hangs = asleep ? core.waiting && !second.running && !clock.nextAlarm : core.PC === pc;
    return hangs ? pc : lost;
  }

  /** Cycles until something may happen to the sleeping core: those to the next alarm, unless the other core is awake. */
  sleepCycles() {
    const { second, chip: { clock, clkSys } } = this;
    return second.running ? 1 : Math.max(1, Math.ceil((clock.nanosToNextAlarm * clkSys) / 1e9));
  }

  count(cycles) {
    const { counts } = this;
    counts.before ??= this.line.busy;
    counts.instructions++;
    counts.cycles += cycles;
    if (!this.lit) return;
    counts.tracing.instructions++;
    counts.tracing.cycles += cycles;
  }

  stuck(pc) {
    const where = functionAt(this.elf, pc);
    const why = this.faults.join('\n') || `the firmware stopped in ${where}`;
    throw new Complaint(`${why}\nafter ${this.panel.written} of ${PIXELS} pixels, at ${where}`);
  }

  check() {
    const { fastest } = this.line;
    if (fastest > PANEL_HZ) throw new Complaint(`SPI clock ${fastest} Hz is faster than the panel takes`);
    if (!this.isHigh(PIN.backlight)) throw new Complaint('The backlight is off: nobody would see the picture');
  }

  /** Seconds of the board's time since counting began. */
  get seconds() {
    return this.counts.cycles / this.chip.clkSys;
  }

  /** Bytes of stack used so far. */
  get stack() {
    return this.stackTop - this.deepest;
  }

  /** Cycles of the core's clock that the line to the panel was busy since counting began. */
  get transferCycles() {
    return Math.round(((this.line.busy - this.counts.before) * this.chip.clkSys) / 1e9);
  }
}
