// The ST7789 panel controller as seen from its serial bus, on a module of 240x240 visible pixels.

const WIDTH = 240;
const HEIGHT = 320;
const VISIBLE = 240;

const COMMANDS = {
  0x01: 'reset', 0x10: 'sleepIn', 0x11: 'sleepOut', 0x20: 'inversionOff', 0x21: 'inversionOn',
  0x28: 'displayOff', 0x29: 'displayOn', 0x2a: 'columns', 0x2b: 'rows', 0x2c: 'write', 0x36: 'madctl', 0x3a: 'colmod',
};

// Bits of MADCTL: mirror rows, mirror columns, exchange rows and columns, blue first.
const MY = 0x80;
const MX = 0x40;
const MV = 0x20;
const BGR = 0x08;

export class St7789 {
  constructor() {
    // At power-up it holds anything: a pixel that nobody draws shows.
    this.memory = Uint16Array.from({ length: WIDTH * HEIGHT }, (_, i) => Math.imul(i, 40503));
    this.reset();
    /** Pixels written since power-up. */
    this.written = 0;
  }

  /** Goes back to the registers of power-up; the picture stays in memory. */
  reset() {
    this.awake = false;
    this.on = false;
    this.inverted = false;
    this.madctl = 0;
    this.bytesPerPixel = 3;
    this.columns = [0, WIDTH - 1];
    this.rows = [0, HEIGHT - 1];
    this.command = undefined;
  }

  /** A byte from the bus: a command when D/C is low, else an argument or part of a pixel. */
  receive(byte, dataNotCommand) {
    if (!dataNotCommand) {
      this.command = COMMANDS[byte];
      this.pending = [];
      this.obey();
    } else if (this.command === 'write') {
      this.pixelByte(byte);
    } else {
      this.pending.push(byte);
      this.argument();
    }
  }

  obey() {
    switch (this.command) {
      case 'reset': return this.reset();
      case 'sleepIn': return void (this.awake = false);
      case 'sleepOut': return void (this.awake = true);
      case 'inversionOff': return void (this.inverted = false);
      case 'inversionOn': return void (this.inverted = true);
      case 'displayOff': return void (this.on = false);
      case 'displayOn': return void (this.on = true);
      case 'write': return void ([this.x, this.y] = [this.columns[0], this.rows[0]]);
    }
  }

  argument() {
    const bytes = this.pending;
    if (this.command === 'madctl') this.madctl = bytes[0];
    if (this.command === 'colmod') this.bytesPerPixel = pixelBytes(bytes[0]);
    if (bytes.length === 4 && (this.command === 'columns' || this.command === 'rows')) {
      this[this.command] = [(bytes[0] << 8) | bytes[1], (bytes[2] << 8) | bytes[3]];
    }
  }

  pixelByte(byte) {
    this.pending.push(byte);
    if (this.pending.length < this.bytesPerPixel) return;
    const [a, b, c] = this.pending;
    this.store(this.bytesPerPixel === 2 ? (a << 8) | b : ((a >> 3) << 11) | ((b >> 2) << 5) | (c >> 3));
    this.pending.length = 0;
  }

  store(pixel) {
    const [column, row] = this.madctl & MV ? [this.y, this.x] : [this.x, this.y];
    const x = this.madctl & MX ? WIDTH - 1 - column : column;
    const y = this.madctl & MY ? HEIGHT - 1 - row : row;
    if (x < 0 || x >= WIDTH || y < 0 || y >= HEIGHT) throw new Error(`pixel outside the panel at ${this.x}, ${this.y}`);
    this.memory[y * WIDTH + x] = pixel;
    this.written++;
    this.advance();
  }

  advance() {
    if (++this.x <= this.columns[1]) return;
    this.x = this.columns[0];
    if (++this.y > this.rows[1]) this.y = this.rows[0];
  }

  /** What the eye sees, as big-endian RGB565. The glass of such modules inverts, so inversion on shows true colours. */
  picture() {
    const raw = Buffer.alloc(2 * VISIBLE * VISIBLE);
    if (!this.awake || !this.on) return { width: VISIBLE, height: VISIBLE, format: 'rgb565', raw };
    for (let i = 0; i < VISIBLE * VISIBLE; i++) {
      const pixel = this.inverted ? this.memory[i] : this.memory[i] ^ 0xffff;
      raw.writeUInt16BE(this.madctl & BGR ? swapRedAndBlue(pixel) : pixel, 2 * i);
    }
    return { width: VISIBLE, height: VISIBLE, format: 'rgb565', raw };
  }
}

/** Pixels of a whole picture. */
export const PIXELS = VISIBLE * VISIBLE;

function pixelBytes(colmod) {
  const bytes = { 5: 2, 6: 3 }[colmod & 7];
  if (!bytes) throw new Error(`pixel format 0x${colmod.toString(16)} is neither 16 nor 18 bits`);
  return bytes;
}

function swapRedAndBlue(pixel) {
  return ((pixel & 31) << 11) | (pixel & 0x7e0) | (pixel >> 11);
}
