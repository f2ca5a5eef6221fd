// The RP2040 emulator, which is installed apart from Debian's packages.

import { Complaint } from './outcome.mjs';

/** The emulator's module; that it is missing is a complaint. */
export async function emulator() {
  try {
    return await import('rp2040js');
  } catch {
    throw new Complaint('The RP2040 emulator is not installed. Install it with: npm ci --prefix host-sim/boards');
  }
}
