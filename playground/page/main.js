/** The page: what is chosen becomes a look, a look becomes a picture. */

import { rays, tell } from './account.js';
import { ask } from './client.js';
import * as controls from './controls.js';
import { download } from './download.js';
import { Editor } from './editor.js';
import { Stage } from './stage.js';
import { Walk, walkByKeys, walkByPointer } from './walk.js';

/** Is how long a picture may take while it moves, in milliseconds, before it is drawn coarser. */
const PATIENCE = 60;

const by = (id) => document.getElementById(id);
const form = by('controls');
const stage = new Stage(by('panel'), by('mark'), by('zoom'));
const editor = new Editor(by('text'), (text) => open({ ask: 'write', text, of: form.scene.value }));
const { choices } = await ask({ ask: 'choices' }).catch((fault) => {
  say(by('fault'), fault);
  throw fault;
});
const walk = new Walk(choices.walk, () => {
  moving = true;
  draw();
});
let scene = null;
/** Whether a picture is being drawn, is to be drawn again, and is of a camera that moves. */
let [busy, stale, moving] = [false, false, false];
let perPixel = 0;

/** Shows a fault where it belongs, or takes it away. */
function say(place, fault) {
  place.textContent = fault?.message ?? '';
  place.hidden = !fault;
  return {};
}

const isOn = (id) => by(id).getAttribute('aria-pressed') === 'true';

/** Opens a scene by a request, with what the page's address says; one with a fault leaves that before. */
async function open(request, { words, place } = controls.NOTHING) {
  const complaint = request.ask === 'write' ? by('wrong') : by('fault');
  stage.canvas.ariaBusy = 'true';
  if (request.ask === 'open') editor.forget();
  const told = await ask(request).catch((fault) => say(complaint, fault));
  if (!told.opened) {
    stage.canvas.ariaBusy = String(busy);
    return;
  }
  [by('fault'), by('wrong')].forEach((complaint) => say(complaint, null));
  // What a writer has not changed of size, depth and dither stays as it was chosen.
  if (request.ask === 'open' || !controls.areAlike(scene, told.opened)) controls.take(form, told.opened);
  scene = told.opened;
  walk.reach = scene.reach;
  by('about').textContent = scene.about;
  stage.canvas.setAttribute('aria-label', `${scene.name} on the panel`);
  if (request.ask === 'open') {
    controls.restore(form, words);
    walk.go(place);
    editor.show((await ask({ ask: 'text' }).catch((fault) => say(by('wrong'), fault))).text ?? '');
  } else {
    walk.go(walk.place);
  }
  await draw();
}

/** Draws until the picture is that of what is chosen; while it moves, as coarsely as it must be to follow. */
async function draw() {
  if (!scene) return;
  stale = true;
  if (busy) return;
  busy = true;
  stage.canvas.ariaBusy = 'true';
  while (stale) {
    stale = false;
    const step = moving ? coarseness() : 1;
    moving = false;
    await frame(step);
    // A picture that has come to rest is drawn whole.
    stale ||= step > 1;
    if (isOn('spin')) {
      await new Promise(requestAnimationFrame);
      walk.by(walk.parts / 4, 0);
    }
  }
  busy = false;
  controls.keep(form, walk);
  stage.canvas.ariaBusy = 'false';
  if (stage.at) await account(stage.at);
}

/** Answers how many pixels along a side become one, that pictures follow the hand. */
function coarseness() {
  const { size } = controls.look(form, walk);
  const time = (step) => (perPixel * size[0] * size[1]) / (step * step);
  return [1, 2, 4].find((step) => time(step) < PATIENCE) ?? 8;
}

async function frame(step) {
  const look = controls.look(form, walk);
  const size = look.size.map((side) => Math.max(Math.floor(side / step), 1));
  try {
    const { frame, pixels, time } = await ask({ ask: 'frame', look: { ...look, size } });
    perPixel = time / (size[0] * size[1]);
    const shown = isOn('heat') ? await heat({ ...look, size }) : pixels;
    stage.show(shown, size, look.size);
    const total = frame.rays.reduce((sum, count) => sum + count);
    const took = `${size.join(' × ')} in ${look.number}: ${time.toFixed(1)} ms`;
    by('said').textContent = `${took}; ${total.toLocaleString('en')} rays: ${rays(frame.rays)}`;
    say(by('fault'), null);
  } catch (fault) {
    say(by('fault'), fault);
  }
}

/** Answers the heat map's pixels and shows what its colours mean. */
async function heat(look) {
  const { heat, pixels } = await ask({ ask: 'heat', look });
  const colors = choices.heat.map((color) => `rgb(${color})`).join(', ');
  by('scale').style.background = `linear-gradient(to right, ${colors})`;
  [by('fewest').textContent, by('most').textContent] = heat.range.map((count) => `${count} rays`);
  return pixels;
}

/** Tells what a pixel is. */
async function account(at) {
  stage.point(at);
  const told = await ask({ ask: 'pixel', at }).catch(() => null);
  if (told) tell(by('account'), told.pixel);
  else stage.point(null);
}

/** Makes a button one that is on or off. */
function toggle(id, changed) {
  by(id).addEventListener('click', () => {
    by(id).setAttribute('aria-pressed', String(!isOn(id)));
    changed();
  });
}

/** Lets Shift and arrow keys go from pixel to pixel. */
function pointByKeys(canvas) {
  const steps = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
  canvas.addEventListener('keydown', (event) => {
    const step = event.shiftKey && steps[event.key];
    if (!step) return;
    event.preventDefault();
    const from = stage.at ?? stage.size.map((side) => side >> 1);
    account(from.map((place, axis) => Math.min(Math.max(place + step[axis], 0), stage.size[axis] - 1)));
  });
}

/** Takes a text of the core away as a file. */
async function take(request, name, type) {
  const told = await ask(request).catch((fault) => say(by('fault'), fault));
  if (told.text !== undefined) download(name, told.text, type);
}

controls.fill(form, choices);
const address = controls.kept();
controls.restore(form, { scene: 'three-spheres', ...address.words });

form.addEventListener('submit', (event) => event.preventDefault());
form.addEventListener('change', ({ target }) => {
  if (target !== form.scene) return draw();
  stage.point(null);
  open({ ask: 'open', name: form.scene.value });
});
walkByKeys(stage.canvas, walk);
walkByPointer(stage.canvas, walk, (event) => account(stage.pixelAt(event)));
pointByKeys(stage.canvas);
by('home').addEventListener('click', () => walk.home());
toggle('spin', draw);
toggle('heat', () => {
  by('legend').hidden = !isOn('heat');
  draw();
});
by('png').addEventListener('click', async () =>
  download(`${scene.name}.png`, await stage.png(), 'image/png'),
);
by('source').addEventListener('click', () =>
  take({ ask: 'source', number: form.number.value }, 'scene.rs', 'text/plain'),
);
by('ron').addEventListener('click', () => download(`${scene.name}.ron`, by('text').value, 'text/plain'));

await open({ ask: 'open', name: form.scene.value }, address);
