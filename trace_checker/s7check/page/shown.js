// What the parts of the page share: what is shown, and buttons that change it.
import { $, h } from "./elements.js";
import { NoAnswer } from "./engine.js";

/** What is shown now; `main.js` sets it. */
export const page = {
  clauses: new Map(),
  desk: null,
  model: null,
  view: null, // what is shown of the branch: {explained, refused, look, after, all, impossible}
  verdict: null, // of the opened log, while its branch is unchanged
  sides: [], // the other headers: {name, chosen}
  asked: 0, // the number of the last question: answers to earlier ones are not shown
  refresh: null, // shows all parts anew
};

/** Whether the page lies in the site, beside its other pages. */
export const inSite = location.pathname.endsWith("/explorer.html");

export function problem(error) {
  $("problem").hidden = !error;
  $("problem").textContent = error
    ? error instanceof NoAnswer
      ? `No verdict: ${error.message}.`
      : (error.message ?? String(error))
    : "";
}

/** Runs what a click asks for; an error becomes a sentence on the page. */
export const safely =
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
export const step = safely(async (change) => {
  if (change() !== false) await page.refresh();
});

export function busy(what) {
  $("stop").hidden = !what;
  if (what) $("where").textContent = what;
}

export const button = (text, work, properties = {}) =>
  h("button", { type: "button", onclick: safely(work), ...properties }, text);

export const requirement = (id) => h("button", { type: "button", className: "id", onclick: () => tell(id) }, id);
export const requirements = (ids) => h("span", { className: "ids" }, ...ids.flatMap((id) => [" ", requirement(id)]));

/** What a rule says, with its letters and where it comes from. */
export function said(id) {
  const clause = page.clauses.get(id) ?? { text: "" };
  const letters = Object.entries(clause.letters ?? {}).map(([letter, answer]) => ` (${letter}) ${answer}`);
  const origin = [clause.source, clause.confidence].filter(Boolean).join("; ");
  return h("span", {}, clause.text, ...letters, " ", h("span", { className: "origin" }, origin));
}

/** A table of pairs. */
export const table = (rows) =>
  h("table", {}, ...rows.map(([key, text]) => h("tr", {}, h("td", { className: "key" }, key), h("td", {}, text))));

function tell(id) {
  const [title, text, book] = $("clause").children;
  const { home } = page.clauses.get(id) ?? {};
  title.textContent = id;
  text.replaceChildren(said(id));
  book.replaceChildren(...(inSite && home ? [h("a", { href: home }, "in the book")] : []));
  $("clause").showModal();
}

export const fields = (line) =>
  Object.entries(line)
    .filter(([name]) => !["event", "at", "up"].includes(name))
    .map(([name, value]) => `${name}=${typeof value === "object" ? JSON.stringify(value) : value}`)
    .join(" ");
