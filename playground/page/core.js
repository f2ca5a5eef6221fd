/** The core's door: requests and answers in JSON, pixels beside them. */

/** Fetches and compiles the core; any file server will do, whatever type it names. */
export async function compile(address) {
  const response = await fetch(address);
  if (!response.ok) throw new Error(`${address} is not there: ${response.status} ${response.statusText}`);
  return WebAssembly.compile(await response.arrayBuffer());
}

/** Is a core with a memory of its own. */
export class Core {
  /** Starts a core of a compiled module. */
  static async start(module) {
    return new Core((await WebAssembly.instantiate(module)).exports);
  }

  constructor(door) {
    this.door = door;
  }

  /** Does a request and answers what it is told, `{ kind: what }`. */
  ask(request) {
    const text = new TextEncoder().encode(JSON.stringify(request));
    // Memory grows with what is asked: its buffer is looked up after each call.
    const room = this.door.scanray_room(text.length);
    new Uint8Array(this.door.memory.buffer, room, text.length).set(text);
    const length = this.door.scanray_ask();
    const answer = new Uint8Array(this.door.memory.buffer, this.door.scanray_answer(), length);
    return JSON.parse(new TextDecoder().decode(answer));
  }

  /** Hands over a file, for scenes that name it; answers what is told of it. */
  take(name, bytes) {
    const room = this.door.scanray_room(bytes.length);
    new Uint8Array(this.door.memory.buffer, room, bytes.length).set(bytes);
    this.door.scanray_hand();
    return this.ask({ ask: 'take', name });
  }

  /** Copies the pixels of the last picture. */
  pixels([columns, rows]) {
    return new Uint8ClampedArray(
      this.door.memory.buffer,
      this.door.scanray_pixels(),
      4 * columns * rows,
    ).slice();
  }
}
