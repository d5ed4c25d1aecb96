// The verdict of the opened log, why its line is rejected, and the report as text.
import { $, h, numberOf } from "./elements.js";
import { button, page, requirement, requirements, step } from "./shown.js";
import { read } from "./timeline.js";

/** The verdict of the opened log, and why its line is rejected. */
export function showReport() {
  const one = page.model.branch;
  const { refused, explained } = page.view;
  const judged = page.verdict;
  const same = judged && judged.lines === one.lines && judged.header === one.header;
  const said = same
    ? judged
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
  $("told").replaceChildren(...(same ? judged.told : []).map((line) => h("li", {}, line)));
  $("as-text").textContent = asText(said.verdict, words, one, refused, line);
}

function explanation(refused, one, index) {
  const texts = refused.requirements.map((id) => h("li", {}, requirement(id), ` ${page.clauses.get(id)?.text ?? ""}`));
  const choices = refused.instead.map((each, i) => instead(each, refused.expected[i], index, one.lines[index]));
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
    h("ul", {}, ...texts),
    because(refused),
  ].filter(Boolean);
}

function asText(name, words, one, refused, line) {
  const text = [`${one.name}${refused ? `:${line}` : ""}: ${name}: ${words}`];
  if (!refused || refused.unusable) return text[0];
  text.push(
    `    ${one.lines[page.view.explained]}`,
    `  ${refused.late ? "expected before it" : "expected"}: ${refused.expected.join(", ") || "nothing"}`,
  );
  text.push(`  requirements: ${refused.requirements.join(", ")}`, `  why not: ${refused.why}`);
  for (const id of refused.requirements) text.push(`    ${id} ${page.clauses.get(id)?.text ?? ""}`);
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
    same && !page.view.refused.late
      ? [{ ...line, ...one, ...(one.info ? { info: { ...line.info, ...one.info } } : {}) }]
      : [{ at: page.view.look.clock, ...one }];
  const texts = changed.map((each) => JSON.stringify(each));
  return button(
    text,
    () => step(() => page.model.replace(index, ...(same && !page.view.refused.late ? texts : [...texts, given]))),
    { className: "choice" },
  );
}

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
    h("p", {}, `Possible: ${refused.expected.join(", ") || "nothing"}`),
    because(refused),
  ].filter(Boolean);

const because = (refused) =>
  refused.because.length
    ? h(
        "details",
        {},
        h("summary", {}, "Formulas"),
        h("ul", { className: "because" }, ...refused.because.map((one) => h("li", {}, formula(one)))),
      )
    : null;
