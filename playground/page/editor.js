/** The scene as text: drawn again when the writer pauses. */

/** Is how long a writer pauses who wants to see the picture, in milliseconds. */
const PAUSE = 350;

export class Editor {
  /** `write` is called with a text that has changed. */
  constructor(area, write) {
    Object.assign(this, { area, write, timer: 0 });
    area.addEventListener('input', () => this.later());
    area.addEventListener('keydown', (event) => {
      if (event.key === 'Enter' && (event.ctrlKey || event.metaKey)) this.now();
    });
  }

  /** Shows the text of a scene that was opened. */
  show(text) {
    clearTimeout(this.timer);
    this.area.value = text;
  }

  /** Drops what was typed and is not drawn yet: another scene is on its way. */
  forget() {
    clearTimeout(this.timer);
  }

  later() {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.now(), PAUSE);
  }

  now() {
    clearTimeout(this.timer);
    this.write(this.area.value);
  }
}
