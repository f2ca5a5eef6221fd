/** Runs the core beside the page, so that a picture of seconds stops nobody from scrolling. */

import { Core, compile } from './core.js';

const module = compile(new URL('scanray.wasm', import.meta.url));
let core = null;

async function answer(request) {
  if (request.ask === 'write') return write(request);
  core ??= await Core.start(await module);
  const told = core.ask(request);
  const picture = told.frame ?? told.heat;
  return picture ? { ...told, pixels: core.pixels(picture.size) } : told;
}

/** Opens a text. Texts stay in a core's memory: a new core takes it, and if it is good the old one goes. */
async function write(request) {
  const next = await Core.start(await module);
  const told = next.ask(request);
  if (told.opened) core = next;
  return told;
}

// One request at a time: each waits for the one before.
let last = Promise.resolve();

addEventListener('message', ({ data: { id, request } }) => {
  last = last.then(async () => {
    const begin = performance.now();
    try {
      const told = await answer(request);
      const time = performance.now() - begin;
      postMessage({ id, time, told }, told.pixels ? [told.pixels.buffer] : []);
    } catch (error) {
      // A core that has stopped is of no more use.
      core = null;
      postMessage({ id, time: 0, told: { stopped: String(error) } });
    }
  });
});
