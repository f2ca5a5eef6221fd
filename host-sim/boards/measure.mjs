// An RP2040 that poses as the board of `examples/measure`: it has that board's memory at 0, its counter and its
// semihosting, but the counter counts cycles, forty to a tick, where QEMU's counts instructions.
//
// `node measure.mjs IMAGE STRIDE` renders each STRIDEth row and prints what the firmware says until it has measured.

import { functionAt, readElf } from './lib/elf.mjs';
import { emulator } from './lib/emulator.mjs';
import { Complaint, runBoard } from './lib/outcome.mjs';

const CYCLES_PER_TICK = 40;

/** The board's memory for code, as the linker script lays it out; an image is far smaller. */
const CODE_BYTES = 1 << 20;

/** The peripheral of the board's counter. */
const COUNTER = { page: 0x40028, offset: 0x18 };

/** The semihosting calls of Arm's that the firmware makes, in thumb code by `bkpt 0xab`. */
const CALL = { breakpoint: 0xab, open: 0x01, write: 0x05, commandLine: 0x15, end: 0x18 };

/** An image that needs more will never finish. */
const MOST_CYCLES = 2e10;

class Board {
  constructor({ RP2040 }, elf, words) {
    this.chip = new RP2040();
    this.elf = elf;
    this.words = words;
    this.cycles = 0;
    this.said = '';
    this.faults = [];
    const fault = (part, message) => this.faults.push(`[${part}] ${message}`);
    this.chip.logger = { debug() {}, info() {}, warn: fault, error: fault };
    this.chip.peripherals[COUNTER.page] = { readUint32: (offset) => this.counter(offset) };
    this.chip.onBreak = (code) => this.called(code);
    this.load();
  }

  counter(offset) {
    if (offset !== COUNTER.offset) this.faults.push(`the board has no register ${offset} beside its counter`);
    return Math.floor(this.cycles / CYCLES_PER_TICK) >>> 0;
  }

  /** Puts the image where the boot ROM was, and starts as the core does: stack and entry point from address 0. */
  load() {
    const code = new Uint8Array(CODE_BYTES);
    for (const { address, bytes } of this.elf.segments) code.set(bytes, address);
    this.chip.bootrom = new Uint32Array(code.buffer);
    this.chip.core.SP = this.chip.readUint32(0);
    this.chip.core.PC = this.chip.readUint32(4) & ~1;
  }

  called(code) {
    const { registers } = this.chip.core;
    if (code !== CALL.breakpoint) this.faults.push(`a breakpoint that is no semihosting: ${code}`);
    registers[0] = this.answer(registers[0], registers[1]);
  }

  answer(call, block) {
    const [first, second, third] = [0, 4, 8].map((offset) => this.chip.readUint32(block + offset));
    switch (call) {
      case CALL.open: return 1;
      case CALL.write: return this.write(second, third);
      case CALL.commandLine: return this.give(this.words, first, second);
      default: this.faults.push(`a semihosting call that is not expected: ${call}`);
    }
    return -1;
  }

  write(address, length) {
    for (let i = 0; i < length; i++) this.said += String.fromCharCode(this.chip.readUint8(address + i));
    return 0;
  }

  give(text, address, room) {
    if (text.length >= room) return -1;
    for (let i = 0; i <= text.length; i++) this.chip.writeUint8(address + i, i < text.length ? text.charCodeAt(i) : 0);
    return 0;
  }

  run() {
    const { core } = this.chip;
    while (!this.said.endsWith('\nmeasured\n')) {
      this.cycles += core.executeInstruction();
      if (this.faults.length || this.said.includes('failed') || this.cycles > MOST_CYCLES) this.stuck();
    }
  }

  stuck() {
    throw new Complaint([...this.faults, this.said, `stopped in ${functionAt(this.elf, this.chip.core.PC)}`].join('\n'));
  }
}

await runBoard(async (image) => {
  const board = new Board(await emulator(), readElf(image), `measure ${process.argv[3] ?? 1}`);
  board.run();
  process.stdout.write(board.said);
});
