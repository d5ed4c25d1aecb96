// The page: shows what the engine answers, and turns clicks into lines of the log.
import { Desk } from "./desk.js";
import { $, Rows, h, numberOf } from "./elements.js";
import { Engine, NoAnswer, unusable } from "./engine.js";
import { Model, branch, fromLink, fromText, inflated, ndjson, toLink } from "./model.js";
import { Timeline, read } from "./timeline.js";

const OF_THE_CPU = ["start", "end", "run", "stop", "diag"];
const MANY = 6;
const LONGEST_LINK = 60_000;
const LONGEST = 200_000; // lines of a log that is explored; longer ones get their verdict
const CALLS = {
  DIS_AIRT: [],
  EN_AIRT: [],
  SET_TINT: ["ob", "sdt", "period"],
  ACT_TINT: ["ob"],
  CAN_TINT: ["ob"],
  QRY_TINT: ["ob"],
  SRT_DINT: ["ob", "dtime", "sign"],
  CAN_DINT: ["ob"],
  QRY_DINT: ["ob"],
  DIS_IRT: ["mode", "ob"],
  EN_IRT: ["mode", "ob"],
};

const contents = JSON.parse($("contents").textContent);
let clauses = new Map();
let engine = null;
let desk = null;
let model = null;
let view = null; // what is shown of the branch: {explained, refused, look}
let verdict = null; // of the opened log, while its branch is unchanged
let sides = [];
let asked = 0;

const timeline = new Timeline(
  $("timeline"),
  (first, last) => desk.states(first, last),
  (index) => step(() => model.show(index)),
);
const rows = new Rows($("lines"));

function problem(error) {
  $("problem").hidden = !error;
  $("problem").textContent = error
    ? error instanceof NoAnswer
      ? `No verdict: ${error.message}.`
      : (error.message ?? String(error))
    : "";
}

/** Runs what a click asks for; an error becomes a sentence on the page. */
const safely =
  (work) =>
  async (...given) => {
    try {
      problem(null);
      await work(...given);
    } catch (error) {
      problem(error);
    } finally {
      busy(false);
    }
  };

/** Does a change of the document, and shows what is so then. */
const step = safely(async (change) => {
  if (change() !== false) await refresh();
});

function busy(what) {
  $("stop").hidden = !what;
  if (what) $("where").textContent = what;
}

const button = (text, work, properties = {}) =>
  h("button", { type: "button", onclick: safely(work), ...properties }, text);

// ---------------------------------------------------------------------------- requirements

const requirement = (id) => h("button", { type: "button", className: "id", onclick: () => tell(id) }, id);
const requirements = (ids) => h("span", { className: "ids" }, ...ids.flatMap((id) => [" ", requirement(id)]));

function tell(id) {
  const clause = clauses.get(id) ?? { text: "" };
  const [title, text, origin] = $("clause").children;
  const letters = Object.entries(clause.letters ?? {}).map(([letter, said]) => ` (${letter}) ${said}`);
  title.textContent = id;
  text.replaceChildren(clause.text, ...letters);
  origin.textContent = [clause.source, clause.confidence].filter(Boolean).join("; ");
  $("clause").showModal();
}

// ---------------------------------------------------------------------------- what is shown

/** Shows the branch up to its shown line; the next line comes at `when`, at once if that is not said. */
async function refresh(when = null) {
  const number = ++asked;
  const one = model.branch;
  remember();
  desk.progress = (at, all) => all > 10_000 && busy(`${one.name}: ${at} of ${all} lines`);
  const { explained, refused } = await desk.bring(one);
  busy(false);
  const after = Math.min(one.shown, explained);
  const look = await desk.look(after, when);
  if (number !== asked) return; // a later click has asked something else
  view = { explained, refused, look, after };
  $("start").hidden = true;
  $("desk").hidden = $("tools").hidden = false;
  $("where").textContent =
    `${one.name}: after line ${numberOf(one.numbers, after)} of ${numberOf(one.numbers, one.lines.length)}, ${look.clock}`;
  $("undo").disabled = !model.past.length;
  $("redo").disabled = !model.future.length;
  showBranches();
  showReport();
  showSituation();
  showLines();
  showPossible();
  showImpossible();
  await timeline.show([one.header, ...one.lines], one.shown, explained, refused ? explained + 1 : -1, one.numbers);
  showSides(number);
  await showLink();
}

