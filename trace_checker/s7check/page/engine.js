// The engine in its Worker: questions and answers. Where it fails it is started anew, and the question ends in an Error.

export const utf8 = new TextEncoder();
const LEAST = "this browser has no WebAssembly with garbage collection: use Chromium or Firefox of 2024, or newer";

/** The engine has no answer; the text says why. */
export class NoAnswer extends Error {}

export class Engine {
  #parts;
  #worker = null;
  #asked = new Map();
  #next = 0;

  /**
   * @param parts the runtime with the Worker's text, the engine and the parsed specification, as bytes; the words of its
   *     sentences, an object
   */
  constructor(parts) {
    this.#parts = parts;
    this.onrestart = () => {};
  }

  /** Starts it; resolves when it is ready. */
  start() {
    const source = URL.createObjectURL(new Blob([this.#parts.script], { type: "text/javascript" }));
    this.#worker = new Worker(source);
    this.#worker.onmessage = ({ data }) => this.#take(data);
    this.#worker.onerror = (event) => {
      event.preventDefault();
      this.#fail(event.message || "lack of memory");
    };
    const started = this.#send({ kind: "open", wasm: this.#parts.wasm, tree: this.#parts.tree });
    const told = started.then(() => this.ask({ message: "texts", ...this.#parts.texts }));
    return told.catch((error) => {
      throw new NoAnswer(/CompileError|WebAssembly/.test(error.message) ? LEAST : error.message);
    });
  }

  #send(message, transfer = []) {
    const id = this.#next++;
    return new Promise((resolve, reject) => {
      this.#asked.set(id, { resolve, reject });
      this.#worker.postMessage({ id, ...message }, transfer);
    });
  }

  #take({ id, answers, failed }) {
    const one = this.#asked.get(id);
    if (failed !== undefined) return this.#fail(failed);
    this.#asked.delete(id);
    one?.resolve(answers);
  }

  /** Ends the Worker, and every question that it has not answered; it is started anew. */
  #fail(why) {
    this.#worker.terminate();
    const open = [...this.#asked.values()];
    this.#asked.clear();
    for (const one of open) one.reject(new NoAnswer(why));
    if (this.#next > open.length)
      this.start().then(
        () => this.onrestart(),
        () => {},
      );
  }

  /** Gives up what is at work. */
  stop() {
    this.#fail("it was stopped");
  }

  /** The answer to one message and its bytes, an object. Throws NoAnswer, also for what cannot be used. */
  async ask(message, bytes = "") {
    const [answer] = await this.#messages(`${JSON.stringify(message)}\n`, bytes);
    if (answer.error) throw new NoAnswer(answer.error);
    if (answer.unusable) throw Object.assign(new NoAnswer(unusable(answer.unusable)), { answer });
    return answer;
  }

  /** The answer about a log, bytes in UTF-8. */
  async judge(bytes, begin = {}) {
    const head = `${JSON.stringify({ message: "begin", outcomes: true, ...begin })}\n{"message":"bytes","count":${bytes.length}}\n`;
    const [answer] = await this.#messages(head, bytes, '{"message":"finish"}\n');
    return answer;
  }

  #messages(...parts) {
    const all = parts.map((part) => (typeof part === "string" ? utf8.encode(part) : part));
    const messages = new Uint8Array(all.reduce((sum, part) => sum + part.length, 0));
    let at = 0;
    for (const part of all) {
      messages.set(part, at);
      at += part.length;
    }
    return this.#send({ kind: "ask", messages }, [messages.buffer]);
  }
}

/** What is not of the format, in a sentence. */
export const unusable = ({ place, line, field, expected, found }) =>
  `${place ? `${place}: ` : ""}${line ? `line ${line}: ` : ""}${field ? `field ${field}: ` : ""}expected ${expected}, found ${found}`;
