/** Files of one's own, picked or dropped: a scene and what it names. They stay on this computer. */

/** Are the endings of what can be a scene; one of the former names what is one by the last. */
const [SCENES, MODEL] = [['.ron', '.nff'], '.obj'];

const ends = (ending) => (file) => file.name.toLowerCase().endsWith(ending);

/** Answers the file among some that is the scene, if one is. */
function sceneAmong(files) {
  return [...SCENES, MODEL].map((ending) => files.find(ends(ending))).find(Boolean);
}

/** Is the files that somebody has picked. */
export class Files {
  /** `open` is called with the scene's name and all files; it resolves to whether that is open now. */
  constructor(open) {
    Object.assign(this, { open, picked: new Map(), isLacking: false });
  }

  /** Takes files: those of a scene, or those that the scene before was lacking. */
  async take(list) {
    const files = [...list];
    if (files.length === 0) return;
    const isAnother = SCENES.some((ending) => files.some(ends(ending)));
    if (isAnother || !this.isLacking) this.picked.clear();
    for (const file of files) this.picked.set(file.name, file);
    const all = [...this.picked.values()];
    this.isLacking = !(await this.open(sceneAmong(all)?.name, all));
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
