// A 32-bit little-endian ELF image: what to load where, and what the functions are called.

import { readFileSync } from 'node:fs';

const PT_LOAD = 1;
const SHT_SYMTAB = 2;
const STT_FUNC = 2;

export function readElf(path) {
  const file = readFileSync(path);
  if (file.length < 52 || file.readUInt32BE(0) !== 0x7f454c46 || file[4] !== 1) {
    throw new Error(`${path} is no 32-bit ELF image`);
  }
  return { segments: segments(file), functions: functions(file) };
}

function segments(file) {
  const table = file.readUInt32LE(28);
  const size = file.readUInt16LE(42);
  const count = file.readUInt16LE(44);
  return Array.from({ length: count }, (_, i) => table + i * size)
    .filter((at) => file.readUInt32LE(at) === PT_LOAD && file.readUInt32LE(at + 16) > 0)
    .map((at) => {
      const offset = file.readUInt32LE(at + 4);
      const length = file.readUInt32LE(at + 16);
      return { address: file.readUInt32LE(at + 12), bytes: file.subarray(offset, offset + length) };
    });
}

function sections(file) {
  const table = file.readUInt32LE(32);
  const size = file.readUInt16LE(46);
  const count = file.readUInt16LE(48);
  return Array.from({ length: count }, (_, i) => table + i * size).map((at) => ({
    type: file.readUInt32LE(at + 4),
    offset: file.readUInt32LE(at + 16),
    length: file.readUInt32LE(at + 20),
    link: file.readUInt32LE(at + 24),
  }));
}

function functions(file) {
  const all = sections(file);
  const symbols = all.find((section) => section.type === SHT_SYMTAB);
  if (!symbols) return [];
  const names = all[symbols.link].offset;
  const found = [];
  for (let at = symbols.offset; at < symbols.offset + symbols.length; at += 16) {
    if ((file[at + 12] & 15) !== STT_FUNC) continue;
    const name = names + file.readUInt32LE(at);
    found.push({
      name: file.toString('latin1', name, file.indexOf(0, name)),
      start: (file.readUInt32LE(at + 4) & ~1) >>> 0,
      length: file.readUInt32LE(at + 8),
    });
  }
  return found;
}

/** The name of the function that holds `address`, or the bare address. */
export function functionAt(elf, address) {
  const found = elf.functions.find((f) => address >= f.start && address < f.start + Math.max(f.length, 2));
  return found ? found.name : `0x${address.toString(16)}`;
}
