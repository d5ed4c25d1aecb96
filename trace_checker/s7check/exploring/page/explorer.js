// The page: shows what the server answers, and turns clicks into lines of the log.
import { Model, asProgram, branch, fromLink, fromText, ndjson, toLink } from "./model.js";

const $ = (id) => document.getElementById(id);
const OF_THE_CPU = ["start", "end", "run", "stop", "diag"];
const MANY = 6;
const MANY_WAYS = "The log can be explained in very many ways, and only some of them were looked at.";
const CALLS = {
  DIS_AIRT: [], EN_AIRT: [], SET_TINT: ["ob", "sdt", "period"], ACT_TINT: ["ob"], CAN_TINT: ["ob"], QRY_TINT: ["ob"],
  SRT_DINT: ["ob", "dtime", "sign"], CAN_DINT: ["ob"], QRY_DINT: ["ob"], DIS_IRT: ["mode", "ob"], EN_IRT: ["mode", "ob"],
};
const NUMBERS = new Set(["ob", "dtime"]);

let model = null;
let view = null; // the last answer of the server to the shown lines
let at = null; // the CPU clock of the next line
let sides = [];
let clauses = new Map();
let zoom = 1;
const questions = new WeakMap(); // how many questions each part of the page has asked
const pictures = new Map(); // timelines of branches that are not shown, by their lines

/** An element: h("button", {type: "button", onclick: f}, "text", child). */
function h(tag, properties = {}, ...content) {
  const made = Object.assign(document.createElement(tag), properties);
  for (const [name, value] of Object.entries(properties)) if (name.includes("-")) made.setAttribute(name, value);
  made.append(...content.filter((one) => one !== null && one !== undefined));
  return made;
}

async function ask(what, body) {
  const answer = await fetch(what, { method: "POST", body: JSON.stringify(body) });
  if (!answer.ok) throw new Error(await answer.text());
  return answer.json();
}

/** A new question of this part of the page: whether it is still the last one, when its answer is here. */
function newest(part) {
  const number = (questions.get(part) ?? 0) + 1;
  questions.set(part, number);
  return () => questions.get(part) === number;
}

function problem(error) {
  $("problem").hidden = !error;
  $("problem").textContent = error ? error.message ?? String(error) : "";
}

/** Runs what a click asks for; an error becomes a sentence on the page. */
const safely = (work) => async (...given) => {
  try {
    problem(null);
    await work(...given);
  } catch (error) {
    problem(error);
  }
};

const button = (text, work, properties = {}) =>
  h("button", { type: "button", onclick: safely(work), ...properties }, text);

// ---------------------------------------------------------------------------- requirements

const ID = /\b[A-Z]+-\d{2,}\b/g;

/** A text in which each requirement can be asked for. */
function linked(text) {
  const parts = [];
  let from = 0;
  for (const found of text.matchAll(ID)) {
    if (!clauses.has(found[0])) continue;
    parts.push(text.slice(from, found.index), requirement(found[0]));
    from = found.index + found[0].length;
  }
  return [...parts, text.slice(from)];
}

const requirement = (id) => h("button", { type: "button", className: "id", onclick: () => tell(id) }, id);
const requirements = (ids) => h("span", { className: "ids" }, ...ids.flatMap((id) => [" ", requirement(id)]));

function tell(id) {
  const clause = clauses.get(id);
  const [title, text, origin] = $("clause").children;
  const letters = Object.entries(clause.letters ?? {}).map(([letter, said]) => ` (${letter}) ${said}`);
  title.textContent = id;
  text.replaceChildren(clause.text, ...letters);
  origin.textContent = [clause.source, clause.confidence].filter(Boolean).join("; ");
  $("clause").showModal();
}

// ---------------------------------------------------------------------------- what is shown

/** Shows what the server says of the lines; the next line comes at `when`, at once if that is not said. */
async function refresh(when = null) {
  const last = newest($("desk"));
  const one = model.branch;
  const lines = one.lines.slice(0, one.shown);
  const answer = await ask("look", { header: one.header, lines, at: when });
  if (!last()) return; // a later click has asked something else
  view = answer;
  at = view.at;
  $("start").hidden = true;
  $("desk").hidden = $("tools").hidden = false;
  $("where").textContent = `${one.name}: line ${view.explained + 1} of ${one.lines.length + 1}, ${view.clock}`;
  $("undo").disabled = !model.past.length;
  $("redo").disabled = !model.future.length;
  showBranches();
  showRefused();
  showPictures(last);
  showSituation();
  showLines();
  showPossible();
  showImpossible();
  showSides(last);
  history.replaceState(null, "", `#${await toLink({ ...model.document, sides })}`);
}

