// The page: shows what the engine answers, and turns clicks into lines of the log.
import { Desk } from "./desk.js";
import { $, Rows, h, numberOf, numbersOf } from "./elements.js";
import { OF_THE_CPU, showImpossible, showPossible } from "./offers.js";
import { Engine, unusable } from "./engine.js";
import { asUtf8, madeOf, unpacked } from "./importing.js";
import { Model, branch, fromLink, fromText, inflated, layOut, ndjson, toLink } from "./model.js";
import { sessionOf, showOthers } from "./others.js";
import { asPage, met, showReport, tryReadings, whyNot } from "./report.js";
import { showSides } from "./sides.js";
import { busy, button, fields, inSite, page, problem, requirement, requirements, safely, step, table } from "./shown.js";
import { Timeline, read, zoom } from "./timeline.js";

const LONGEST_LINK = 60_000;
const EVENTS = 8; // kinds of event that are asked about at once
const LONGEST = 200_000; // lines of a log that is explored; longer ones get their verdict
const contents = JSON.parse($("contents").textContent);
const first = JSON.parse($("first").textContent); // the log to begin with, which `s7check explore` puts there
let engine = null;

page.refresh = refresh;

const timeline = new Timeline(
  $("timeline"),
  (first, last) => page.desk.states(first, last),
  (index) => step(() => page.model.show(index)),
);
const rows = new Rows($("lines"));

// ---------------------------------------------------------------------------- what is shown

/**
 * Shows the branch up to its shown line; the next line comes at `when`, at once if that is not said. Of a log that has
 * just been opened the verdict has the focus, before anybody can go on from there.
 */
async function refresh(when = null, opened = false) {
  const number = ++page.asked;
  const one = page.model.branch;
  $("link").disabled = true; // the address is the old one until it is shown
  remember();
  page.desk.progress = (at, all) => all > 10_000 && busy(`${one.name}: ${at} of ${all} lines`);
  const { explained, refused } = await page.desk.bring(one);
  busy(false);
  const after = Math.min(one.shown, explained);
  const look = await page.desk.look(after, when, OF_THE_CPU);
  if (number !== page.asked) return; // a later click has asked something else
  page.view = { explained, refused, look, after, all: false };
  $("start").hidden = true;
  $("desk").hidden = $("tools").hidden = false;
  $("where").textContent =
    `${one.name}: after line ${numberOf(one.numbers, after)} of ${numberOf(one.numbers, one.lines.length)}, ${look.clock}`;
  $("undo").disabled = !page.model.past.length;
  $("redo").disabled = !page.model.future.length;
  showBranches();
  showReport();
  if (opened) $("verdict").focus({ preventScroll: true });
  showSituation();
  showLines();
  showPossible();
  showImpossible();
  $("because").replaceChildren();
  const wrong = refused ? explained + 1 : -1;
  await timeline.show([one.header, ...one.lines], one.shown, explained, wrong, one.numbers, refused?.situations?.[0]);
  if (number !== page.asked) return; // the engine may have taken lines back by now
  await showRest(number);
  showSides(number);
  await showLink(number);
  const sides = page.sides.map((side) => JSON.stringify(side.chosen));
  await page.desk.keep([...page.model.document.branches.map(sessionOf), ...sides]);
  await showOthers(number);
  await showQuestions(number);
}

/** Shows what takes longer: all that may come, then what may not. A later click waits for one short question alone. */
async function showRest(number) {
  const { after, look } = page.view;
  const rest = look.events.filter((one) => !OF_THE_CPU.includes(one));
  for (let i = 0; i < rest.length; i += EVENTS) {
    const { lines, whole } = await page.desk.events(after, look.at, rest.slice(i, i + EVENTS));
    if (number !== page.asked) return;
    look.possible.push(...lines);
    look.whole &&= whole;
  }
  page.view.all = true;
  showPossible();
  const impossible = look.whole ? await page.desk.impossible(after, look.at) : null;
  if (number !== page.asked) return;
  page.view.impossible = impossible;
  showImpossible();
}

/** The address holds the whole behaviour, unless that is too long for one. */
async function showLink(number) {
  const small = page.model.document.branches.reduce((sum, one) => sum + one.lines.length, 0) < 5000;
  const text = small ? await toLink({ ...page.model.document, sides: page.sides }) : "";
  if (number !== page.asked) return; // it is the address of what was shown before
  $("link").disabled = !text || text.length > LONGEST_LINK;
  history.replaceState(history.state, "", $("link").disabled ? "#" : `#${text}`);
}

