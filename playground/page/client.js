/** Asks the core, which runs in a worker. */

const worker = new Worker(new URL('worker.js', import.meta.url), { type: 'module' });
const waiting = new Map();
let count = 0;

/** Is a request that was not done; `message` says why. */
export class Fault extends Error {}

/**
 * Hands a request to the core, with the files that were picked for it; resolves to what it is told, with the
 * milliseconds it took.
 */
export function ask(request, picked = []) {
  return new Promise((resolve, reject) => {
    waiting.set(++count, { resolve, reject });
    worker.postMessage({ id: count, request, picked });
  });
}

worker.addEventListener('message', ({ data: { id, time, told } }) => {
  const { resolve, reject } = waiting.get(id);
  waiting.delete(id);
  const fault =
    told.fault ?? (told.stopped && `The core has stopped: ${told.stopped}. Open the scene again.`);
  if (fault) reject(new Fault(fault));
  else resolve({ ...told, time });
});

worker.addEventListener('error', (event) => {
  const fault = new Fault(
    `The core does not start: ${event.message ?? 'this browser runs no module workers'}`,
  );
  for (const { reject } of waiting.values()) reject(fault);
  waiting.clear();
});
