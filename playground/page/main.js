/** The page: what is chosen becomes a look, a look becomes a picture. */

import { explain, forget, rays, tell } from './account.js';
import { ask } from './client.js';
import * as controls from './controls.js';
import { download } from './download.js';
import { Editor } from './editor.js';
import { drop, Files, pick } from './files.js';
import { Stage } from './stage.js';
import { Walk, walkByKeys, walkByPointer } from './walk.js';

/** Is how long a picture may take while it moves, in milliseconds, before it is drawn coarser. */
const PATIENCE = 60;

const by = (id) => document.getElementById(id);
const form = by('controls');
const stage = new Stage(by('panel'), by('mark'), by('zoom'));
const editor = new Editor(by('text'), (text) => open({ ask: 'write', text, ...origin }));
const files = new Files(openFiles);
const { choices } = await ask({ ask: 'choices' }).catch((fault) => {
  say(by('fault'), fault);
  throw fault;
});
const walk = new Walk(choices.walk, () => {
  moving = true;
  draw();
});
/** Is where the rays of a pixel are told. */
const explained = { hint: by('rays-hint'), tree: by('tree'), figures: by('figures') };
let scene = null;
/** What the text of the scene is of: the gallery or a model, or the file that it is. */
let origin = {};
/** Whether a picture is being drawn, is to be drawn again, and is of a camera that moves. */
let [busy, stale, moving] = [false, false, false];
/** How many scenes are on their way. */
let coming = 0;
/** Whether a pixel was pointed at that nothing is told of yet. */
let asked = false;
let perPixel = 0;
/** Whether the last picture could be drawn. */
let isDrawn = true;

/** Shows a fault where it belongs, or takes it away. */
function say(place, fault) {
  place.textContent = fault?.message ?? '';
  place.hidden = !fault;
  return {};
}

/** Says whether what is on the panel is about to be something else. */
function sayBusy() {
  stage.canvas.ariaBusy = String(busy || coming > 0);
}

const isOn = (id) => by(id).getAttribute('aria-pressed') === 'true';

/**
 * Opens a scene by a request, with the files picked for it and what the page's address says; one with a fault leaves
 * that before. Resolves to whether it is open.
 */
async function open(request, picked, address) {
  coming += 1;
  sayBusy();
  const isOpen = await put(request, picked, address);
  coming -= 1;
  if (isOpen) await draw();
  sayBusy();
  return isOpen;
}

/** Puts a scene on the page that is not drawn yet; resolves to whether it is there. */
async function put(request, picked = [], { words, place } = controls.NOTHING) {
  const isWritten = request.ask === 'write';
  const complaint = isWritten ? by('wrong') : by('fault');
  if (!isWritten) editor.forget();
  const told = await ask(request, picked).catch((fault) => say(complaint, fault));
  if (!told.opened) return false;
  [by('fault'), by('wrong')].forEach((complaint) => say(complaint, null));
  // What a writer has not changed of size, depth and dither stays as it was chosen.
  if (!isWritten || !controls.areAlike(scene, told.opened)) controls.take(form, told.opened);
  scene = told.opened;
  walk.reach = scene.reach;
  by('about').textContent = scene.about;
  by('notes').replaceChildren(...scene.notes.map((note) => element('li', note)));
  stage.canvas.setAttribute('aria-label', `${scene.name} on the panel`);
  if (isWritten) {
    walk.go(walk.place);
  } else {
    stage.point(null);
    asked = false;
    forget(by('account'), explained);
    origin = originOf(request, scene);
    controls.name(form.scene, request.ask === 'read' && request.name);
    controls.restore(form, words);
    walk.go(place);
    editor.show((await ask({ ask: 'text' }).catch((fault) => say(by('wrong'), fault))).text ?? '');
  }
  return true;
}

/** Answers what the text of a scene is of that was opened by a request. */
function originOf(request, { file }) {
  return file === request.name ? { file } : { of: request.name };
}

