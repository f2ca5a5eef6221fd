// The line of an SPI: words take the time that their bits take.
//
// rp2040js hands a word over the moment it leaves the queue and asks to be told when it is out. Here it is told when
// the SPI's clock has shifted the last bit, so that DMA, which waits for room in the queue, runs at the line's speed.

/** In the modes with SPH = 0 the SPI (PL022) lifts its own select line after every word: about two clocks. */
const CLOCKS_BETWEEN_WORDS = 2;
const SPH = 1 << 7;

export class SpiLine {
  /** Listens to `spi` of `chip`; `receive` gets each word when its last bit is on the line. */
  constructor(chip, spi, receive) {
    this.spi = spi;
    /** Nanoseconds the line was busy, and its fastest clock. */
    this.busy = 0;
    this.fastest = 0;
    const out = chip.clock.createAlarm(() => {
      receive(this.word);
      spi.completeTransmit(0);
    });
    spi.onTransmit = (word) => {
      this.word = word;
      const nanos = this.wordNanos();
      this.busy += nanos;
      this.fastest = Math.max(this.fastest, spi.clockFrequency);
      out.schedule(nanos);
    };
  }

  wordNanos() {
    const pause = this.spi.control0 & SPH ? 0 : CLOCKS_BETWEEN_WORDS;
    return ((this.spi.dataBits + pause) * 1e9) / this.spi.clockFrequency;
  }
}
