// The behaviour that is built, without the page: branches, undo, and the link that contains it all.
// Nothing here knows a rule of the CPU: what may come is asked of the engine.

/** A branch: header and lines of a log, as texts. `shown` lines are looked at; those behind them are kept. */
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
    else this.#with({ ...one, lines, shown: lines.length });
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

  /** A new branch with the same lines under a header that `change` makes of its text. */
  under(name, change) {
    const one = this.branch;
    const branches = [...this.document.branches, { ...one, name: `${one.name}, ${name}`, header: change(one.header) }];
    this.change({ ...this.document, branches, current: branches.length - 1 });
  }

  /**
   * Shows a line: that with a number in the log's text, else the next one, round the end, whose text has the wanted one,
   * such as a time. False if there is none.
   */
  find(wanted) {
    const one = this.branch;
    const all = [one.header, ...one.lines];
    const number = /^\d+$/.test(wanted) ? Number(wanted) : null;
    const places = all.map((_, i) => (one.shown + 1 + i) % all.length);
    const found =
      number === null
        ? places.find((i) => all[i].toLowerCase().includes(wanted.toLowerCase()))
        : all.findIndex((_, i) => (one.numbers?.[i] ?? i + 1) === number);
    if (found === undefined || found < 0) return false;
    this.show(found);
    return true;
  }

  /** Another branch, with so many lines shown if that is said. */
  choose(current, shown = this.document.branches[current].shown) {
    const branches = this.document.branches.map((one, i) => (i === current ? { ...one, shown } : one));
    this.change({ ...this.document, branches, current });
  }

  drop(index) {
    const branches = this.document.branches.filter((_, i) => i !== index);
    this.change({ ...this.document, branches, current: Math.min(this.document.current, branches.length - 1) });
  }
}

export const ndjson = (one) => [one.header, ...one.lines].map((line) => `${line}\n`).join("");

/** A program of the kit laid out: a line for each field, and for each event from outside and body. */
export function layOut(program) {
  const fields = Object.entries(program).map(([name, value]) => {
    const rows = Array.isArray(value) && typeof value[0] === "object" ? value.map((one) => JSON.stringify(one)) : null;
    return ` ${JSON.stringify(name)}: ${rows ? `[\n  ${rows.join(",\n  ")}]` : JSON.stringify(value)}`;
  });
  return `{\n${fields.join(",\n")}\n}\n`;
}

/**
 * A log's text as a branch. Lines stay texts, so that numbers keep their spelling; `numbers` are their places in the
 * text, which may have empty lines.
 */
export function fromText(name, text) {
  const lines = [];
  const numbers = [];
  text
    .replace(/^\uFEFF/, "")
    .split("\n")
    .forEach((line, i) => {
      if (line.trim()) {
        lines.push(line.trim());
        numbers.push(i + 1);
      }
    });
  if (!lines.length) throw new Error(`${name}: expected a log, whose first line is a header; found an empty text`);
  return { ...branch(name, lines[0], lines.slice(1)), numbers };
}

const through = async (bytes, stream) =>
  new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer());

const base64 = (bytes) => btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(""));

/** The document as a text for an address: deflated, in the letters of base64url. */
export async function toLink(document) {
  const bytes = await through(new TextEncoder().encode(JSON.stringify(document)), new CompressionStream("deflate-raw"));
  return base64(bytes).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
}

/** The document in the text of an address. Throws an Error that says so if there is none. */
export async function fromLink(text) {
  try {
    return await opened(text);
  } catch {
    throw new Error("The link is damaged or incomplete: copy it whole, or open the log itself.");
  }
}

/** Bytes that gzip has packed in one piece. Throws an Error for others. */
export const unzipped = (bytes) => through(bytes, new DecompressionStream("gzip"));

/** The same behind a text in base64. */
export const inflated = (text) => unzipped(Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0)));

async function opened(text) {
  const bytes = Uint8Array.from(atob(text.replaceAll("-", "+").replaceAll("_", "/")), (c) => c.charCodeAt(0));
  return JSON.parse(new TextDecoder().decode(await through(bytes, new DecompressionStream("deflate-raw"))));
}
