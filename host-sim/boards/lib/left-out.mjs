// What firmware waits for and rp2040js leaves out: the ring oscillator, the voltage regulator, the end of a DMA that is
// aborted or has nothing to carry.
//
// Whoever asks is told at once that all is stable and done. Nothing is clocked by the ring once the crystal swings, no
// voltage is emulated and an abort of rp2040js takes no time: none of it changes what firmware does.

const ROSC = { page: 0x40060, status: 0x18, stable: (1 << 31) | (1 << 12), atReset: [] };
const VREG = { page: 0x40064, status: 0x00, stable: 1 << 12, atReset: [[0x00, 0xb1]] };
const DMA = { page: 0x50000, abort: 0x444 };

/** Gives `chip` what is left out. */
export function addLeftOut(chip) {
  for (const { page, status, stable, atReset } of [ROSC, VREG]) {
    const registers = new Map(atReset);
    const part = chip.peripherals[page];
    part.readUint32 = (offset) => ((registers.get(offset) ?? 0) | (offset === status ? stable : 0)) >>> 0;
    part.writeUint32 = (offset, value) => void registers.set(offset, value);
  }
  const dma = chip.peripherals[DMA.page];
  const read = dma.readUint32.bind(dma);
  dma.readUint32 = (offset) => (offset === DMA.abort ? 0 : read(offset));
  for (const channel of dma.channels) {
    const start = channel.start.bind(channel);
    channel.start = () => channel.transCountReload > 0 && start();
  }
}
