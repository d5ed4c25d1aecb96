// The timeline: a button for each line, and below it what runs and waits; only what is in view is drawn.
import { $, h, numberOf } from "./elements.js";

const USUAL = 116;
let column = USUAL; // the width of a line
const HEAD = 70;
const LANE = 58;
const STRIP = 20;
const SPARE = 4;
const REPORTED = 80; // lines of a report

const s = (tag, attributes, text) => {
  const made = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  if (text) made.append(text);
  return made;
};

/** Number, time and words of a line. */
function head(line, number) {
  const time = String(line.at ?? line.clock ?? "")
    .replace(/^DT#/, "")
    .slice(11);
  const name = line.event ?? line.cpu;
  const of = line.ob === undefined ? "" : /[A-Z]/.test(name) ? ` ${line.ob}` : ` OB ${line.ob}`;
  const answer = "ret" in line ? (line.ret === null ? "not logged" : `= ${hex(line.ret)}`) : "";
  return [number, time, name + of, answer || line.to || line.type || line.cause || line.info?.flt_id || ""].join("\n");
}

const hex = (value) =>
  typeof value === "number"
    ? (value & 0xffff).toString(16).toUpperCase().padStart(4, "0")
    : String(value).split("#").pop();
const ofError = (line) => parseInt(hex(line.ret), 16) >= 0x8000;

/** Stretches of equal values: [value, first, count]. */
function runs(states, value) {
  const found = [];
  states.forEach((state, i) => {
    const now = state ? value(state) : "";
    const last = found.at(-1);
    if (last && last[0] === now && last[1] + last[2] === i) last[2]++;
    else if (now) found.push([now, i, 1]);
  });
  return found;
}

const hexByte = (value) => (value & 0xff).toString(16).toUpperCase().padStart(2, "0");

/** The lanes of the lines in view; `states` are the situations after them, `before` that before the rejected line. */
function lanes(states, lines, wrong, before) {
  const all = [...states, before].filter(Boolean);
  const classes = [
    ...new Set([1, ...all.flatMap((one) => [...one.running, ...one.pending].map((frame) => frame.class))]),
  ].sort((a, b) => b - a);
  const strips = [
    "mode",
    ...(all.some((one) => one.delay) ? ["delayed"] : []),
    ...(all.some((one) => one.blocked.length) ? ["blocked"] : []),
  ];
  const classOf = new Map(
    all.flatMap((one) => [...one.running, ...one.pending].map((frame) => [frame.ob, frame.class])),
  );
  const lane = (ob) => classOf.get(ob) ?? 1;
  const top = HEAD + strips.length * STRIP + 8;
  const height = top + classes.length * LANE + 8;
  const svg = s("svg", { width: states.length * column, height, "aria-hidden": "true" });
  const y = (number) => top + classes.indexOf(number) * LANE;
  const box = (x, at, count, tall, name, text, style) => {
    const rect = s("rect", { x, y: at, width: count * column, height: tall, rx: 3, class: name });
    svg.append(
      rect,
      s("text", { x: x + 5, y: at + tall - 5, class: style }, text.slice(0, Math.floor((count * column) / 7))),
    );
  };
  classes.forEach((number, i) => {
    svg.append(
      s("rect", {
        x: 0,
        y: y(number),
        width: states.length * column,
        height: LANE,
        class: `lane ${i % 2 ? "even" : "odd"}`,
      }),
    );
    svg.append(s("text", { x: 4, y: y(number) + 54, class: "label small" }, `class ${number}`));
  });
  lines.forEach((line, i) => {
    if (line.event === "clock") svg.append(s("rect", { x: i * column, y: 0, width: column, height, class: "jump" }));
  });
  const strip = (name, value, style) => {
    for (const [text, first, count] of runs(states, value))
      box(first * column, HEAD + strips.indexOf(name) * STRIP, count, STRIP - 4, `${style} ${text}`, text, "on");
  };
  strip("mode", (one) => one.mode, "mode");
  if (strips.includes("delayed")) strip("delayed", (one) => (one.delay ? `delay count ${one.delay}` : ""), "delay");
  if (strips.includes("blocked"))
    strip("blocked", (one) => (one.blocked.length ? `blocked OB ${one.blocked.join(" ")}` : ""), "block");
  for (const ob of new Set(all.flatMap((one) => one.running.map((frame) => frame.ob)))) {
    const number = lane(ob);
    const how = (one) =>
      one.running.at(-1)?.ob === ob ? "runs" : one.running.some((frame) => frame.ob === ob) ? "interrupted" : "";
    for (const [style, first, count] of runs(states, how))
      box(first * column, y(number) + 6, count, 20, style, `OB ${ob}`, style === "runs" ? "on" : "in");
  }
  for (const number of classes) {
    const waits = (one) =>
      one.pending
        .filter((request) => request.class === number)
        .map(
          (request) =>
            `OB ${request.ob} ${request.open ? "may be " : ""}pending${request.fault > 0 ? ` fault ${hexByte(request.fault)}` : ""}`,
        )
        .join(", ");
    for (const [text, first, count] of runs(states, waits))
      box(first * column, y(number) + 29, count, 13, "waiting", text, "small");
  }
  lines.forEach((line, i) => {
    const running = (states[i - 1] ?? states[i])?.running.at(-1);
    if (running && "ret" in line)
      svg.append(
        s("circle", {
          cx: i * column + 5,
          cy: y(running.class) + 16,
          r: 5,
          class: `call ${ofError(line) ? "error" : "fine"}`,
        }),
      );
  });
  lines.forEach((line, i) => {
    const lost = comeToNothing(line, states[i - 1], states[i]);
    for (const number of new Set(lost.map(({ ob }) => lane(ob)))) {
      const text = lost
        .filter(({ ob }) => lane(ob) === number)
        .map(({ why }) => why)
        .join(", ");
      const [x, at] = [i * column, y(number) + 49];
      svg.append(s("path", { d: `M${x - 4} ${at - 4}l8 8m0 -8l-8 8`, class: "lost" }));
      svg.append(s("text", { x: x + 8, y: at + 4, class: "small nothing" }, text.slice(0, Math.floor(column / 6))));
    }
  });
  for (const request of (before?.pending ?? []).filter(({ ready, missing }) => ready && !missing))
    box(wrong * column, y(request.class) + 6, 1, 20, "ghost", `OB ${request.ob} due`, "due");
  return { svg, height };
}

/** OBs whose start events neither wait nor have started after the line, and the words for it. */
function comeToNothing(line, before, after) {
  if (!before || !after) return [];
  const kept = new Set([...after.pending, ...after.running].map(({ ob }) => ob));
  const lost = new Set(before.pending.filter(({ ob, open }) => !open && !kept.has(ob)).map(({ ob }) => ob));
  const none =
    line.event === "interrupt" && !kept.has(line.ob) ? [{ ob: line.ob, why: `OB ${line.ob}: no effect` }] : [];
  return [...Array.from(lost, (ob) => ({ ob, why: `OB ${ob} gone` })), ...none];
}

/** Makes the lines of all timelines wider by a factor. */
export function zoom(factor) {
  column = Math.max(USUAL / 3, Math.min(USUAL * 3, column * factor));
  document.body.style.setProperty("--column", `${column}px`);
}

/** A timeline in `box`. `states(first, last)` gives the situations after these lines; `choose` is told a chosen one. */
export class Timeline {
  constructor(box, states, choose) {
    Object.assign(this, { box, states, choose, wide: h("div", { className: "wide" }), drawn: 0 });
    box.replaceChildren(this.wide);
    box.addEventListener("scroll", () => requestAnimationFrame(() => this.draw()), { passive: true });
    box.addEventListener("keydown", (key) => {
      const step = { ArrowLeft: -1, ArrowRight: 1 }[key.key];
      const from = Number(key.target.dataset?.index);
      if (!step || Number.isNaN(from)) return;
      key.preventDefault();
      key.stopPropagation();
      this.moved = Math.max(0, Math.min(this.texts.length - 1, from + step));
      this.choose(this.moved);
    });
  }

  /**
   * Shows these lines, texts, of which `current` is chosen; `explained` have a situation, `wrong` is rejected, and
   * `before` is the situation before it.
   */
  show(texts, current, explained, wrong, numbers, before) {
    Object.assign(this, { texts, current, explained, wrong, numbers, before });
    this.wide.style.width = `${texts.length * column}px`;
    const left = current * column;
    if (left < this.box.scrollLeft || left + column > this.box.scrollLeft + this.box.clientWidth) {
      this.box.scrollLeft = Math.max(0, left - this.box.clientWidth + 2 * column);
    }
    return this.draw();
  }

  async draw() {
    if (!this.texts) return;
    const number = ++this.drawn;
    const first = Math.max(0, Math.floor(this.box.scrollLeft / column) - SPARE);
    const end = Math.min(this.texts.length, first + Math.ceil(this.box.clientWidth / column) + 2 * SPARE);
    const made = await this.picture(first, end);
    if (number !== this.drawn) return;
    const focused = document.activeElement?.dataset?.index;
    const inside = this.box.contains(document.activeElement);
    this.wide.style.height = `${made.height}px`;
    this.wide.replaceChildren(made.svg, ...made.buttons);
    if (inside)
      made.buttons.find((one) => one.dataset.index === String(this.moved ?? focused))?.focus({ preventScroll: true });
    this.moved = undefined;
  }

  /** The lines that a report shows, nodes that no longer change. */
  async still() {
    const end = Math.min(this.texts.length, (this.wrong < 0 ? this.current : this.wrong) + 3);
    const first = Math.max(0, end - REPORTED);
    const { svg, buttons, height } = await this.picture(first, end);
    const style = `position:relative;height:${height}px;width:${end * column}px;margin-left:${-first * column}px`;
    const lines = h("div", { style }, svg, ...buttons);
    return [
      h("h2", {}, `Lines ${first + 1} to ${end} of ${this.texts.length}`),
      h("div", { className: "scroll timeline" }, lines),
      $("marks").cloneNode(true),
    ];
  }

  /** The lines from `first` up to `end`, a button each, above what runs and waits. */
  async picture(first, end) {
    const last = Math.min(end - 1, this.explained);
    const states = first > last ? [] : await this.states(first, last);
    const lines = this.texts.slice(first, end).map((text) => read(text));
    const buttons = lines.map((line, i) => {
      const index = first + i;
      const style = index === this.wrong ? "wrong" : index === this.current ? "current" : "";
      return h(
        "button",
        {
          type: "button",
          className: style,
          style: `left:${index * column}px`,
          "data-index": index,
          tabIndex: index === this.current ? 0 : -1,
          "aria-current": String(index === this.current),
          onclick: () => this.choose(index),
        },
        head(line, numberOf(this.numbers, index)),
      );
    });
    const { svg, height } = lanes(
      Array.from(lines, (_, i) => states[i] ?? null),
      lines,
      this.wrong - first,
      this.wrong >= first && this.wrong < end ? this.before : null,
    );
    svg.style.left = `${first * column}px`;
    return { svg, buttons, height };
  }
}

/** A line's object; a line that is none has its text as event. */
export function read(text) {
  try {
    const line = JSON.parse(text);
    return line && typeof line === "object" ? line : { event: String(text) };
  } catch {
    return { event: text };
  }
}