function showBranches() {
  const tabs = model.document.branches.map((one, i) => {
    const current = i === model.document.current;
    const tab = button(one.name, () => (model.choose(i), refresh()), { role: "tab", "aria-selected": String(current) });
    const close = button("×", () => (model.drop(i), refresh()), { "aria-label": `close ${one.name}` });
    return h("span", { className: current ? "tab current" : "tab" }, tab, model.document.branches.length > 1 ? close : null);
  });
  $("branches").replaceChildren(...tabs);
}

function showRefused() {
  const box = $("refused");
  box.hidden = !view.refused;
  if (!view.refused) return;
  const index = view.explained;
  const line = model.branch.lines[index];
  const choices = view.refused.instead.map((one, i) => instead(one, view.refused.expected[i], index, line));
  box.replaceChildren(
    h("h2", {}, `Line ${index + 2} is not possible`),
    h("pre", { className: "quote" }, JSON.stringify(line)),
    h("p", {}, ...linked(view.refused.why || view.refused.message), requirements(view.refused.requirements)),
    h("p", {}, view.refused.late ? "This had to come before: " : "Possible here: ", ...choices),
    because(view.refused),
  );
}

/** A button that puts an expected value in the line, or an expected line before it. */
function instead(one, text, index, line) {
  if (one.event === "call") return h("span", {}, ` ${text} `);
  const same = one.event === line.event && (one.ob === undefined || one.ob === line.ob);
  const changed = same ? { ...line, ...one, ...(one.info ? { info: { ...line.info, ...one.info } } : {}) } : null;
  const lines = changed && !view.refused.late ? [changed] : [{ at: view.clock, ...one }, line];
  return button(text, () => (model.replace(index, ...lines), refresh()), { className: "choice" });
}

const because = (refused) =>
  h("details", {}, h("summary", {}, "formulas"), h("ul", { className: "because" },
    ...refused.because.map((one) => h("li", {}, ...linked(one.text), " ", requirements(one.requirements)))));

/** Shows the timelines of all branches, unless a later question has been asked. */
async function showPictures(last) {
  const box = $("pictures");
  const pictures = await Promise.all(model.document.branches.map(async (one, i) => {
    const current = i === model.document.current;
    return picture(one, current ? view.timeline : await pictureOf(one), current, i);
  }));
  const scale = (factor) => () => ((zoom = Math.max(0.4, Math.min(3, zoom * factor))), applyZoom());
  if (!last()) return;
  box.replaceChildren(
    h("p", { className: "tools" }, button("−", scale(0.8), { "aria-label": "zoom out" }),
      button("+", scale(1.25), { "aria-label": "zoom in" })), ...pictures);
  applyZoom();
}

async function pictureOf({ header, lines }) {
  const key = JSON.stringify([header, lines]);
  if (!pictures.has(key)) pictures.set(key, (await ask("timeline", { header, lines })).timeline);
  return pictures.get(key);
}

function picture(one, svg, current, index) {
  const frame = h("div", { className: "scroll", tabIndex: 0, "aria-label": `timeline of ${one.name}` });
  frame.innerHTML = svg; // made by the server from escaped texts
  for (const column of frame.querySelectorAll("[data-line]")) {
    const number = Number(column.dataset.line);
    column.addEventListener("click", safely(() => {
      if (!current) model.choose(index);
      model.show(number - 1);
      return refresh();
    }));
  }
  requestAnimationFrame(() => (frame.scrollLeft = frame.scrollWidth));
  if (!svg) frame.append("No line yet.");
  const title = model.document.branches.length > 1 ? h("h3", {}, one.name) : null;
  return h("div", { className: current ? "picture current" : "picture" }, title, frame);
}

function applyZoom() {
  for (const svg of document.querySelectorAll("#pictures svg")) {
    const [width, height] = svg.getAttribute("viewBox").split(" ").slice(2).map(Number);
    svg.setAttribute("width", width * zoom);
    svg.setAttribute("height", height * zoom);
  }
}

function showSituation() {
  const tables = view.situations.map((rows, i) => [
    view.situations.length > 1 ? h("h3", {}, `explanation ${i + 1} of ${view.situations.length}`) : null,
    h("table", {}, ...rows.map(([topic, text]) => h("tr", {}, h("td", { className: "key" }, topic), h("td", {}, text)))),
  ]);
  $("situation").replaceChildren(...tables.flat().filter(Boolean));
  if (view.situations.length > 1) showQuestions();
}

