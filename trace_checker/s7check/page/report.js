// The verdict of the opened log, why its line is rejected, and the report as text and as a file.
import { $, h, numberOf } from "./elements.js";
import { button, page, requirement, requirements, said, step, table } from "./shown.js";

const LONGEST_JUDGED = 4 * 1024 * 1024; // bytes of a log that is judged by other readings
const BUDGET = 5000; // milliseconds for all of them

/** The verdict of the opened log, and why its line is rejected. */
export function showReport() {
  const one = page.model.branch;
  const { refused, explained } = page.view;
  const judged = page.verdict;
  const same = judged && judged.lines === one.lines && judged.header === one.header;
  const accepted = { verdict: "accepted", message: `${page.view.look.message} (${explained} events)` };
  const now = refused ? { verdict: refused.unusable ? "unusable" : "rejected", ...refused } : accepted;
  const { verdict, message } = same ? judged : now;
  const line = numberOf(one.numbers, explained + 1);
  $("report").hidden = false;
  $("verdict").replaceChildren(
    h("span", { className: `verdict ${verdict === "no verdict" ? "none" : verdict}` }, verdict),
    ` ${refused && !refused.unusable ? `line ${line}: ` : ""}${message}`,
  );
  $("explained").replaceChildren(...(refused && !refused.unusable ? explanation(refused, one, explained, line) : []));
  const readings = (same && judged.readings) || [];
  $("readings").replaceChildren(...shownReadings(readings));
  $("told").replaceChildren(...(same ? judged.told : []).map((line) => h("li", {}, line)));
  $("as-text").textContent = asText(`${verdict}: ${message}`, one, refused, line, readings);
}

/** How many requirements have decided something on the way of every explanation. */
export function met({ outcomes = [] }, decidable) {
  const there = new Set(outcomes);
  const all = Object.values(decidable);
  return `; ${all.filter((each) => each.some((one) => there.has(one))).length} of ${all.length} requirements decided something`;
}

/** Judges a rejected log by other CPUs, editions and letters, as long as `wanted` says so, and shows what comes of it. */
export async function tryReadings(engine, judged, bytes, wanted) {
  const { verdict, line, asked } = judged.answer;
  const { refused } = page.view;
  if (verdict !== "rejected" || bytes.length > LONGEST_JUDGED || !refused) return;
  const rules = [refused, ...refused.candidates].flatMap((one) => one.requirements);
  const message = { message: "read", count: bytes.length, others: { rules, ...(asked ? { asked } : {}) } };
  const { others = [] } = await engine.ask(message, bytes);
  const end = performance.now() + BUDGET;
  for (const one of [...others].sort((a, b) => a.distance - b.distance)) {
    if (one.same) Object.assign(one, { verdict, line });
    else if (performance.now() < end) {
      const came = await engine.judge(bytes, { chosen: one.chosen });
      one.verdict = came.verdict === "error" ? "no verdict" : came.verdict;
      one.line = came.line ?? came.unusable?.line;
    }
    if (!wanted()) return;
  }
  const tried = others.filter((one) => one.verdict);
  const untried = others.filter((one) => !one.verdict).map((one) => one.change);
  judged.readings = (await engine.ask({ message: "readings", verdict, line, tried, untried, remedy: "" })).parts;
  if (wanted()) showReport();
}

const shownReadings = (parts) =>
  parts.flatMap(([heading, lines]) => [
    h("h3", {}, heading),
    h("ul", {}, ...lines.map((line) => h("li", {}, ...linked(line)))),
  ]);

function explanation(refused, one, index, line) {
  const texts = refused.requirements.map((id) => [requirement(id), said(id)]);
  const situations = refused.situations.flatMap(({ said }, i) => [
    h("h3", {}, `The CPU before the line${refused.states > 1 ? ` (${i + 1} of ${refused.states})` : ""}`),
    table(said),
  ]);
  const choices = refused.wanted.map((text, i) => instead(text, refused.instead[i], index));
  return [
    h("pre", { className: "quote" }, one.lines[index]),
    h("p", {}, ...linked(refused.why)),
    h(
      "p",
      {},
      refused.late ? "This had to come before: " : "Possible here: ",
      ...(choices.length ? choices : ["nothing"]),
    ),
    h("h3", {}, "Requirements that decide"),
    table(texts),
    ...situations,
    because(refused),
    h("p", { className: "origin" }, `The shortest prefix that fails: lines 1 to ${line}.`),
  ].filter(Boolean);
}