/** The browser's history has a place for each change. */
function remember() {
  const position = page.model.past.length;
  if (position > (history.state?.position ?? -1)) history.pushState({ position }, "");
}

/** Back undoes and forward does again; before the first log is the start. */
const travelled = safely(async ({ state }) => {
  if (!page.model) return;
  if (!state) return home();
  while (page.model.past.length > state.position && page.model.undo());
  while (page.model.past.length < state.position && page.model.redo());
  await refresh();
});

function home() {
  $("start").hidden = false;
  $("desk").hidden = $("tools").hidden = true;
}

function showBranches() {
  const many = page.model.document.branches.length > 1;
  const tabs = page.model.document.branches.map((one, i) => {
    const current = i === page.model.document.current;
    const tab = button(one.name, () => step(() => page.model.choose(i)), { "aria-pressed": String(current) });
    return h(
      "span",
      { className: current ? "tab current" : "tab" },
      tab,
      many ? button("×", () => step(() => page.model.drop(i)), { "aria-label": `close ${one.name}` }) : null,
    );
  });
  $("branches").replaceChildren(...tabs);
}

function showSituation() {
  const tables = page.view.look.situations.map((lines, i) => [
    page.view.look.situations.length > 1 ? h("h3", {}, `explanation ${i + 1} of ${page.view.look.states}`) : null,
    table(lines),
  ]);
  $("situation").replaceChildren(...tables.flat().filter(Boolean));
}

/** Says by which open questions the explanations differ, above them. */
async function showQuestions(number) {
  if (page.view.look.situations.length < 2) return;
  const found = await page.desk.questions(page.model.branch, page.view.after);
  if (number !== page.asked || !found.length) return;
  const items = found.map(({ name, explanations }) => {
    const { text, letters } = page.clauses.get(name);
    const said = Object.entries(explanations).map(
      ([letter, numbers]) => ` (${letter}) ${letters[letter]}: explanation ${numbers.join(", ")};`,
    );
    return h("li", {}, requirement(name), ` ${text}`, ...said);
  });
  $("situation").prepend(h("p", {}, "The explanations differ by what the sources leave open:"), h("ul", {}, ...items));
}

function showLines() {
  const one = page.model.branch;
  rows.show(one.lines.length + 1, one.shown, (i) => {
    const line = read(i ? one.lines[i - 1] : one.header);
    const text = i ? `${line.event} ${fields(line)}` : `header: ${line.cpu}, OB ${line.obs?.join(" ")}`;
    const wrong = page.view.refused && i === page.view.explained + 1;
    const style = wrong ? "wrong" : i === one.shown ? "current" : i > one.shown ? "later" : "";
    return button(`${numberOf(one.numbers, i)} ${line.at ?? ""} ${text}`, () => step(() => page.model.show(i)), {
      className: style,
      "aria-current": String(i === one.shown),
    });
  });
  const { refused, explained } = page.view;
  const edited = refused && one.shown > explained ? explained : one.shown - 1;
  $("edit").hidden = edited < 0;
  $("edit").dataset.index = edited;
  if (edited >= 0) $("edit").text.value = one.lines[edited];
}

// ---------------------------------------------------------------------------- opening, files, links

/** Begins with a branch, once the engine has taken it: a header that cannot be used changes nothing. */
async function begin(one) {
  await page.desk.bring({ header: one.header, lines: [] }, "tried"); // the shown one may still be asked about
  const document = { branches: [one], current: 0 };
  if (page.model) page.model.change(document);
  else page.model = new Model(document);
  await refresh(null, true);
}

/**
 * Judges a log and opens it: at a line of its text, else at the rejected line or its end; `told` is said of it. Of a
 * program, or a source, it is the log that is made of it.
 */
async function open(file, given, line = null, told = []) {
  busy(`${file}: is being judged`);
  const { name, bytes } = await unpacked(file, given);
  const log = asUtf8(bytes);
  const text = new TextDecoder("utf-8").decode(log);
  const one = fromText(name, text);
  const answer = await engine.judge(log);
  if (answer.verdict === "error") return closed(name, "no verdict", answer.message);
  if (answer.verdict === "unusable" && !told.length && answer.unusable.line <= one.numbers[0]) {
    const { made, refused } = await madeOf(engine, name, bytes);
    if (refused) return closed(name, "unusable", refused);
    const again = made?.again ? [button("Run it otherwise", () => open(name, bytes))] : [];
    if (made) return open(`${made.name}.ndjson`, made.bytes, null, [...made.told, ...again]);
  }
  if (answer.verdict === "unusable") return closed(name, "unusable", unusable(answer.unusable));
  if (one.lines.length > LONGEST)
    return closed(
      name,
      answer.verdict,
      `${answer.line ? `line ${answer.line}, ` : ""}${answer.events} events explained; too long to be shown`,
    );
  const at = line ?? answer.line;
  const shown = at ? one.numbers.filter((number) => number <= at).length - 1 : one.lines.length;
  page.verdict = { ...judgement(answer), answer, header: one.header, lines: one.lines, told };
  await begin({ ...one, shown: Math.max(0, shown) });
  const judged = page.verdict;
  await tryReadings(engine, judged, log, () => page.verdict === judged);
}