/** Says by which open questions the explanations differ, above them. */
const showQuestions = safely(async () => {
  const last = newest($("situation"));
  const { questions } = await ask("questions", behaviour());
  if (!last() || !questions.length) return;
  const said = questions.map((text) => h("li", {}, ...linked(text)));
  $("situation").prepend(h("p", {}, "The explanations differ by what the sources leave open:"), h("ul", {}, ...said));
});

const fields = (line) => Object.entries(line).filter(([name]) => !["event", "at", "up"].includes(name))
  .map(([name, value]) => `${name}=${typeof value === "object" ? JSON.stringify(value) : value}`).join(" ");

function showLines() {
  const one = model.branch;
  const rows = [{ event: "header", at: one.header.clock }, ...one.lines].map((line, i) => {
    const wrong = view.refused && i === view.explained + 1;
    const name = i ? `${line.event} ${fields(line)}` : `${one.header.cpu}, OB ${one.header.obs?.join(" ")}`;
    const chosen = button(`${line.at ?? ""} ${name}`, () => (model.show(i), refresh()));
    const state = wrong ? "wrong" : i > one.shown ? "later" : i === one.shown ? "current" : "";
    return h("li", { className: state, value: i + 1 }, chosen);
  });
  $("lines").replaceChildren(...rows);
  const edited = view.refused ? view.explained : one.shown - 1;
  $("edit").hidden = edited < 0;
  $("edit").dataset.index = edited;
  if (edited >= 0) $("edit").text.value = JSON.stringify(one.lines[edited]);
}

function showPossible() {
  showTime();
  const here = view.possible;
  const names = [...new Set(here.map((line) => line.event.event))];
  const calls = Object.keys(CALLS).filter((name) => names.includes(name));
  const world = names.filter((name) => !OF_THE_CPU.includes(name) && !calls.includes(name));
  const groups = [
    ["The CPU", OF_THE_CPU.flatMap((name) => acts(name, here))],
    ["The program", calls.map((name) => call(name, here))],
    ["The world", world.flatMap((name) => acts(name, here))],
  ];
  const shown = groups.flatMap(([title, found]) => (found.length ? [h("h3", {}, title), ...found] : []));
  $("possible").replaceChildren(...shown);
  if (!here.length) $("possible").append(h("p", {}, "Nothing may come at this time: something had to come before."));
  if (!view.whole) $("possible").prepend(h("p", { className: "part" }, `${MANY_WAYS} More than this may come.`));
}

/** The lines of one kind: a button each, or a list of OBs where there are many. */
function acts(name, here) {
  const lines = here.filter((line) => line.event.event === name);
  if (lines.length <= MANY) return lines.map(offer);
  const choice = h("select", { "aria-label": `${name}: OB` },
    ...lines.map((line, i) => h("option", { value: i }, fields(line.event))));
  const add = button(name, () => take(lines[choice.value].event), { className: "choice" });
  return [h("p", { className: "offer" }, add, " ", choice, requirements(lines[0].requirements))];
}

/** A possible line: a button that adds it. */
function offer(line) {
  const text = `${line.event.event} ${fields(line.event)}`.trim();
  return h("p", { className: "offer" }, button(text, () => take(line.event), { className: "choice" }), requirements(line.requirements));
}

function take(event) {
  model.add({ event: event.event, at, ...event });
  return refresh();
}

/** The form of a call: its operands with some values, and a button for each answer that the CPU may give. */
function call(name, here) {
  if (!CALLS[name].length) return h("div", {}, ...here.filter((line) => line.event.event === name).map(offer));
  const answers = h("span", { className: "answers" });
  const inputs = CALLS[name].map((operand) => {
    const input = h("input", { name: operand, size: operand === "sdt" ? 17 : 10 });
    const values = h("datalist", { id: `${name}-${operand}` });
    input.setAttribute("list", values.id);
    input.addEventListener("input", () => answered(name, inputs, answers));
    return [h("label", {}, `${operand} `, input), values];
  });
  const box = h("details", { className: "call" }, h("summary", {}, name), ...inputs.flat(), answers);
  box.addEventListener("toggle", safely(async () => {
    if (!box.open) return;
    const { possible } = await ask("call", { ...behaviour(), at, event: name });
    for (const [label, list] of inputs) {
      const input = label.querySelector("input");
      const values = [...new Set(possible.map((line) => String(line.event[input.name])))];
      list.replaceChildren(...values.map((value) => h("option", { value })));
      input.value ||= values[0] ?? "";
    }
    await answered(name, inputs, answers);
  }));
  return box;
}

