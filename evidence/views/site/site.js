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

const SMALL = new Set("a an and are as at be by for from has in is it its of on or that the to was while with".split(" "));
let index = null;
async function ready() {
  await Promise.all([fetched("minisearch.js"), fetched("index.js")]);
  const fields = ["title", "within", "text"];
  const processTerm = (term) => (SMALL.has(term.toLowerCase()) ? null : term.toLowerCase());
  const made = new MiniSearch({ idField: "number", fields, storeFields: ["place", "weight", ...fields], processTerm });
  made.addAll(INDEX.map((one, number) => ({ number, ...one })));
  return made;
}

/** The parts that have any of the words; many words, rare words and rules weigh most. */
const search = (made, text) =>
  made.search(text, {
    prefix: (word) => word.length > 2,
    fuzzy: (word) => (word.length > 5 ? 0.15 : false),
    boost: { title: 3 },
    boostDocument: (_, __, { weight }) => weight,
  });

function item({ place, title, within, text, terms }) {
  const row = document.createElement("li");
  const link = document.createElement("a");
  const line = document.createElement("p");
  link.href = box.dataset.root + place;
  link.textContent = within ? `${title} · ${within}` : title;
  const first = Math.min(...terms.map((term) => text.toLowerCase().indexOf(term)).filter((at) => at >= 0));
  const from = first > 80 && Number.isFinite(first) ? text.lastIndexOf(" ", first - 60) + 1 : 0;
  line.textContent = (from ? "… " : "") + text.slice(from, from + 200).trim();
  row.append(link, line);
  return row;
}

box.addEventListener("focus", () => (index ??= ready()));
box.addEventListener("input", async () => {
  const made = await (index ??= ready());
  found.replaceChildren(...(box.value.trim() ? search(made, box.value).slice(0, 30).map(item) : []));
});

// A timeline shows its rejected line, also on a narrow screen.
for (const band of document.querySelectorAll(".scroll .band")) band.closest(".scroll").scrollLeft = band.getBBox().x;
