/** Files of one's own, picked or dropped: a scene and what it names. They stay on this computer. */

/** Are the endings of what can be a scene; one of the former names what is one by the last. */
const [SCENES, MODEL] = [['.ron', '.nff'], '.obj'];

const ends = (ending) => (file) => file.name.toLowerCase().endsWith(ending);

/** Answers the file among some that is the scene, if one is. */
function sceneAmong(files) {
  return [...SCENES, MODEL].map((ending) => files.find(ends(ending))).find(Boolean);
}

/** Answers files with others, which take the place of those of the same name. */
function together(files, others) {
  return [...new Map([...files, ...others].map((file) => [file.name, file])).values()];
}

/** Is the files that somebody has picked. */
export class Files {
  /** `open` is called with the scene's name and all files; it resolves to whether that is open now. */
  constructor(open) {
    Object.assign(this, { open, refused: [] });
  }

  /** Takes files: those of a scene, those that the scene before was lacking, or those before its own. */
  async take(list) {
    const files = [...list];
    if (files.length === 0) return;
    const isAnother = SCENES.some((ending) => files.some(ends(ending)));
    const before = isAnother && sceneAmong(this.refused) ? [] : this.refused;
    if (await this.#isOpen(together(before, files))) return;
    // A model that adds nothing to the scene before may be one of its own.
    if (before.length > 0 && files.some(ends(MODEL))) await this.#isOpen(files);
  }

  /** Forgets files that could not be opened: nothing is lacking any more. */
  forget() {
    this.refused = [];
  }

  async #isOpen(files) {
    const isOpen = await this.open(sceneAmong(files)?.name, files);
    this.refused = isOpen ? [] : files;
    return isOpen;
  }
}

/** Lets a button ask for files. */
export function pick(button, input, files) {
  button.addEventListener('click', () => input.click());
  input.addEventListener('change', async () => {
    await files.take(input.files);
    // The same files may be picked again.
    input.value = '';
  });
}

/** Lets files be dropped anywhere on the page. */
export function drop(page, files) {
  const isOfFiles = (event) => event.dataTransfer.types.includes('Files');
  page.addEventListener('dragover', (event) => {
    if (!isOfFiles(event)) return;
    event.preventDefault();
    page.classList.add('dropping');
  });
  page.addEventListener('dragleave', (event) => {
    // From one part of the page to another is not away from it.
    if (!event.relatedTarget) page.classList.remove('dropping');
  });
  page.addEventListener('drop', (event) => {
    page.classList.remove('dropping');
    if (!isOfFiles(event)) return;
    event.preventDefault();
    files.take(event.dataTransfer.files);
  });
}
