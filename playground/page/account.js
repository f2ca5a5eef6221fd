/** What a pixel is, and how it comes by its light. */

const KINDS = ['from the eye', 'to lights', 'into mirrors', 'through glass'];

/** Answers rays by kind in words, those that there are none of left out. */
export function rays(counts) {
  const told = counts.map((count, kind) => count && `${count.toLocaleString('en')} ${KINDS[kind]}`);
  return told.filter(Boolean).join(', ');
}

/** Shows a pixel's account in a list of terms. */
export function tell(list, account) {
  const hex = `#${account.shown.map((level) => level.toString(16).padStart(2, '0')).join('')}`;
  const swatch = Object.assign(document.createElement('span'), { className: 'swatch' });
  swatch.style.background = hex;
  const rows = [
    ['Pixel', `${account.at.join(', ')}`],
    ['Shown', swatch, ` ${hex}`],
    ['Bits', code(account.bits)],
    ['Meets', account.met],
    ...(account.words ? [['In words', code(account.words)]] : []),
  ];
  list.replaceChildren(...rows.flatMap(([term, ...what]) => [element('dt', term), element('dd', ...what)]));
}

const HINTS = {
  none: 'Click a pixel of the panel: its rays are told here, one by one.',
  traced:
    'Each ray with what it meets and sends, the numbers beside the reference; ‘off’ is how far they are from it.',
  middle:
    'The picture takes several rays a pixel, or none; told here is the ray through the middle, with what it meets and sends.',
  raster: 'The z-buffer sends no rays. Let the ray tracer draw the picture, and they are told here.',
};

/** Takes away what was told of a pixel. */
export function forget(list, { hint, tree, figures }) {
  list.replaceChildren(element('dd', 'Click one.'));
  hint.textContent = HINTS.none;
  tree.hidden = figures.hidden = true;
}

/** Shows the rays of a pixel, their tree and their figures, or why there are none. */
export function explain({ hint, tree, figures }, { rays }) {
  hint.textContent = rays ? (rays.alone ? HINTS.traced : HINTS.middle) : HINTS.raster;
  tree.hidden = figures.hidden = !rays;
  if (!rays) return;
  const drawing = new DOMParser().parseFromString(rays.tree, 'image/svg+xml').documentElement;
  tree.replaceChildren(document.adoptNode(drawing));
  // Where there is no room for all of it, the ray from the eye is in the middle.
  const eye = [...drawing.querySelectorAll('text')].find(({ textContent }) => textContent === 'R1');
  tree.scrollLeft = (eye?.getAttribute('x') ?? 0) - tree.clientWidth / 2;
  figures.textContent = rays.text;
}

function element(name, ...content) {
  const made = document.createElement(name);
  made.append(...content);
  return made;
}

function code(text) {
  return element('code', text);
}
