// The log of the page in the engine: its lines go there once, and what differs later.
import { NoAnswer } from "./engine.js";

const AT_ONCE = 5000;
const OURS = "shown";

/** Answers questions about a log, which the caller gives with each of them. */
export class Desk {
  #engine;
  #turn = Promise.resolve();
  #sent = new Map(); // the logs of the engine's sessions

  constructor(engine) {
    this.#engine = engine;
    engine.onrestart = () => this.#sent.clear();
    this.progress = () => {};
  }

  /**
   * Has the engine know the lines, as far as they are possible.
   * @returns how many are, and the refusal of the next one or null
   */
  bring(log, session = OURS, chosen = undefined) {
    // One at a time: each looks at what the one before has sent.
    const done = this.#turn.then(() => this.#bring(log, session, chosen));
    this.#turn = done.catch(() => {});
    return done;
  }

  async #bring({ header, lines }, session, chosen) {
    const key = JSON.stringify([header, chosen]);
    let known = this.#sent.get(session);
    if (known?.key !== key) {
      this.#sent.delete(session);
      await this.#engine.ask({ message: "open", session, header, ...(chosen ? { chosen } : {}) });
      known = { key, lines: [], tried: [], stopped: null };
      this.#sent.set(session, known);
    }
    let same = 0;
    while (same < lines.length && same < known.tried.length && lines[same] === known.tried[same]) same++;
    if (known.stopped && same > known.lines.length) return { explained: known.lines.length, refused: known.stopped };
    if (same < known.lines.length) await this.#engine.ask({ message: "back", session, lines: same });
    known.lines = lines.slice(0, Math.min(same, known.lines.length));
    known.stopped = null;
    for (let at = known.lines.length; at < lines.length && !known.stopped; at += AT_ONCE) {
      this.progress(at, lines.length);
      known.stopped = await this.#add(session, known, lines.slice(at, at + AT_ONCE));
    }
    known.tried = lines.slice(0, known.lines.length + (known.stopped ? 1 : 0));
    return { explained: known.lines.length, refused: known.stopped };
  }

  async #add(session, known, lines) {
    try {
      const answer = await this.#engine.ask({ message: "add", session, lines });
      known.lines = known.lines.concat(lines.slice(0, answer.lines - known.lines.length));
      return answer.refusal ?? null;
    } catch (error) {
      if (!error.answer) throw error;
      known.lines = known.lines.concat(lines.slice(0, error.answer.lines - known.lines.length));
      return { unusable: true, message: error.message };
    }
  }

  /** What is shown after the lines; of what may come all, or the events `only`. */
  async look(after, at, only = []) {
    return (await this.#engine.ask({ message: "look", session: OURS, after, only, ...(at ? { at } : {}) })).look;
  }

  /** The lines of these events that may come, of a call one, and whether these are the whole. */
  events(after, at, only) {
    return this.#engine.ask({ message: "lines", session: OURS, after, at, only, few: true });
  }

  /** What may not come; null if that is not known. */
  async impossible(after, at) {
    return (await this.#engine.ask({ message: "impossible", session: OURS, after, at })).impossible;
  }

  async states(after, to, session = OURS) {
    return (await this.#engine.ask({ message: "states", session, after, to })).states;
  }

  /** The open questions by which the explanations of the first lines differ: {name, explanations} by letters. */
  async questions({ header, lines }, after) {
    return (await this.#engine.ask({ message: "questions", header, lines: lines.slice(0, after) })).questions;
  }

  /** Ends the sessions that have none of these names. */
  async keep(names) {
    for (const session of this.#sent.keys()) {
      if (session === OURS || names.includes(session)) continue;
      this.#sent.delete(session);
      await this.#engine.ask({ message: "close", session });
    }
  }

  /** Fields of the program of a log, a text. Throws NoAnswer where the log cannot be used. */
  async program(text) {
    const bytes = new TextEncoder().encode(text);
    return (await this.#engine.ask({ message: "program of", count: bytes.length }, bytes)).object;
  }

  async call(after, at, event) {
    return (await this.#engine.ask({ message: "lines", session: OURS, after, at, only: [event] })).lines;
  }

  async answers(after, line) {
    const whole = JSON.stringify({ ...line, ret: null });
    return (await this.#engine.ask({ message: "lines", session: OURS, after, at: line.at, lines: [whole] })).lines;
  }

  async why(after, line) {
    return (
      (await this.#engine.ask({ message: "why", session: OURS, after, line: JSON.stringify(line) })).refusal ?? null
    );
  }

  /** The differences under another header: the first line that is not possible there, or the other events at a time. */
  async compare(log, after, at, chosen) {
    const lines = log.lines.slice(0, after);
    await this.bring(log);
    const session = JSON.stringify(chosen);
    const { explained, refused } = await this.bring({ header: log.header, lines }, session, chosen);
    if (refused) return { explained, refused };
    const texts = async (name) => {
      const { look } = await this.#engine.ask({ message: "look", session: name, after, at });
      return new Set(look.possible.map((line) => line.text));
    };
    const [here, there] = [await texts(OURS), await texts(session)];
    const without = (some, others) => [...some].filter((one) => !others.has(one)).sort();
    return { explained, refused: null, onlyHere: without(here, there), onlyThere: without(there, here) };
  }
}

export { NoAnswer };
