// The search of the site: all words must occur in a section's title or text. INDEX comes from index.js.
const box = document.getElementById("search");
const found = document.getElementById("found");
box.addEventListener("input", () => {
  const words = box.value.toLowerCase().split(/\s+/).filter(Boolean);
  const hits = words.length ? INDEX.filter(([, title, text]) => {
    const all = `${title} ${text}`.toLowerCase();
    return words.every((word) => all.includes(word));
  }) : [];
  found.replaceChildren(...hits.slice(0, 40).map(([place, title, text]) => {
    const item = document.createElement("li");
    const link = document.createElement("a");
    const line = document.createElement("p");
    link.href = box.dataset.root + place;
    link.textContent = title;
    const at = Math.max(0, text.toLowerCase().indexOf(words[0]) - 60);
    line.textContent = text.slice(at, at + 200);
    item.append(link, line);
    return item;
  }));
});
