/** What a pixel is, in words. */

const KINDS = ['from the eye', 'to lights', 'into mirrors', 'through glass'];

/** Answers rays by kind in words, those that there are none of left out. */
export function rays(counts) {
  const told = counts.map((count, kind) => count && `${count.toLocaleString('en')} ${KINDS[kind]}`);
  return told.filter(Boolean).join(', ');
}

/** Answers lights in words. */
function lights(places) {
  return places.map((place) => `light ${place}`).join(', ') || 'no light directly';
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
    ['Wanted', account.wanted.map((part) => part.toFixed(4)).join(', ')],
    ['Meets', account.met],
    ...(account.words ? [['In words', code(account.words)]] : []),
    ...(account.words ? [['Lit by', lights(account.lit)]] : []),
    ['Rays', rays(account.rays)],
  ];
  list.replaceChildren(...rows.flatMap(([term, ...what]) => [element('dt', term), element('dd', ...what)]));
}

function element(name, ...content) {
  const made = document.createElement(name);
  made.append(...content);
  return made;
}

function code(text) {
  return element('code', text);
}