/** The address holds the whole behaviour, unless that is too long for one. */
async function showLink() {
  const small = model.document.branches.reduce((sum, one) => sum + one.lines.length, 0) < 5000;
  const text = small ? await toLink({ ...model.document, sides }) : "";
  $("link").disabled = !text || text.length > LONGEST_LINK;
  history.replaceState(history.state, "", $("link").disabled ? "#" : `#${text}`);
}

/** The browser's history has a place for each change. */
function remember() {
  const position = model.past.length;
  if (position > (history.state?.position ?? -1)) history.pushState({ position }, "");
}

/** Back undoes and forward does again; before the first log is the start. */
const travelled = safely(async ({ state }) => {
  if (!model) return;
  if (!state) return home();
  while (model.past.length > state.position && model.undo());
  while (model.past.length < state.position && model.redo());
  await refresh();
});

function home() {
  $("start").hidden = false;
  $("desk").hidden = $("tools").hidden = true;
}

function showBranches() {
  const many = model.document.branches.length > 1;
  const tabs = model.document.branches.map((one, i) => {
    const current = i === model.document.current;
    const tab = button(one.name, () => step(() => model.choose(i)), { "aria-pressed": String(current) });
    return h(
      "span",
      { className: current ? "tab current" : "tab" },
      tab,
      many ? button("×", () => step(() => model.drop(i)), { "aria-label": `close ${one.name}` }) : null,
    );
  });
  $("branches").replaceChildren(...tabs);
}

/** The verdict of the opened log, and why its line is rejected. */
function showReport() {
  const one = model.branch;
  const { refused, explained } = view;
  const same = verdict && verdict.lines === one.lines && verdict.header === one.header;
  const said = same
    ? verdict
    : refused
      ? { verdict: refused.unusable ? "unusable" : "rejected" }
      : { verdict: "accepted" };
  const line = numberOf(one.numbers, explained + 1);
  const words = {
    accepted: `the specification explains every line (${explained} events)`,
    rejected: refused?.late
      ? `something had to come before line ${line}`
      : `no behaviour of the specification explains line ${line}`,
    unusable: refused?.unusable ?? said.message,
    "no verdict": said.message,
  }[said.verdict];
  $("report").hidden = false;
  $("verdict").replaceChildren(
    h("span", { className: `verdict ${said.verdict === "no verdict" ? "none" : said.verdict}` }, said.verdict),
    ` ${words}`,
  );
  $("explained").replaceChildren(...(refused && !refused.unusable ? explanation(refused, one, explained) : []));
  $("as-text").textContent = asText(said.verdict, words, one, refused, line);
}

function explanation(refused, one, index) {
  const texts = refused.requirements.map((id) => h("li", {}, requirement(id), ` ${clauses.get(id)?.text ?? ""}`));
  const choices = refused.instead.map((each, i) => instead(each, refused.expected[i], index, one.lines[index]));
  return [
    h("pre", { className: "quote" }, one.lines[index]),
    h(
      "p",
      {},
      refused.late ? "This had to come before: " : "Possible here: ",
      ...(choices.length ? choices : ["nothing"]),
    ),
    h("h3", {}, "Requirements that decide"),
    h("ul", {}, ...texts),
    because(refused),
  ];
}

function asText(name, words, one, refused, line) {
  const text = [`${one.name}${refused ? `:${line}` : ""}: ${name}: ${words}`];
  if (!refused || refused.unusable) return text[0];
  text.push(
    `    ${one.lines[view.explained]}`,
    `  ${refused.late ? "expected before it" : "expected"}: ${refused.expected.join(", ") || "nothing"}`,
  );
  text.push(`  requirements: ${refused.requirements.join(", ")}`);
  for (const id of refused.requirements) text.push(`    ${id} ${clauses.get(id)?.text ?? ""}`);
  refused.situations.forEach((rows, i) => {
    text.push(
      `  before the line${refused.states > 1 ? ` ${i + 1} of ${refused.states}` : ""}:`,
      ...rows.map(([topic, said]) => `    ${topic}: ${said}`),
    );
  });
  if (refused.because.length) text.push("  formulas:", ...refused.because.map((each) => `    ${formula(each)}`));
  return text.join("\n");
}