/** The lines that the server has explained, with their header. */
const behaviour = () => ({ header: model.branch.header, lines: model.branch.lines.slice(0, view.explained) });

/** Shows what the CPU may answer to the operands, unless they have changed meanwhile. */
async function answered(name, inputs, box) {
  const last = newest(box);
  const event = { event: name, at };
  for (const [label] of inputs) {
    const input = label.querySelector("input");
    event[input.name] = NUMBERS.has(input.name) ? Number(input.value) : input.value;
  }
  try {
    const { possible } = await ask("answers", { ...behaviour(), line: event });
    if (last()) box.replaceChildren(...(possible.length ? possible.map(offer) : ["not possible now"]));
  } catch (error) {
    if (last()) box.replaceChildren(error.message);
  }
}

/** Time passes with the next line: the moments at which something changes, and any other. */
function showTime() {
  const moments = view.times.map((time) => {
    const due = time.due.length ? ` (${time.due.join(" or ")}${view.endless ? " may be due" : " must come by then"})` : "";
    const chosen = time.at === at;
    const choose = button(time.at + due, () => refresh(time.at), { "aria-pressed": String(chosen) });
    return h("li", {}, choose, requirements(time.requirements));
  });
  const input = h("input", { name: "at", value: at, size: 23, "aria-label": "time of the next line" });
  const go = button("Let time pass", () => refresh(input.value.trim()));
  $("time").replaceChildren(
    h("details", { className: "time", open: view.times.some((time) => time.due.length) },
      h("summary", {}, `The next line at ${at}`), h("ul", {}, ...moments), h("p", {}, input, " ", go)));
}

function showImpossible() {
  const rows = (view.impossible ?? []).map((one) =>
    h("details", {}, h("summary", {}, `${one.event.event} ${fields(one.event)}`.trim(), requirements(one.requirements)), because(one)));
  const part = view.impossible ? null : h("p", { className: "part" }, `${MANY_WAYS} Ask for a line:`);
  $("impossible").replaceChildren(...[part, ...rows, asked()].filter(Boolean));
}

/** Why a line of one's own may not come. */
function asked() {
  const text = h("input", { name: "event", value: '{"event": "start", "ob": 10}', size: 34, "aria-label": "a line, a JSON object" });
  const answer = h("div");
  const ask_ = button("Why not?", async () => {
    const last = newest(answer);
    const { refused } = await ask("why", { ...behaviour(), line: { at, ...JSON.parse(text.value) } });
    if (last()) answer.replaceChildren(refused ? because(refused) : "It may come.");
  });
  return h("p", {}, text, " ", ask_, answer);
}

/** Asks for each of the other headers, and shows the answers unless a later question has been asked. */
async function showSides(last) {
  const lines = model.branch.lines.slice(0, model.branch.shown);
  const found = await Promise.all(sides.map((side) => ask("compare", { header: model.branch.header, lines, at, side })));
  if (last()) $("sides").replaceChildren(...found.flatMap(side));
}

function side(found, i) {
  const away = button("×", () => (sides.splice(i, 1), refresh()), { "aria-label": `without ${found.name}` });
  const change = button("Go on there", () => {
    const one = model.branch;
    model.change({ ...model.document, branches: [...model.document.branches, branch(`${one.name}, ${found.name}`, found.header, one.lines)],
      current: model.document.branches.length });
    return refresh();
  });
  const head = h("h3", {}, found.name, " ", away, " ", change);
  if (found.refused) {
    const text = `Line ${found.explained + 2} is not possible there. Possible: ${found.refused.expected.join(", ") || "nothing"}`;
    return [head, h("p", {}, text, requirements(found.refused.requirements)), because(found.refused)];
  }
  const only = (title, texts) => texts.length ? h("p", {}, `${title}: `, h("code", {}, texts.slice(0, 12).join("; "))) : null;
  const differences = [only("only here", found.only_here), only("only there", found.only_there)].filter(Boolean);
  return [head, ...(differences.length ? differences : [h("p", {}, "The same may come.")])];
}

// ---------------------------------------------------------------------------- the start page, files, links

function begin(one) {
  const document = { branches: [one], current: 0 };
  if (model) model.change(document);
  else model = new Model(document);
  return refresh();
}

