// The RP2040's second core, which rp2040js leaves out: another processor of its kind on the same memory and parts.
//
// What belongs to each core alone is switched with it: its number, its end of the queues between the cores (SIO FIFO)
// and its memory protection, of which the second core's stack guard is watched. Both cores get every memory access they
// ask for at once; on the chip they may have to wait for each other.

const CPUID = 0x000;
const FIFO_ST = 0x050;
const FIFO_WR = 0x054;
const FIFO_RD = 0x058;
const FIFO = { valid: 1, ready: 2, room: 8 };

const PSM = 0x40010;
const PSM_FRCE_OFF = 0x04;
const PROC1 = 1 << 16;

const MPU_TYPE = 0xd90;
const MPU_RBAR = 0xd9c;
const MPU_RASR = 0xda0;

/** What the first core sends to the boot ROM of the second: these, then vectors, stack and entry point. */
const GREETING = [0, 0, 1];

export class SecondCore {
  constructor(chip) {
    this.chip = chip;
    this.first = chip.core;
    this.core = new chip.core.constructor(chip);
    /** Words on their way to each core, and what each wrote to its memory protection. */
    this.queues = [[], []];
    this.protection = [new Map(), new Map()];
    this.deepest = Infinity;
    this.reset();
    this.shareSio(chip.sio);
    this.shareProtection(chip.ppb);
    this.obeyPower(chip.peripherals[PSM]);
  }

  /** Goes back to the boot ROM, which listens. */
  reset() {
    this.running = false;
    this.heard = [];
    this.owed = 0;
    this.guardEnd = 0;
  }

  get active() {
    return this.chip.core === this.core ? 1 : 0;
  }

  shareSio(sio) {
    const [read, write] = [sio.readUint32.bind(sio), sio.writeUint32.bind(sio)];
    sio.readUint32 = (offset) => {
      const mine = this.queues[this.active];
      switch (offset) {
        case CPUID: return this.active;
        case FIFO_ST: return (mine.length > 0 ? FIFO.valid : 0) | (this.isReady() ? FIFO.ready : 0);
        case FIFO_RD: return mine.shift() ?? 0;
        default: return read(offset);
      }
    };
    sio.writeUint32 = (offset, value) => {
      if (offset === FIFO_WR) this.send(value);
      else if (offset !== FIFO_ST) write(offset, value);
    };
  }

  isReady() {
    return this.queues[1 - this.active].length < FIFO.room;
  }

  send(word) {
    if (this.active === 0 && !this.running) this.hear(word);
    else if (this.isReady()) this.queues[1 - this.active].push(word);
  }

  /** The boot ROM answers each word with the same word, and starts anew when it does not know it. */
  hear(word) {
    this.queues[0].push(word);
    this.heard.push(word);
    const known = GREETING.every((expected, i) => i >= this.heard.length || this.heard[i] === expected);
    if (!known) this.heard = [];
    if (this.heard.length < GREETING.length + 3) return;
    const [vectors, stack, entry] = this.heard.slice(GREETING.length);
    Object.assign(this.core, { VTOR: vectors, SP: stack, PC: entry & ~1, waiting: false });
    this.stackTop = stack;
    this.running = true;
  }

  shareProtection(ppb) {
    const [read, write] = [ppb.readUint32.bind(ppb), ppb.writeUint32.bind(ppb)];
    const isMine = (offset) => offset >= MPU_TYPE && offset <= MPU_RASR;
    ppb.readUint32 = (offset) => (isMine(offset) ? this.protection[this.active].get(offset) ?? 0 : read(offset));
    ppb.writeUint32 = (offset, value) => {
      if (!isMine(offset)) return write(offset, value);
      this.protection[this.active].set(offset, value);
      if (offset === MPU_RASR && this.active === 1) this.guard(value);
    };
  }

  /** Watches the one eighth of a region of 256 bytes, below the stack, that the attributes leave on. */
  guard(attributes) {
    const base = this.protection[1].get(MPU_RBAR) & ~0xff;
    const eighth = [0, 1, 2, 3, 4, 5, 6, 7].find((i) => !(attributes & (0x100 << i)));
    if (eighth !== undefined) this.guardEnd = (base >>> 0) + 32 * (eighth + 1);
  }

  obeyPower(psm) {
    const write = psm.writeUint32.bind(psm);
    psm.writeUint32 = (offset, value) => {
      write(offset, value);
      if (offset === PSM_FRCE_OFF && value & PROC1) this.reset();
    };
  }

  /** An event (SEV) wakes both cores from WFE. */
  event() {
    for (const core of [this.first, this.core]) {
      core.eventRegistered = !core.waiting;
      core.waiting = false;
    }
  }

  /** Bytes of its stack used so far; nothing before it was started. */
  get stack() {
    return this.running ? this.stackTop - this.deepest : undefined;
  }

  /** Runs for so many cycles; returns the address of an instruction that leads nowhere, if there is one, or off the stack. */
  follow(cycles) {
    const { chip, core } = this;
    this.owed += cycles;
    chip.core = core;
    let stuck;
    while (this.owed > 0 && !core.waiting && stuck === undefined) {
      const pc = core.PC;
      this.owed -= core.executeInstruction();
      if (core.SP < this.deepest) this.deepest = core.SP;
      if (core.PC === pc || core.SP < this.guardEnd) stuck = pc;
    }
    if (core.waiting) this.owed = 0;
    chip.core = this.first;
    return stuck;
  }
}