const formula = (one) =>
  `${one.action}: ~(${one.conjunct})${one.values ? `; here ${one.values}` : ""} [${[...one.requirements, one.place].join(", ")}]`;

/** A button that puts an expected value in the line, or an expected line before it. */
function instead(one, text, index, given) {
  if (one.event === "call") return h("span", {}, ` ${text} `);
  const line = read(given);
  const same = one.event === line.event && (one.ob === undefined || one.ob === line.ob);
  const changed =
    same && !view.refused.late
      ? [{ ...line, ...one, ...(one.info ? { info: { ...line.info, ...one.info } } : {}) }]
      : [{ at: view.look.clock, ...one }];
  const texts = changed.map((each) => JSON.stringify(each));
  return button(
    text,
    () => step(() => model.replace(index, ...(same && !view.refused.late ? texts : [...texts, given]))),
    { className: "choice" },
  );
}

const because = (refused) =>
  refused.because.length
    ? h(
        "details",
        {},
        h("summary", {}, "Formulas"),
        h("ul", { className: "because" }, ...refused.because.map((one) => h("li", {}, formula(one)))),
      )
    : null;

function showSituation() {
  const tables = view.look.situations.map((lines, i) => [
    view.look.situations.length > 1 ? h("h3", {}, `explanation ${i + 1} of ${view.look.states}`) : null,
    h(
      "table",
      {},
      ...lines.map(([topic, text]) => h("tr", {}, h("td", { className: "key" }, topic), h("td", {}, text))),
    ),
  ]);
  $("situation").replaceChildren(...tables.flat().filter(Boolean));
}

const fields = (line) =>
  Object.entries(line)
    .filter(([name]) => !["event", "at", "up"].includes(name))
    .map(([name, value]) => `${name}=${typeof value === "object" ? JSON.stringify(value) : value}`)
    .join(" ");

function showLines() {
  const one = model.branch;
  rows.show(one.lines.length + 1, one.shown, (i) => {
    const line = read(i ? one.lines[i - 1] : one.header);
    const text = i ? `${line.event} ${fields(line)}` : `header: ${line.cpu}, OB ${line.obs?.join(" ")}`;
    const style =
      view.refused && i === view.explained + 1 ? "wrong" : i === one.shown ? "current" : i > one.shown ? "later" : "";
    return button(`${numberOf(one.numbers, i)} ${line.at ?? ""} ${text}`, () => step(() => model.show(i)), {
      className: style,
      "aria-current": String(i === one.shown),
    });
  });
  const edited = view.refused && one.shown > view.explained ? view.explained : one.shown - 1;
  $("edit").hidden = edited < 0;
  $("edit").dataset.index = edited;
  if (edited >= 0) $("edit").text.value = one.lines[edited];
}

function showPossible() {
  showTime();
  const here = view.look.possible;
  const names = [...new Set(here.map((line) => line.event.event))];
  const calls = Object.keys(CALLS).filter((name) => names.includes(name));
  const world = names.filter((name) => !OF_THE_CPU.includes(name) && !calls.includes(name));
  const groups = [
    ["The CPU", OF_THE_CPU.flatMap((name) => acts(name, here))],
    ["The program", calls.map((name) => call(name, here))],
    ["The world", world.flatMap((name) => acts(name, here))],
  ];
  keepFocus(
    $("possible"),
    groups.flatMap(([title, found]) => (found.length ? [h("h3", {}, title), ...found] : [])),
  );
  if (!here.length) $("possible").append(h("p", {}, "Nothing may come at this time: something had to come before."));
  if (!view.look.whole)
    $("possible").prepend(h("p", {}, "The log can be explained in very many ways; more than this may come."));
}