function showGallery(cases) {
  const wanted = $("find").value.toLowerCase().split(/\s+/).filter(Boolean);
  const found = cases.filter((one) => {
    const text = `${one.title} ${one.told} ${one.requirements.join(" ")}`.toLowerCase();
    return wanted.every((word) => text.includes(word));
  });
  $("gallery").replaceChildren(...found.map((one) =>
    h("li", {}, button(one.title, () => openNamed(one.name), { className: "choice" }), h("p", {}, one.told, requirements(one.requirements)))));
  if (!found.length) $("gallery").append(h("li", {}, "No case has all these words."));
}

const opened = ({ name, header, lines }) => branch(name, header, lines);
const openNamed = async (name) => begin(opened(await ask("open", name)));
const run = async (program) => opened(await ask("run", program));

function download(name, text) {
  const link = h("a", { href: URL.createObjectURL(new Blob([text])), download: name });
  link.click();
  URL.revokeObjectURL(link.href);
}

function wire(contents) {
  $("home").onclick = () => (($("start").hidden = false), ($("desk").hidden = $("tools").hidden = true));
  $("undo").onclick = safely(() => model.undo() && refresh());
  $("redo").onclick = safely(() => model.redo() && refresh());
  $("branch").onclick = safely(() => (model.fork(), refresh()));
  $("save").onclick = () => download(`${model.branch.name.replace(/[^\w.-]+/g, "_")}.ndjson`, ndjson(model.branch));
  $("program").onclick = safely(async () => {
    const { header, lines } = model.branch;
    download(`${model.branch.name.replace(/[^\w.-]+/g, "_")}.json`, (await ask("program", { header, lines })).text);
  });
  $("link").onclick = safely(async () => {
    await navigator.clipboard.writeText(location.href);
    $("where").textContent = "The address is copied.";
  });
  $("find").oninput = () => showGallery(contents.gallery);
  $("logs").replaceChildren(...contents.logs.map((value) => h("option", { value })));
  $("open").onclick = safely(() => openNamed($("name").value));
  $("file").onchange = safely(async () => {
    const [file] = $("file").files;
    if (!file) return;
    const text = await file.text();
    const program = asProgram(text);
    await begin(program ? await run(program) : fromText(file.name, text));
  });
  $("new").onsubmit = safely((submitted) => {
    submitted.preventDefault();
    const given = Object.fromEntries(new FormData($("new")));
    const header = { format: "s7-interrupt-log/1", cpu: given.cpu, obs: given.obs.split(/[\s,]+/).filter(Boolean).map(Number),
      clock: given.clock, mode: given.mode, cycle: true };
    if (given.execution !== "none") header.step7 = { tod: { 10: { execution: given.execution, start: given.start, active: true } } };
    return begin(branch("new", header, []));
  });
  $("edit").onsubmit = safely((submitted) => {
    submitted.preventDefault();
    model.replace(Number($("edit").dataset.index), JSON.parse($("edit").text.value));
    return refresh();
  });
  $("edit").drop.onclick = safely(() => (model.replace(Number($("edit").dataset.index)), refresh()));
  $("compare").onsubmit = safely((submitted) => {
    submitted.preventDefault();
    const { cpu, profile, reading } = Object.fromEntries(new FormData($("compare")));
    const readings = Object.fromEntries(reading.split(/[\s,]+/).filter(Boolean).map((one) => one.split("=")));
    sides.push({ cpu: cpu || null, profile: profile || null, readings });
    return refresh();
  });
  document.addEventListener("keydown", safely((key) => {
    if (!model || $("desk").hidden || key.target.matches("input, textarea, select") || key.ctrlKey || key.metaKey || key.altKey) return;
    const works = {
      u: () => model.undo(), r: () => model.redo(), b: () => model.fork(),
      ArrowLeft: () => model.show(model.branch.shown - 1), ArrowRight: () => model.show(model.branch.shown + 1),
    };
    if (key.key in works && works[key.key]() !== false) return refresh();
  }));
}

async function main() {
  const contents = await (await fetch("start")).json();
  $("legend").insertAdjacentHTML("beforeend", contents.legend); // made by the server
  document.body.prepend($("legend").querySelector("defs").ownerSVGElement); // a closed <details> would hide the patterns
  clauses = new Map(contents.clauses.map((one) => [one.id, one]));
  wire(contents);
  showGallery(contents.gallery);
  if (location.hash.length > 1) {
    const { sides: kept, ...document } = await fromLink(location.hash.slice(1));
    sides = kept ?? [];
    model = new Model(document);
    await refresh();
  } else if (contents.first) {
    const { name, header, lines, line } = contents.first;
    await begin(branch(name, header, lines, line ? line - 1 : lines.length));
  }
}

safely(main)();
