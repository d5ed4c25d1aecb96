// What may come, when, and what may not: each line with a button that adds it.
import { $, h } from "./elements.js";
import { whyNot } from "./report.js";
import { button, fields, page, requirements, safely, step } from "./shown.js";
import { read } from "./timeline.js";

/** Steps of the CPU, which are shown before all other lines that may come. */
export const OF_THE_CPU = ["start", "end", "run", "stop", "diag"];
const MANY = 6;
const isCall = (name) => name === name.toUpperCase();
const operandsOf = ({ event }) => Object.keys(event).filter((name) => !["event", "ret", "status"].includes(name));

/** Shows what may come: all, or the steps of the CPU alone, while the others are looked for. */
export function showPossible() {
  const { all } = page.view;
  if (!all) showTime();
  const here = page.view.look.possible;
  const names = [...new Set(here.map((line) => line.event.event))];
  const calls = names.filter(isCall);
  const world = names.filter((name) => !OF_THE_CPU.includes(name) && !isCall(name));
  const groups = [
    ["The CPU", OF_THE_CPU.flatMap((name) => acts(name, here))],
    ["The program", calls.map((name) => call(name, here))],
    ["The world", world.flatMap((name) => acts(name, here))],
  ];
  keepFocus(
    $("possible"),
    groups.flatMap(([title, found]) => (found.length ? [h("h3", {}, title), ...found] : [])),
    !all,
  );
  if (!all) return $("possible").append(h("p", {}, "…"));
  if (!here.length) $("possible").append(h("p", {}, "Nothing may come at this time: something had to come before."));
  if (!page.view.look.whole)
    $("possible").prepend(h("p", {}, "The log can be explained in very many ways; more than this may come."));
}

/**
 * Puts other elements in a part of the page; the button with the same text has the focus again, else the part's first.
 * While `more` elements are to come the part has it.
 */
function keepFocus(box, made, more = false) {
  const focused = document.activeElement;
  const inside = box.contains(focused);
  const wanted = focused === box ? box.wanted : focused.textContent;
  box.replaceChildren(...made);
  if (!inside) return;
  const buttons = [...box.querySelectorAll("button, summary")];
  const found = buttons.find((one) => one.textContent === wanted);
  box.wanted = wanted;
  (found ?? (more ? box : (buttons[0] ?? box))).focus({ preventScroll: true });
}

/** The lines of one kind: a button each, or a list of OBs where there are many. */
function acts(name, here) {
  const lines = here.filter((line) => line.event.event === name);
  if (lines.length <= MANY) return lines.map(offer);
  const choice = h(
    "select",
    { "aria-label": `${name}: which` },
    ...lines.map((line, i) => h("option", { value: i }, fields(line.event))),
  );
  const add = button(name, () => take(lines[choice.value].event), { className: "choice" });
  return [h("p", { className: "offer" }, add, " ", choice, requirements(lines[0].requirements))];
}

/** A possible line: a button that adds it. */
const offer = (line) =>
  h(
    "p",
    { className: "offer" },
    button(line.text, () => take(line.event), { className: "choice" }),
    requirements(line.requirements),
  );

const take = (event) =>
  step(() => page.model.add(JSON.stringify({ event: event.event, at: page.view.look.at, ...event })));

/**
 * The form of a call: its operands with some values, and a button for each answer that the CPU may give. It begins with
 * a call that the CPU takes, of a loaded OB, where there is one.
 */
function call(name, here) {
  const some = here.filter((line) => line.event.event === name);
  const operands = operandsOf(some[0]);
  if (!operands.length) return h("div", {}, ...some.map(offer));
  const box = h("details", { className: "call" }, h("summary", {}, name));
  const answers = h("div", { className: "answers" });
  const {
    after,
    look: { at },
  } = page.view;
  const inputs = operands.map((operand) =>
    h("input", { name: operand, size: operand === "sdt" ? 17 : 10, onfocus: ({ target }) => target.select() }),
  );
  let asked = 0;
  const show = async () => {
    const number = ++asked;
    answers.replaceChildren("…"); // the buttons of other operands are gone at once
    const event = { event: name, at };
    for (const input of inputs) event[input.name] = meant(input.value);
    const made = await page.desk.answers(after, event).then(
      (lines) => (lines.length ? lines.map(offer) : ["not possible now"]),
      (error) => [error.message],
    );
    if (number === asked) answers.replaceChildren(...made);
  };
  box.addEventListener(
    "toggle",
    safely(async () => {
      if (!box.open || inputs[0].list) return;
      const lines = await page.desk.call(after, at, name);
      const first = begun(lines);
      for (const input of inputs) {
        const list = h("datalist", { id: `${name}-${input.name}` });
        const values = [...new Set(lines.map((line) => String(line.event[input.name])))];
        list.append(...values.map((value) => h("option", { value })));
        box.append(list);
        input.setAttribute("list", list.id);
        input.value ||= first?.event[input.name] ?? ""; // somebody may have typed before the answer came
        input.addEventListener("input", show);
      }
      await show();
    }),
  );
  box.append(...inputs.map((input) => h("label", {}, `${input.name} `, input)), answers);
  return box;
}

/** What somebody has written: a number, true or false, or a text. */
function meant(text) {
  if (/^-?\d+$/.test(text)) return Number(text);
  return text === "true" || text === "false" ? text === "true" : text;
}

/** The line that a form begins with: its answer is 0 and its OB is loaded, as far as there is one. */
function begun(lines) {
  const { obs = [] } = read(page.model.branch.header);
  const taken = lines.filter((line) => line.event.ret === "W#16#0000");
  return taken.find((line) => obs.includes(line.event.ob)) ?? taken[0] ?? lines[0];
}

let listed = null; // whether the user wants the list of times; null until it is said

/** Time passes with the next line: the moments at which something changes, and any other. */
function showTime() {
  const { look } = page.view;
  const moments = look.times.map((time) => {
    const due = time.due.length
      ? ` (${time.due.join(" or ")}${look.endless ? " may be due" : " must come by then"})`
      : "";
    const choose = button(time.at + due, () => page.refresh(time.at), { "aria-pressed": String(time.at === look.at) });
    return h("li", {}, choose, requirements(time.requirements));
  });
  const input = h("input", { name: "at", value: look.at, size: 23, "aria-label": "time of the next line" });
  const go = button("Let time pass", () => page.refresh(input.value.trim()));
  const open = listed ?? look.times.some((time) => time.due.length);
  const title = h("summary", {}, `The next line at ${look.at}`);
  title.addEventListener("click", () => (listed = !title.parentElement.open));
  keepFocus($("time"), [
    h("details", { className: "time", open }, title, h("ul", {}, ...moments)),
    h("p", {}, input, " ", go),
  ]);
}

export function showImpossible() {
  const { impossible } = page.view;
  const made = impossible?.map((one) => h("details", {}, h("summary", {}, one.text), ...whyNot(one)));
  const many = "The log can be explained in very many ways. Ask for a line:";
  $("impossible").replaceChildren(...(made ?? [h("p", {}, impossible === undefined ? "…" : many)]));
}
