// Elements of the page, and lists of which only what is in view is drawn.

export const $ = (id) => document.getElementById(id);

/** An element: h("button", {type: "button", onclick: f}, "text", child). */
export function h(tag, properties = {}, ...content) {
  const made = Object.assign(document.createElement(tag), properties);
  for (const [name, value] of Object.entries(properties))
    if (name.includes("-") || name === "style") made.setAttribute(name, value);
  made.append(...content.filter((one) => one !== null && one !== undefined));
  return made;
}

/** Numbers with commas or spaces between them. */
export const numbersOf = (text) =>
  text
    .split(/[\s,]+/)
    .filter(Boolean)
    .map(Number);

/** The number of a line in the log's text, the header's being 1. */
export const numberOf = (numbers, index) => numbers?.[index] ?? index + 1;

const ROW = 24;

/** A list of rows in `box`, of which those in view are drawn. */
export class Rows {
  constructor(box) {
    this.box = box;
    this.wide = h("div", { className: "wide" });
    box.replaceChildren(this.wide);
    box.addEventListener("scroll", () => requestAnimationFrame(() => this.draw()), { passive: true });
  }

  /** @param row makes the button of a row, by its number */
  show(count, current, row) {
    Object.assign(this, { count, row });
    this.wide.style.height = `${count * ROW}px`;
    const top = current * ROW;
    if (top < this.box.scrollTop || top + ROW > this.box.scrollTop + this.box.clientHeight) {
      this.box.scrollTop = Math.max(0, top - this.box.clientHeight / 2);
    }
    this.draw();
  }

  draw() {
    const first = Math.max(0, Math.floor(this.box.scrollTop / ROW) - 4);
    const end = Math.min(this.count, first + Math.ceil(this.box.clientHeight / ROW) + 8);
    const focused = this.box.contains(document.activeElement) ? document.activeElement.dataset.index : undefined;
    const rows = Array.from({ length: Math.max(0, end - first) }, (_, i) => {
      const made = this.row(first + i);
      made.style.top = `${(first + i) * ROW}px`;
      made.dataset.index = first + i;
      return made;
    });
    this.wide.replaceChildren(...rows);
    rows.find((one) => one.dataset.index === focused)?.focus({ preventScroll: true });
  }
}