/** The verdict that an answer stands for, with its message. */
function judgement(answer) {
  const open = answer.verdict === "accepted" && answer.loose && !answer.partial;
  if (open || answer.verdict === "error") return { verdict: "no verdict", message: answer.message };
  const more = answer.verdict === "accepted" ? ` (${answer.events} events)${met(answer, contents.decidable)}` : "";
  return { verdict: answer.verdict, message: `${answer.message}${more}` };
}

/** The report of what is shown as a page of its own. */
async function saveReport() {
  const { name } = page.model.branch;
  download(`${fileName(name)}.html`, asPage(name, await timeline.still()));
}

function closed(name, kind, message) {
  $("where").textContent = `${name}: ${kind}`;
  problem(`${name}: ${kind}: ${message}`);
}

const openFile = safely(async (file) => open(file.name, new Uint8Array(await file.arrayBuffer())));

const openCase = (one) => open(one.name, new TextEncoder().encode(one.log));

const words = (text) => text.toLowerCase().match(/[\p{L}\d_-]+/gu) ?? [];

/** The words by which an edge case is found: its text, the events and OBs of its log, and its rules. */
function indexed(one) {
  const own = words(`${one.title} ${one.told} ${one.requirements.join(" ")}`);
  const events = one.log.split("\n").map(read);
  const log = events.map(({ event, ob }) => (ob === undefined ? event : `${event} OB ${ob}`)).join(" ");
  const rules = one.requirements.map((id) => page.clauses.get(id)?.text).join(" ");
  return { own, all: [...own, ...words(`${log} ${rules}`)] };
}

/** Whether each wanted word is there: as a part of one, but IDs and other words with a number at their end whole. */
const hasAll = (wanted, there) =>
  wanted.every((word) => (/\d$/.test(word) ? there.includes(word) : there.some((one) => one.includes(word))));

/** The edge cases that are looked for; those that say the words themselves come first. */
function showGallery() {
  const wanted = words($("find").value);
  for (const one of contents.gallery) one.words ??= indexed(one);
  const found = contents.gallery.filter((one) => hasAll(wanted, one.words.all));
  found.sort((a, b) => hasAll(wanted, b.words.own) - hasAll(wanted, a.words.own));
  const made = found.map((one) =>
    h(
      "li",
      {},
      button(one.title, () => openCase(one), { className: "choice" }),
      h("p", {}, one.told, requirements(one.requirements)),
    ),
  );
  $("gallery").replaceChildren(...(made.length ? made : [h("li", {}, "No case has all these words.")]));
}

