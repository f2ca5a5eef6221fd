// Moments at which a board is reset: scattered, and the same ones for the same seed.

/** A source of numbers from 0 to 1: the generator mulberry32 (T. Ettinger 2017). */
export function randomFrom(seed) {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let bits = Math.imul(state ^ (state >>> 15), state | 1);
    bits ^= bits + Math.imul(bits ^ (bits >>> 7), bits | 61);
    return ((bits ^ (bits >>> 14)) >>> 0) / 2 ** 32;
  };
}

/**
 * `count` numbers of instructions below `end`. Every other one is scattered over the orders of magnitude, so that the
 * start, which is over after a thousandth of a picture, is met as often as the drawing.
 */
export function moments(count, end, random) {
  return Array.from({ length: count }, (_, i) => Math.floor(i % 2 === 0 ? end * random() : end ** random()));
}
