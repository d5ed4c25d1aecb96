// The behaviour that is built, without the page: branches, undo, and the link that contains it all.
// Nothing here knows a rule of the CPU: what may come is asked of the server.

/** A branch: the objects of a log's lines. `shown` lines are looked at; those behind them are kept. */
export const branch = (name, header, lines, shown = lines.length) => ({ name, header, lines, shown });

/** All branches, with undo and redo. A change makes a new document; old ones are never changed. */
export class Model {
  constructor(document) {
    this.past = [];
    this.future = [];
    this.document = document;
  }

  get branch() {
    return this.document.branches[this.document.current];
  }

  change(document) {
    this.past.push(this.document);
    this.future = [];
    this.document = document;
  }

  undo() {
    if (!this.past.length) return false;
    this.future.push(this.document);
    this.document = this.past.pop();
    return true;
  }

  redo() {
    if (!this.future.length) return false;
    this.past.push(this.document);
    this.document = this.future.pop();
    return true;
  }

  #with(changed) {
    const branches = this.document.branches.map((one, i) => (i === this.document.current ? changed : one));
    this.change({ ...this.document, branches });
  }

  /** Adds a line behind the shown ones. Where others follow, a new branch goes on. */
  add(line) {
    const one = this.branch;
    const lines = [...one.lines.slice(0, one.shown), line];
    if (one.shown < one.lines.length) this.fork(lines);
    else this.#with(branch(one.name, one.header, lines));
  }

  fork(lines = this.branch.lines.slice(0, this.branch.shown)) {
    const one = this.branch;
    const name = `${one.name.replace(/ \(\d+\)$/, "")} (${this.document.branches.length + 1})`;
    const branches = [...this.document.branches, branch(name, one.header, lines)];
    this.change({ ...this.document, branches, current: branches.length - 1 });
  }

  /** Shows the lines up to a number, 0 for the header alone. */
  show(number) {
    const one = this.branch;
    this.#with({ ...one, shown: Math.max(0, Math.min(number, one.lines.length)) });
  }

  /** Puts lines in the place of one line (none: takes it out); `index` counts from 0. */
  replace(index, ...lines) {
    const one = this.branch;
    const all = [...one.lines.slice(0, index), ...lines, ...one.lines.slice(index + 1)];
    this.#with(branch(one.name, one.header, all));
  }

  choose(current) {
    this.change({ ...this.document, current });
  }

  drop(index) {
    const branches = this.document.branches.filter((_, i) => i !== index);
    this.change({ ...this.document, branches, current: Math.min(this.document.current, branches.length - 1) });
  }
}

export const ndjson = (one) => [one.header, ...one.lines].map((line) => JSON.stringify(line) + "\n").join("");

/** A log's text as a branch; an Error names the line that is no JSON object. */
export function fromText(name, text) {
  const objects = [];
  text.replace(/^\uFEFF/, "").split("\n").forEach((line, i) => {
    if (!line.trim()) return;
    try {
      objects.push(JSON.parse(line));
    } catch {
      throw new Error(`${name}:${i + 1}: expected a JSON object`);
    }
  });
  if (!objects.length) throw new Error(`${name}:1: expected a header, found an empty file`);
  return branch(name, objects[0], objects.slice(1));
}

/** A text that is one program of the kit, as an object; null for any other text. */
export function asProgram(text) {
  try {
    const found = JSON.parse(text);
    return String(found?.format).startsWith("s7-interrupt-program/") ? found : null;
  } catch {
    return null;
  }
}

const through = async (bytes, stream) =>
  new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer());

/** The document as a text for an address: deflated, in the letters of base64url. */
export async function toLink(document) {
  const bytes = await through(new TextEncoder().encode(JSON.stringify(document)), new CompressionStream("deflate-raw"));
  const text = btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(""));
  return text.replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
}

export async function fromLink(text) {
  const bytes = Uint8Array.from(atob(text.replaceAll("-", "+").replaceAll("_", "/")), (c) => c.charCodeAt(0));
  return JSON.parse(new TextDecoder().decode(await through(bytes, new DecompressionStream("deflate-raw"))));
}
