// The search of the site by MiniSearch. Its parts, in index.js, are fetched when the box is first used.
const box = document.getElementById("search");
const found = document.getElementById("found");

const fetched = (name) =>
  new Promise((done, failed) => {
    const script = document.createElement("script");
    script.src = box.dataset.root + name;
    script.onload = done;
    script.onerror = failed;
    document.head.append(script);
  });

const SMALL = new Set(
  "a an and are as at be by for from has in is it its of on or that the to was while with".split(" "),
);
/** What a query may say, and what the pages say. */
const SAME = [
  [/\b(airt|amb|clk|dint|irt|obs|tint|[at]15) (\d+)/g, "$1-$2"],
  [/\b(simultaneous(ly)?|same time)\b/g, "same minute equal order"],
  [/\b(retained|retentive|remanent|survives?)\b/g, "kept keeps restart"],
  [/\b(expired?|expiry|timeout)\b/g, "elapsed delay over"],
  [/\b(pending|queued)\b/g, "waits"],
  [/\bre-?trigger(s|ed)?\b/g, "started again"],
  [/\b(date|time|point) (has |is )?(past|passed|over)\b|\b(past|too late)\b/g, "after start point"],
  [/\bpriorit(y|ies)\b/g, "$& class"],
  [/\b(unblock(ed)?|enabled?)\b/g, "en_irt ends block"],
];
const NUMBERED = /\b(ob|sfc|fc|cpu)s?[ -]?(\d+)(?:( to | and | or |, |[-/])(\d+))?\b/g;
const WORD = /[a-z]\w{1,3}-\d+|[\p{L}\p{N}_]+/gu;

/** OB 80 as one word, OB 30 to 38 as a word for each. */
function numbered(_, block, from, link, to = from) {
  const all = Math.max(1, / to |-/.test(link) ? to - from + 1 : 1);
  const numbers = Array.from({ length: Math.min(all, 40) }, (_, i) => Number(from) + i);
  return [...numbers, to].map((one) => block + one).join(" ");
}

/** "Waits", "waiting" and "waited" as one word. */
const stem = (word) =>
  /^\p{L}{4,}$/u.test(word) ? word.replace(/(?<=...)(ing|ed|e?s)$/, "").replace(/(.)\1$/, "$1") : word;
/** The words of a text: an ID is one. */
const words = (text) =>
  text.toLowerCase().replace(NUMBERED, numbered)
    .match(WORD)?.filter((word) => !SMALL.has(word)).map(stem) ?? [];
/** In the index EN_AIRT stands beside its parts. */
const parts = (text) => words(text).flatMap((word) => (word.includes("_") ? [word, ...word.split("_")] : [word]));

let index = null;
async function ready() {
  await Promise.all([fetched("minisearch.js"), fetched("index.js")]);
  const fields = ["title", "within", "text"];
  const processTerm = (term) => term;
  const storeFields = ["place", "weight", ...fields];
  const made = new MiniSearch({ idField: "number", fields, storeFields, tokenize: parts, processTerm });
  made.addAll(INDEX.map((one, number) => ({ number, ...one })));
  return made;
}

/** Edge cases with most of the words, and all parts with any; many words, rare words and rules weigh most. */
function search(made, text) {
  const asked = SAME.reduce((so, [from, to]) => so.replace(from, to), text.toLowerCase());
  const hits = made.search(asked, {
    tokenize: words,
    prefix: (word) => word.length > 2,
    fuzzy: (word) => (/^\p{L}{6,}$/u.test(word) ? 0.15 : false),
    boost: { title: 3 },
    boostDocument: (_, __, { weight }) => weight,
  });
  const enough = words(text).length > 1 ? Math.max(2, new Set(words(asked)).size * 0.6) : Infinity;
  const cases = hits.filter((hit) => hit.within === "Edge cases" && hit.queryTerms.length >= enough).slice(0, 3);
  return [cases, hits.filter((hit) => !cases.includes(hit)).slice(0, 30)];
}

function item({ place, title, within, text, terms }) {
  const row = document.createElement("li");
  const link = document.createElement("a");
  const line = document.createElement("p");
  link.href = box.dataset.root + place;
  link.textContent = within ? `${title} · ${within}` : title;
  const first = text.search(new RegExp(terms.map((term) => term.replace(/([a-z])(?=\d)/, "$1 ?")).join("|"), "i"));
  const from = first > 80 ? text.lastIndexOf(" ", first - 60) + 1 : 0;
  line.textContent = (from ? "… " : "") + text.slice(from, from + 200).trim();
  row.append(link, line);
  return row;
}

function heading(text) {
  const row = document.createElement("li");
  row.className = "group";
  row.textContent = text;
  return row;
}

async function show() {
  const made = await (index ??= ready());
  const [cases, others] = box.value.trim() ? search(made, box.value) : [[], []];
  const shown = cases.length ? [heading("Edge cases"), ...cases.map(item), heading("All")] : [];
  found.replaceChildren(...shown, ...others.map(item));
}

function close() {
  box.value = "";
  found.replaceChildren();
}

box.addEventListener("focus", () => (index ??= ready()));
box.addEventListener("input", show);
found.addEventListener("click", (event) => event.target.closest("a") && setTimeout(close));
document.addEventListener("keydown", async (event) => {
  const { key, target } = event;
  if (target !== box && !found.contains(target)) return;
  if (key === "Escape") close();
  if (target === box && key === "Enter") {
    await show();
    found.querySelector("a")?.click();
  }
  if (key !== "ArrowDown" && key !== "ArrowUp") return;
  event.preventDefault();
  const places = [box, ...found.querySelectorAll("a")];
  places[places.indexOf(target) + (key === "ArrowDown" ? 1 : -1)]?.focus();
});

// A timeline shows its rejected line, also on a narrow screen.
for (const band of document.querySelectorAll(".scroll .band")) band.closest(".scroll").scrollLeft = band.getBBox().x;