/** The report with its timeline, nodes, as the text of a page that needs nothing else. */
export function asPage(title, timeline) {
  const report = $("report").cloneNode(true);
  report.querySelectorAll(".live").forEach((one) => one.remove());
  const main = h("main", {}, h("h1", {}, title), report, ...timeline);
  const named = new Set();
  for (const one of main.querySelectorAll("button")) {
    const id = one.classList.contains("id") ? one.textContent : null;
    if (id) named.add(id);
    const { className, textContent } = one;
    const plain = id ? h("a", { href: `#${id}` }, id) : h("span", { className }, textContent);
    if (one.dataset.index) plain.dataset.index = one.dataset.index;
    plain.style.cssText = one.style.cssText;
    one.replaceWith(plain);
  }
  const rows = [...named].sort().map((id) => [h("span", { id }, id), said(id)]);
  if (rows.length) main.append(h("section", {}, h("h2", {}, "Requirements and readings"), table(rows)));
  const head = h(
    "head",
    {},
    h("meta", { charset: "utf-8" }),
    h("title", {}, title),
    document.querySelector("style").cloneNode(true),
  );
  head.firstChild.setAttribute("charset", "utf-8");
  const body = h("body", {}, document.querySelector(".patterns").cloneNode(true), main);
  return `<!DOCTYPE html>\n${h("html", { lang: "en" }, head, body).outerHTML}\n`;
}

function asText(said, one, refused, line, readings) {
  if (!refused || refused.unusable) return `${one.name}: ${said}`;
  const { decision, rules, before, formulas } = refused;
  const prefix = ["shortest prefix that fails", [`lines 1 to ${line}`]];
  const parts = [...decision, ["", rules], prefix, ...before, ...readings, ...(formulas.length ? [["formulas", formulas]] : [])];
  const texts = parts.flatMap(([heading, lines]) =>
    heading && lines.length === 1
      ? [`  ${heading}: ${lines[0]}`]
      : [...(heading ? [`  ${heading}:`] : []), ...lines.map((text) => `    ${text}`)],
  );
  return [`${one.name}:${line}: ${said}`, `    ${one.lines[page.view.explained]}`, ...texts].join("\n");
}

/** A button that puts these lines in the place of the rejected one; a text where there are none. */
const instead = (text, lines, index) =>
  lines
    ? button(text, () => step(() => page.model.replace(index, ...lines)), { className: "choice" })
    : h("span", {}, ` ${text} `);

const ID = /\b[A-Z]+\d*-\d{2,}\b/g;

/** A text in which each requirement can be asked for. */
function linked(text) {
  const parts = [];
  let from = 0;
  for (const found of text.matchAll(ID)) {
    if (!page.clauses.has(found[0])) continue;
    parts.push(text.slice(from, found.index), requirement(found[0]));
    from = found.index + found[0].length;
  }
  return [...parts, text.slice(from)];
}

/** Why a line is not possible: the sentence, what is instead, the other requirements, the formulas. */
export const whyNot = (refused) =>
  [
    h("p", {}, ...linked(refused.why), requirements(refused.requirements.filter((id) => !refused.why.includes(id)))),
    h("p", {}, `Possible: ${refused.wanted.join(", ") || "nothing"}`),
    because(refused),
  ].filter(Boolean);

const because = (refused) =>
  refused.formulas.length
    ? h(
        "details",
        {},
        h("summary", {}, "Formulas"),
        h("ul", { className: "because" }, ...refused.formulas.map((one) => h("li", {}, ...linked(one)))),
      )
    : null;
