/** Walks by mouse, touch and keys, in whole parts of a step: ways back end on the same bits. */

/** Is where the scene is seen from. */
export class Walk {
  /** Begins at the scene's own camera; `changed` is called after each step. */
  constructor([parts, around, notches], changed) {
    Object.assign(this, { parts, around, notches, changed, reach: [0, 0], right: 0, up: 0, zoom: 0 });
  }

  /** Answers the parts, for the core. */
  get place() {
    return { right: this.right, up: this.up, zoom: this.zoom };
  }

  get isHome() {
    return this.right === 0 && this.up === 0 && this.zoom === 0;
  }

  /** Goes to a place, as far as there is one. */
  go({ right, up, zoom }) {
    const before = JSON.stringify(this.place);
    this.right = ((right % this.around) + this.around) % this.around;
    this.up = Math.min(Math.max(up, this.reach[0]), this.reach[1]);
    this.zoom = Math.min(Math.max(zoom, -this.notches), this.notches);
    if (before !== JSON.stringify(this.place)) this.changed();
  }

  /** Goes so many parts of a step to the right and up, and so many notches closer. */
  by(right, up, zoom = 0) {
    this.go({ right: this.right + right, up: this.up + up, zoom: this.zoom + zoom });
  }

  /** Goes back to the scene's own camera. */
  home() {
    this.go({ right: 0, up: 0, zoom: 0 });
  }
}

/** Lets keys walk: arrows around, + and - closer and back, Home to where the scene begins. */
export function walkByKeys(element, walk) {
  const steps = {
    ArrowLeft: () => walk.by(-walk.parts, 0),
    ArrowRight: () => walk.by(walk.parts, 0),
    ArrowUp: () => walk.by(0, walk.parts),
    ArrowDown: () => walk.by(0, -walk.parts),
    '+': () => walk.by(0, 0, 1),
    '=': () => walk.by(0, 0, 1),
    '-': () => walk.by(0, 0, -1),
    Home: () => walk.home(),
  };
  element.addEventListener('keydown', (event) => {
    const plain = !event.ctrlKey && !event.metaKey && !event.altKey && !event.shiftKey;
    const step = plain || event.key === '+' ? steps[event.key] : undefined;
    if (!step) return;
    event.preventDefault();
    step();
  });
}

/**
 * Lets pointers walk: a drag across the whole height goes half around, two fingers pinch, the wheel zooms where
 * the element has the focus. `clicked` is told of a click that is no drag.
 */
export function walkByPointer(element, walk, clicked) {
  const down = new Map();
  let moved = 0;
  let spread = 0;
  const parts = (pixels) => Math.round((walk.around / 2) * (pixels / element.clientHeight));
  const distance = () => {
    const [a, b] = [...down.values()];
    return Math.hypot(a.x - b.x, a.y - b.y);
  };
  element.addEventListener('pointerdown', (event) => {
    if (event.button !== 0) return;
    element.setPointerCapture(event.pointerId);
    if (down.size === 0) moved = 0;
    down.set(event.pointerId, { x: event.clientX, y: event.clientY });
    if (down.size === 2) spread = distance();
  });
  element.addEventListener('pointermove', (event) => {
    const from = down.get(event.pointerId);
    if (!from) return;
    const [right, below] = [event.clientX - from.x, event.clientY - from.y];
    moved += Math.hypot(right, below);
    down.set(event.pointerId, { x: event.clientX, y: event.clientY });
    if (down.size === 1 && moved > 3) walk.by(-parts(right), parts(below));
    if (down.size !== 2) return;
    moved += 4;
    const notches = Math.trunc(Math.log(distance() / spread) / Math.log(1.1));
    if (notches !== 0) {
      spread = distance();
      walk.by(0, 0, notches);
    }
  });
  element.addEventListener('pointerup', (event) => {
    if (down.delete(event.pointerId) && down.size === 0 && moved <= 3) clicked(event);
  });
  element.addEventListener('pointercancel', (event) => down.delete(event.pointerId));
  element.addEventListener(
    'wheel',
    (event) => {
      if (document.activeElement !== element || event.deltaY === 0) return;
      event.preventDefault();
      walk.by(0, 0, event.deltaY < 0 ? 1 : -1);
    },
    { passive: false },
  );
}
