// The same lines under other headers: other CPUs, editions and readings.
import { $, h, numberOf } from "./elements.js";
import { whyNot } from "./report.js";
import { button, page, step } from "./shown.js";
import { read } from "./timeline.js";

export async function showSides(number) {
  const one = page.model.branch;
  const made = [];
  for (const side of page.sides) {
    try {
      made.push(...shownSide(side, await page.desk.compare(one, page.view.after, page.view.look.at, side.chosen)));
    } catch (error) {
      made.push(...sideHead(side), h("p", {}, error.message));
    }
    if (number !== page.asked) return;
  }
  $("sides").replaceChildren(...made);
}

/** Compares with this header no more. */
function drop(side) {
  page.sides = page.sides.filter((one) => one !== side);
}

function sideHead(side) {
  const away = button("×", () => (drop(side), page.refresh()), {
    "aria-label": `without ${side.name}`,
  });
  return [h("h3", {}, side.name, " ", away)];
}

function shownSide(side, found) {
  const change = button("Go on there", () =>
    step(() => page.model.under(side.name, (header) => changed(header, side.chosen))),
  );
  const head = [...sideHead(side), h("p", {}, change)];
  if (found.refused) {
    if (found.refused.unusable) return [...head, h("p", {}, found.refused.message)];
    const text = `Line ${numberOf(page.model.branch.numbers, found.explained + 1)} is not possible there.`;
    return [...head, h("p", {}, text), ...whyNot(found.refused)];
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
