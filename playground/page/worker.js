/** Runs the core beside the page, so that a picture of seconds stops nobody from scrolling. */

import { Core, compile } from './core.js';

const module = compile(new URL('scanray.wasm', import.meta.url));
let core = null;
/** The files of the open scene, where it is none of the gallery. */
let files = [];

async function answer(request, picked) {
  if (request.ask === 'read') return replace(request, picked);
  if (request.ask === 'write') return replace(request, files);
  core ??= await Core.start(await module);
  const told = core.ask(request);
  if (request.ask === 'open' && told.opened) files = [];
  const picture = told.frame ?? told.heat;
  return picture ? { ...told, pixels: core.pixels(picture.size) } : told;
}

/** Opens a text or a file. They stay in a core's memory: a new core takes them, and if they are good the old one goes. */
async function replace(request, handed) {
  const next = await Core.start(await module);
  let told;
  try {
    told = await hand(next, handed);
    told ??= next.ask(request);
  } catch (error) {
    // The new core is lost, not the one with the scene before.
    return { fault: `The core has stopped at this scene: ${error}` };
  }
  if (told.opened) [core, files] = [next, handed];
  return told;
}

/** Hands files to a core; answers what is told of the first that it does not take. */
async function hand(next, handed) {
  for (const file of handed) {
    const content = await file.arrayBuffer().catch((error) => error);
    if (content instanceof Error) return { fault: `${file.name} cannot be read: ${content.message}` };
    const told = next.take(file.name, new Uint8Array(content));
    if (told.fault) return told;
  }
}

// One request at a time: each waits for the one before.
let last = Promise.resolve();

addEventListener('message', ({ data: { id, request, picked } }) => {
  last = last.then(async () => {
    const begin = performance.now();
    try {
      const told = await answer(request, picked);
      const time = performance.now() - begin;
      postMessage({ id, time, told }, told.pixels ? [told.pixels.buffer] : []);
    } catch (error) {
      // A core that has stopped is of no more use.
      core = null;
      postMessage({ id, time: 0, told: { stopped: String(error) } });
    }
  });
});