/** The name of a file for a log, without its ending. */
const fileName = (name) => name.replace(/(\.ndjson|\.jsonl)+(?= \(|$)/, "").replace(/[^\w.-]+/g, "_");

/** The branch as a program of the kit. */
async function program() {
  const name = fileName(page.model.branch.name).replace(/^[^A-Za-z0-9]+/, "").slice(0, 100) || "explored";
  const made = await page.desk.program(ndjson(page.model.branch));
  const head = { format: "s7-interrupt-program/1", name, about: "Built in the explorer.", requirements: [] };
  download(`${name}.json`, layOut({ ...head, ...made }));
}

function scale(factor) {
  zoom(factor);
  return refresh();
}

function download(name, text) {
  const link = h("a", { href: URL.createObjectURL(new Blob([text])), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

const undo = () => page.model.past.length && history.back();
const redo = () => page.model.future.length && history.forward();

function wire() {
  if (inSite) {
    const menu = { "index.html": "start", "book.html": "book" };
    $("site").hidden = false;
    $("site").replaceChildren(...Object.entries(menu).flatMap(([href, name]) => [h("a", { href }, name), " "]));
  }
  $("home").onclick = home;
  $("undo").onclick = undo;
  $("redo").onclick = redo;
  window.onpopstate = travelled;
  $("branch").onclick = () => step(() => page.model.fork());
  $("stop").onclick = () => engine.stop();
  $("save").onclick = () => download(`${fileName(page.model.branch.name)}.ndjson`, ndjson(page.model.branch));
  $("program").onclick = safely(program);
  $("save-report").onclick = safely(saveReport);
  $("narrower").onclick = safely(() => scale(0.8));
  $("wider").onclick = safely(() => scale(1.25));
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
    return step(() => page.model.replace(Number($("edit").dataset.index), $("edit").text.value.replaceAll("\n", " ")));
  });
  $("find-line").onsubmit = safely(async (submitted) => {
    submitted.preventDefault();
    const wanted = $("find-line").wanted.value.trim();
    if (wanted && !page.model.find(wanted)) throw new Error(`No line has ${wanted}.`);
    return refresh();
  });
  $("edit").drop.onclick = () => step(() => page.model.replace(Number($("edit").dataset.index)));
  $("why").onsubmit = safely(async (submitted) => {
    submitted.preventDefault();
    const refused = await page.desk.why(page.view.after, { at: page.view.look.at, ...read($("why").line.value) });
    $("because").replaceChildren(...(refused ? whyNot(refused) : [h("p", {}, "It may come.")]));
  });
  $("compare").onsubmit = safely((submitted) => {
    submitted.preventDefault();
    const { cpu, profile, reading } = Object.fromEntries(new FormData($("compare")));
    const [question, letter] = reading.split(" ");
    const name = [cpu, profile && `edition ${profile}`, reading].filter(Boolean).join(", ");
    if (!name) throw new Error("Choose another CPU, edition or reading.");
    page.sides.push({
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
      !page.model ||
      $("desk").hidden ||
      key.target.matches("input, textarea, select") ||
      key.ctrlKey ||
      key.metaKey ||
      key.altKey
    )
      return;
    const { shown } = page.model.branch;
    const works = {
      u: undo,
      r: redo,
      b: () => step(() => page.model.fork()),
      ArrowLeft: () => step(() => page.model.show(shown - 1)),
      ArrowRight: () => step(() => page.model.show(shown + 1)),
    };
    works[key.key]?.();
  });
}

function newHeader() {
  const given = Object.fromEntries(new FormData($("new")));
  const header = {
    format: "s7-interrupt-log/1",
    cpu: given.cpu,
    obs: numbersOf(given.obs),
    clock: given.clock,
    mode: given.mode,
    cycle: true,
  };
  if (given.execution !== "none")
    header.step7 = { tod: { 10: { execution: given.execution, start: given.start, active: true } } };
  return JSON.stringify(header);
}

/** So much of a sentence as a line of a list takes. */
const beginning = (text = "") => (text.length > 90 ? `${text.slice(0, 90).replace(/\s\S*$/, "")} …` : text);

/** The choices that the specification has. */
async function showChoices() {
  const { alternatives } = await engine.ask({ message: "alternatives" });
  const options = (name, values) => $("compare")[name].append(...values.map((value) => h("option", {}, value)));
  options("cpu", alternatives.families);
  for (const form of [$("new"), $("import").querySelector("form")])
    form.cpu.append(...alternatives.families.map((value) => h("option", { selected: value === "S7-400" }, value)));
  options("profile", alternatives.profiles);
  for (const [name, letters] of alternatives.choices) {
    const asked = page.clauses.get(name);
    const offered = [...letters].sort().map((letter) => {
      const said = beginning(asked?.letters[letter]);
      return h("option", { value: `${name} ${letter}` }, `${name} ${letter} ${said}`);
    });
    const group = h("optgroup", { label: `${name} ${beginning(asked?.text)}` }, ...offered);
    $("programs").querySelector("form").readings.append(group.cloneNode(true));
    $("compare").reading.append(group);
  }
}

async function main() {
  const begun = performance.now();
  const [script, wasm, tree, packed] = await Promise.all(
    ["script", "wasm", "tree", "texts"].map((name) => inflated(contents[name])),
  );
  const texts = JSON.parse(new TextDecoder().decode(packed));
  page.clauses = new Map(texts.clauses.map((one) => [one.id, one]));
  engine = new Engine({ script, wasm, tree, texts });
  page.desk = new Desk(engine);
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
  const named = location.hash.match(/^#open=(.*)$/);
  if (named) {
    const one = contents.gallery.find(({ name }) => name === decodeURIComponent(named[1]));
    if (!one) throw new Error("The address names no edge case of this page: choose one below.");
    await openCase(one);
  } else if (location.hash.length > 1) {
    const { sides: kept, ...document } = await fromLink(location.hash.slice(1));
    page.sides = kept ?? [];
    page.model = new Model(document);
    await refresh();
  } else if (first) await open(first.name, await inflated(first.log), first.line);
}

safely(main)();