/** Puts other elements in a part of the page; the button with the same text has the focus again, else the part's first. */
function keepFocus(box, made) {
  const focused = box.contains(document.activeElement) ? document.activeElement.textContent : null;
  box.replaceChildren(...made);
  if (focused === null) return;
  const buttons = [...box.querySelectorAll("button, summary")];
  (buttons.find((one) => one.textContent === focused) ?? buttons[0])?.focus({ preventScroll: true });
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

const take = (event) => step(() => model.add(JSON.stringify({ event: event.event, at: view.look.at, ...event })));

/** The form of a call: its operands with some values, and a button for each answer that the CPU may give. */
function call(name, here) {
  if (!CALLS[name].length) return h("div", {}, ...here.filter((line) => line.event.event === name).map(offer));
  const box = h("details", { className: "call" }, h("summary", {}, name));
  const answers = h("div", { className: "answers" });
  const {
    after,
    look: { at },
  } = view;
  const inputs = CALLS[name].map((operand) => h("input", { name: operand, size: operand === "sdt" ? 17 : 10 }));
  const show = safely(async () => {
    const event = { event: name, at };
    for (const input of inputs) event[input.name] = /^-?\d+$/.test(input.value) ? Number(input.value) : input.value;
    const lines = await desk.answers(after, event);
    answers.replaceChildren(...(lines.length ? lines.map(offer) : ["not possible now"]));
  });
  box.addEventListener(
    "toggle",
    safely(async () => {
      if (!box.open || inputs[0].list) return;
      const lines = await desk.call(after, at, name);
      for (const input of inputs) {
        const list = h("datalist", { id: `${name}-${input.name}` });
        const values = [...new Set(lines.map((line) => String(line.event[input.name])))];
        list.append(...values.map((value) => h("option", { value })));
        box.append(list);
        input.setAttribute("list", list.id);
        input.value = values[0] ?? "";
        input.addEventListener("input", show);
      }
      await show();
    }),
  );
  box.append(...inputs.map((input) => h("label", {}, `${input.name} `, input)), answers);
  return box;
}

/** Time passes with the next line: the moments at which something changes, and any other. */
function showTime() {
  const { look } = view;
  const moments = look.times.map((time) => {
    const due = time.due.length
      ? ` (${time.due.join(" or ")}${look.endless ? " may be due" : " must come by then"})`
      : "";
    const choose = button(time.at + due, () => refresh(time.at), { "aria-pressed": String(time.at === look.at) });
    return h("li", {}, choose, requirements(time.requirements));
  });
  const input = h("input", { name: "at", value: look.at, size: 23, "aria-label": "time of the next line" });
  const go = button("Let time pass", () => refresh(input.value.trim()));
  keepFocus($("time"), [
    h(
      "details",
      { className: "time", open: look.times.some((time) => time.due.length) },
      h("summary", {}, `The next line at ${look.at}`),
      h("ul", {}, ...moments),
      h("p", {}, input, " ", go),
    ),
  ]);
}

function showImpossible() {
  const made = (view.look.impossible ?? []).map((one) =>
    h("details", {}, h("summary", {}, one.text), h("p", {}, "By", requirements(one.requirements)), because(one)),
  );
  $("impossible").replaceChildren(...made);
  $("because").replaceChildren();
}

// ---------------------------------------------------------------------------- other CPUs, editions, readings

async function showSides(number) {
  const one = model.branch;
  const made = [];
  for (const side of sides) {
    try {
      made.push(...shownSide(side, await desk.compare(one, view.after, view.look.at, side.chosen)));
    } catch (error) {
      made.push(...sideHead(side), h("p", {}, error.message));
    }
    if (number !== asked) return;
  }
  $("sides").replaceChildren(...made);
}

function sideHead(side) {
  const away = button("×", () => ((sides = sides.filter((one) => one !== side)), refresh()), {
    "aria-label": `without ${side.name}`,
  });
  return [h("h3", {}, side.name, " ", away)];
}

function shownSide(side, found) {
  const change = button("Go on there", () =>
    step(() => model.under(side.name, (header) => changed(header, side.chosen))),
  );
  const head = [...sideHead(side), h("p", {}, change)];
  if (found.refused) {
    if (found.refused.unusable) return [...head, h("p", {}, found.refused.unusable)];
    const text = `Line ${numberOf(model.branch.numbers, found.explained + 1)} is not possible there. Possible: ${found.refused.expected.join(", ") || "nothing"}`;
    return [...head, h("p", {}, text, requirements(found.refused.requirements)), because(found.refused)].filter(
      Boolean,
    );
  }
  const only = (title, texts) =>
    texts.length ? h("p", {}, `${title}: `, h("code", {}, texts.slice(0, 12).join("; "))) : null;
  const differences = [only("only here", found.onlyHere), only("only there", found.onlyThere)].filter(Boolean);
  return [...head, ...(differences.length ? differences : [h("p", {}, "The same may come.")])];
}

/** The header's text with other choices. */
function changed(text, { cpu, profile, readings }) {
  const header = { ...read(text), ...(cpu ? { cpu } : {}), ...(profile ? { profile } : {}) };
  if (readings) header.readings = { ...header.readings, ...readings };
  return JSON.stringify(header);
}

// ---------------------------------------------------------------------------- opening, files, links

/** Begins with a branch, once the engine has taken it: a header that cannot be used changes nothing. */
async function begin(one) {
  await desk.bring({ header: one.header, lines: [] });
  const document = { branches: [one], current: 0 };
  if (model) model.change(document);
  else model = new Model(document);
  await refresh();
}

/** Judges a log and opens it: at its end, or at the rejected line. */
async function open(name, bytes) {
  busy(`${name}: is being judged`);
  const text = new TextDecoder("utf-8").decode(bytes);
  const one = fromText(name, text);
  const answer = await engine.judge(bytes);
  if (answer.verdict === "error") return closed(name, "no verdict", answer.message);
  if (answer.verdict === "unusable") return closed(name, "unusable", unusable(answer.unusable));
  if (one.lines.length > LONGEST)
    return closed(
      name,
      answer.verdict,
      `${answer.line ? `line ${answer.line}, ` : ""}${answer.events} events explained; too long to be shown`,
    );
  const wrong = answer.line ? one.numbers.indexOf(answer.line) : -1;
  verdict = { verdict: answer.verdict, header: one.header, lines: one.lines };
  await begin({ ...one, shown: wrong > 0 ? wrong : one.lines.length });
  $("verdict").focus({ preventScroll: true });
}

function closed(name, kind, message) {
  $("where").textContent = `${name}: ${kind}`;
  problem(`${name}: ${kind}: ${message}`);
}

const openFile = safely(async (file) => open(file.name, new Uint8Array(await file.arrayBuffer())));

function showGallery() {
  const wanted = $("find").value.toLowerCase().split(/\s+/).filter(Boolean);
  const found = contents.gallery.filter((one) => {
    const text = `${one.title} ${one.told} ${one.requirements.join(" ")}`.toLowerCase();
    return wanted.every((word) => text.includes(word));
  });
  const made = found.map((one) =>
    h(
      "li",
      {},
      button(one.title, () => open(one.name, new TextEncoder().encode(one.log)), { className: "choice" }),
      h("p", {}, one.told, requirements(one.requirements)),
    ),
  );
  $("gallery").replaceChildren(...(made.length ? made : [h("li", {}, "No case has all these words.")]));
}

/** The name of a file for a log. */
const fileName = (name) => `${name.replace(/(\.ndjson|\.jsonl)+(?= \(|$)/, "").replace(/[^\w.-]+/g, "_")}.ndjson`;

function download(name, text) {
  const link = h("a", { href: URL.createObjectURL(new Blob([text])), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

const undo = () => model.past.length && history.back();
const redo = () => model.future.length && history.forward();

function wire() {
  $("home").onclick = home;
  $("undo").onclick = undo;
  $("redo").onclick = redo;
  window.onpopstate = travelled;
  $("branch").onclick = () => step(() => model.fork());
  $("stop").onclick = () => engine.stop();
  $("save").onclick = () => download(fileName(model.branch.name), ndjson(model.branch));
  $("link").onclick = safely(async () => {
    await navigator.clipboard.writeText(location.href);
    $("where").textContent = "The address is copied.";
  });
  $("find").oninput = showGallery;
  $("file").onchange = () => $("file").files[0] && openFile($("file").files[0]);
  $("check").onclick = safely(() => open("pasted.ndjson", new TextEncoder().encode($("text").value)));
  $("new").onsubmit = safely((submitted) => (submitted.preventDefault(), begin(branch("new", newHeader(), []))));
  $("edit").onsubmit = safely((submitted) => {
    submitted.preventDefault();
    return step(() => model.replace(Number($("edit").dataset.index), $("edit").text.value.replaceAll("\n", " ")));
  });
  $("edit").drop.onclick = () => step(() => model.replace(Number($("edit").dataset.index)));
  $("why").onsubmit = safely(async (submitted) => {
    submitted.preventDefault();
    const refused = await desk.why(view.after, { at: view.look.at, ...read($("why").line.value) });
    const text = refused ? `No. Possible: ${refused.expected.join(", ") || "nothing"}` : "It may come.";
    $("because").replaceChildren(
      h("p", {}, text, refused ? requirements(refused.requirements) : null),
      refused ? (because(refused) ?? "") : "",
    );
  });
  $("compare").onsubmit = safely((submitted) => {
    submitted.preventDefault();
    const { cpu, profile, reading } = Object.fromEntries(new FormData($("compare")));
    const [question, letter] = reading.split(" ");
    const name = [cpu, profile && `edition ${profile}`, reading].filter(Boolean).join(", ");
    if (!name) throw new Error("Choose another CPU, edition or reading.");
    sides.push({
      name,
      chosen: {
        ...(cpu ? { cpu } : {}),
        ...(profile ? { profile } : {}),
        ...(letter ? { readings: { [question]: letter } } : {}),
      },
    });
    return refresh();
  });
  for (const kind of ["dragover", "dragleave", "drop"]) {
    document.addEventListener(kind, (event) => {
      event.preventDefault();
      $("drop").classList.toggle("over", kind === "dragover");
      if (kind === "drop" && event.dataTransfer.files[0]) openFile(event.dataTransfer.files[0]);
    });
  }
  document.addEventListener("keydown", (key) => {
    if (
      !model ||
      $("desk").hidden ||
      key.target.matches("input, textarea, select") ||
      key.ctrlKey ||
      key.metaKey ||
      key.altKey
    )
      return;
    const { shown } = model.branch;
    const works = {
      u: undo,
      r: redo,
      b: () => step(() => model.fork()),
      ArrowLeft: () => step(() => model.show(shown - 1)),
      ArrowRight: () => step(() => model.show(shown + 1)),
    };
    works[key.key]?.();
  });
}

function newHeader() {
  const given = Object.fromEntries(new FormData($("new")));
  const header = {
    format: "s7-interrupt-log/1",
    cpu: given.cpu,
    obs: given.obs
      .split(/[\s,]+/)
      .filter(Boolean)
      .map(Number),
    clock: given.clock,
    mode: given.mode,
    cycle: true,
  };
  if (given.execution !== "none")
    header.step7 = { tod: { 10: { execution: given.execution, start: given.start, active: true } } };
  return JSON.stringify(header);
}

/** The choices that the specification has. */
async function showChoices() {
  const { alternatives } = await engine.ask({ message: "alternatives" });
  const options = (name, values) => $("compare")[name].append(...values.map((value) => h("option", {}, value)));
  options("cpu", alternatives.families);
  options("profile", alternatives.profiles);
  options(
    "reading",
    alternatives.choices.flatMap(([name, letters]) => [...letters].sort().map((letter) => `${name} ${letter}`)),
  );
}

async function main() {
  const begun = performance.now();
  const [script, wasm, tree, texts] = await Promise.all(
    ["script", "wasm", "tree", "clauses"].map((name) => inflated(contents[name])),
  );
  clauses = new Map(JSON.parse(new TextDecoder().decode(texts)).map((one) => [one.id, one]));
  engine = new Engine({ script, wasm, tree });
  desk = new Desk(engine);
  wire();
  showGallery();
  await engine.start();
  await showChoices();
  $("where").textContent = `The engine is ready: ${Math.round(performance.now() - begun)} ms.`;
  document.body.dataset.ready = String(Math.round(performance.now()));
  // For comparisons with the other engines: the answer about a log, its bytes in base64.
  window.s7check = (log, begin) =>
    engine.judge(
      Uint8Array.from(atob(log), (letter) => letter.charCodeAt(0)),
      begin,
    );
  if (location.hash.length > 1) {
    const { sides: kept, ...document } = await fromLink(location.hash.slice(1));
    sides = kept ?? [];
    model = new Model(document);
    await refresh();
  }
}

safely(main)();