/** Opens the scene among files of one's own. */
async function openFiles(name, picked) {
  const bytes = picked.reduce((sum, { size }) => sum + size, 0);
  const wrong =
    (!name && 'None of these files is a scene: the name of one ends in .ron, .nff or .obj.') ||
    (bytes > choices.most_bytes && `These files have more than ${choices.most_bytes} bytes together.`);
  if (wrong) {
    say(by('fault'), new Error(wrong));
    return false;
  }
  const isOpen = await open({ ask: 'read', name }, picked);
  if (!isOpen) by('fault').append('\n\nIf a file is missing, pick or drop it now.');
  return isOpen;
}

/** Draws until the picture is that of what is chosen; while it moves, as coarsely as it must be to follow. */
async function draw() {
  if (!scene) return;
  stale = true;
  if (busy) return;
  busy = true;
  sayBusy();
  let isTold = false;
  while (stale) {
    stale = isTold = false;
    const step = moving ? coarseness() : 1;
    moving = false;
    await frame(step);
    // A picture that has come to rest is drawn whole.
    stale ||= step > 1;
    if (asked && step === 1) {
      isTold = true;
      await account();
    }
    if (isOn('spin')) {
      await new Promise(requestAnimationFrame);
      walk.by(walk.parts / 4, 0);
    }
  }
  busy = false;
  controls.keep(form, walk);
  sayBusy();
  if (stage.at && (asked || !isTold)) await account();
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
    by('heat').disabled = !frame.rays;
    by('source').disabled = !choices.of_firmware.includes(look.number);
    const isHot = isOn('heat') && frame.rays;
    by('legend').hidden = !isHot;
    stage.show(isHot ? await heat({ ...look, size }) : pixels, size, look.size);
    const took = `${size.join(' × ')} in ${controls.NUMBERS[look.number]}: ${time.toFixed(1)} ms`;
    by('said').textContent = [took, work(frame)].filter(Boolean).join('; ');
    // What kept a scene from being opened stays told.
    if (!isDrawn) say(by('fault'), null);
    isDrawn = true;
  } catch (fault) {
    isDrawn = false;
    say(by('fault'), fault);
  }
}

/** Answers what was counted for a picture, in words. */
function work(frame) {
  if (frame.fragments !== null) return `${frame.fragments.toLocaleString('en')} depths tested`;
  if (!frame.rays) return '';
  const total = frame.rays.reduce((sum, count) => sum + count);
  return `${total.toLocaleString('en')} rays: ${rays(frame.rays)}`;
}

/** Answers the heat map's pixels and shows what its colours mean. */
async function heat(look) {
  const { heat, pixels } = await ask({ ask: 'heat', look });
  const colors = choices.heat.map((color) => `rgb(${color})`).join(', ');
  by('scale').style.background = `linear-gradient(to right, ${colors})`;
  [by('fewest').textContent, by('most').textContent] = heat.range.map((count) => `${count} rays`);
  return pixels;
}

/** Points at a pixel and tells of it: while pictures are drawn, as soon as a whole one is there. */
async function point(at) {
  stage.point(at);
  asked = true;
  if (!busy) await account();
}

/** Tells what the pixel is that was pointed at. */
async function account() {
  asked = false;
  const told = await ask({ ask: 'pixel', at: stage.at }).catch(() => null);
  if (!told) {
    stage.point(null);
    return forget(by('account'), explained);
  }
  tell(by('account'), told.pixel);
  explain(explained, told.pixel);
}

function element(name, text) {
  return Object.assign(document.createElement(name), { textContent: text });
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
    point(from.map((place, axis) => Math.min(Math.max(place + step[axis], 0), stage.size[axis] - 1)));
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
  files.forget();
  open({ ask: 'open', name: form.scene.value });
});
walkByKeys(stage.canvas, walk);
walkByPointer(stage.canvas, walk, (event) => point(stage.pixelAt(event)));
pointByKeys(stage.canvas);
by('home').addEventListener('click', () => walk.home());
toggle('spin', draw);
toggle('heat', draw);
pick(by('pick'), by('files'), files);
drop(document.body, files);
by('png').addEventListener('click', async () =>
  download(`${scene.name}.png`, await stage.png(), 'image/png'),
);
by('source').addEventListener('click', () =>
  take({ ask: 'source', number: form.number.value }, 'scene.rs', 'text/plain'),
);
by('ron').addEventListener('click', () => download(scene.file, by('text').value, 'text/plain'));

await open({ ask: 'open', name: form.scene.value }, [], address);
