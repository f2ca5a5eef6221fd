/** The controls: what decides a picture, as a form has it. */

const HINTS = {
  exact: 'exact: every pixel',
  adaptive: 'adaptive: pixels between like ones are filled in',
  uniform: 'uniform: N × N rays a pixel',
  jittered: 'jittered: N × N scattered rays',
  'at-edges': 'at edges: N × N there only',
  'at-edges-jittered': 'at edges, jittered',
};

const APPROACHES = { trace: 'ray tracer', raster: 'z-buffer: no shadows, no mirrors' };

/** Is what numbers are called. */
export const NUMBERS = { f32: 'f32', fixed: 'fixed point', exact: 'f64', oracle: 'the reference' };

/** Fills the form with what there is to choose from. */
export function fill(form, choices) {
  const options = (select, words, hints = {}) =>
    select.replaceChildren(...words.map((word) => new Option(hints[word] ?? word, word)));
  options(form.scene, choices.scenes);
  options(form.approach, choices.approaches, APPROACHES);
  options(form.panel, choices.panels);
  options(form.quality, choices.qualities, HINTS);
  options(form.dither, choices.dithers);
  form.columns.max = form.rows.max = choices.most_pixels;
  form.depth.max = choices.most_depth;
  form.side.max = choices.most_rays;
}

/** Sets what a scene says of its picture. */
export function take(form, { size, depth, dither }) {
  [form.columns.value, form.rows.value] = size;
  form.depth.value = depth;
  form.dither.value = dither;
}

/** Shows the name of a scene that is none of the gallery, or takes it away. */
export function name(select, name) {
  select.querySelector('[value=""]')?.remove();
  if (!name) return;
  select.prepend(new Option(`${name} (yours)`, ''));
  select.value = '';
}

/** Tells whether two scenes say the same of their pictures. */
export function areAlike(one, other) {
  const said = ({ size, depth, dither }) => JSON.stringify([size, depth, dither]);
  return said(one) === said(other);
}

/** Answers what decides the picture, in the core's words. */
export function look(form, walk) {
  const { number, approach, panel, quality, dither } = form;
  // There is one reference for both approaches.
  const isRaster = approach.value === 'raster' && number.value !== 'oracle';
  quality.disabled = form.depth.disabled = isRaster;
  form.side.disabled = isRaster || ['exact', 'adaptive'].includes(quality.value);
  return {
    ...{ number: number.value, approach: approach.value, panel: panel.value },
    ...{ quality: quality.value, dither: dither.value },
    size: [whole(form.columns), whole(form.rows)],
    depth: whole(form.depth),
    side: whole(form.side),
    walk: walk.place,
  };
}

/** Answers the whole number of a field, within its ends. */
function whole(field) {
  const number = Math.trunc(Number(field.value)) || 0;
  return Math.min(Math.max(number, Number(field.min)), Number(field.max));
}

/** Writes what was chosen into the page's address, so that it can be kept and sent. */
export function keep(form, walk) {
  const words = new URLSearchParams(new FormData(form));
  // Files of this computer are not in an address.
  if (!words.get('scene')) words.delete('scene');
  if (!walk.isHome) words.set('walk', Object.values(walk.place).join(' '));
  history.replaceState(null, '', `#${words}`);
}

/** Is what an address says that says nothing. */
export const NOTHING = { words: {}, place: { right: 0, up: 0, zoom: 0 } };

/** Answers what the page's address says. */
export function kept() {
  const words = Object.fromEntries(new URLSearchParams(location.hash.slice(1)));
  const whole = (part) => (Number.isSafeInteger(Number(part)) ? Number(part) : 0);
  const [right, up, zoom] = `${words.walk ?? ''} 0 0 0`.trim().split(/\s+/).map(whole);
  return { words, place: { right, up, zoom } };
}

/** Sets the fields that the page's address names; what there is not to choose stays as it was. */
export function restore(form, words) {
  for (const [name, word] of Object.entries(words)) {
    const field = form.elements[name];
    // A form has other elements than those that are named so, such as its length.
    if (!(field instanceof Element || field instanceof RadioNodeList)) continue;
    const before = field.value;
    field.value = word;
    if (field.value === '') field.value = before;
  }
}
