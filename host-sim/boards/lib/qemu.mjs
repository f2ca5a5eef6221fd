// QEMU with its monitor on a socket and the firmware's own words on standard output.

import { spawn } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { createConnection } from 'node:net';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { createInterface } from 'node:readline';
import { setTimeout as sleep } from 'node:timers/promises';

import { Complaint } from './outcome.mjs';

const QEMU = 'qemu-system-arm';

/** Wall-clock time after which a run counts as hung. */
const PATIENCE_MS = 300_000;

/**
 * With `-icount shift=0` an instruction takes one nanosecond of virtual time, whatever the host does, so that the
 * board's timers count instructions.
 */
const COMMON = ['-display', 'none', '-icount', 'shift=0', '-no-reboot'];

export class Qemu {
  /** Starts `machine` with the firmware `image` and `more` options; `folder` is where the firmware's files go. */
  constructor(machine, image, more, folder = '.') {
    this.scratch = mkdtempSync(join(tmpdir(), 'scanray-'));
    this.socket = join(this.scratch, 'monitor');
    this.said = '';
    this.complained = '';
    const monitor = ['-qmp', `unix:${this.socket},server,nowait`];
    this.process = spawn(QEMU, ['-M', machine, '-kernel', image, ...COMMON, ...monitor, ...more], {
      cwd: folder,
      stdio: ['ignore', 'pipe', 'pipe'],
    });
    this.process.stdout.on('data', (data) => { this.said += data; });
    this.process.stderr.on('data', (data) => { this.complained += data; });
    this.ended = new Promise((resolve) => {
      this.process.on('error', () => resolve('missing'));
      this.process.on('exit', (code, signal) => resolve(signal ?? code));
    });
  }

  /** The firmware's words up to and including the line `done`; any other end is a complaint. */
  async words() {
    const end = Date.now() + PATIENCE_MS;
    for (;;) {
      if (/^done$/m.test(this.said)) return this.said;
      if (/^failed/m.test(this.said)) throw new Complaint(this.said.trim());
      const code = await Promise.race([this.ended, sleep(10)]);
      if (code === 'missing') throw new Complaint(`${QEMU} is not on the PATH (Debian: apt-get install qemu-system-arm)`);
      if (code !== undefined) {
        // What it said last may arrive after the news of its end.
        await sleep(50);
        if (/^done$/m.test(this.said)) return this.said;
        throw new Complaint(`${QEMU} ended (${code})\n${this.complained}${this.said}`);
      }
      if (Date.now() > end) throw new Complaint(`no end after ${PATIENCE_MS / 1000} s; so far:\n${this.said}`);
    }
  }

  /** Gives a command to the monitor and waits until it is carried out. */
  async monitor(execute, args) {
    const socket = createConnection(this.socket);
    const lines = createInterface({ input: socket })[Symbol.asyncIterator]();
    try {
      await lines.next(); // the greeting
      for (const request of [{ execute: 'qmp_capabilities' }, { execute, arguments: args }]) {
        socket.write(JSON.stringify(request));
        await answer(lines);
      }
    } finally {
      socket.destroy();
    }
  }

  /** How far down the stack has reached: RAM starts out as zeros, so that is the lowest byte that is none. */
  async stackUsed({ address, size }) {
    const filename = join(this.scratch, 'stack');
    await this.monitor('pmemsave', { val: address, size, filename });
    const first = readFileSync(filename).findIndex((byte) => byte !== 0);
    return first < 0 ? 0 : size - first;
  }

  stop() {
    this.process.kill();
    rmSync(this.scratch, { recursive: true, force: true });
  }
}

/** The next answer; events in between are no concern of ours. */
async function answer(lines) {
  for (;;) {
    const { value, done } = await lines.next();
    const reply = done ? { error: { desc: 'it hung up' } } : JSON.parse(value);
    if (reply.error) throw new Complaint(`the monitor of ${QEMU} complains: ${reply.error.desc}`);
    if ('return' in reply) return;
  }
}

/** The number after `name` in the firmware's words. */
export function figure(words, name) {
  const found = words.match(new RegExp(`^${name} (\\d+)`, 'm'));
  if (!found) throw new Complaint(`the firmware does not say '${name}':\n${words}`);
  return Number(found[1]);
}
