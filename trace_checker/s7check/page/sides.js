// The same lines under other headers: other CPUs, editions and readings.
import { $, h, numberOf } from "./elements.js";
import { asked, button, desk, drop, model, refresh, sides, step, view } from "./main.js";
import { whyNot } from "./report.js";
import { read } from "./timeline.js";

export async function showSides(number) {
  const one = model.branch;
  const made = [];
  for (const side of sides) {
    try {
      made.push(...shownSide(side, await desk.compare(one, view.after, view.look.at, side.chosen)));
    } catch (error) {
      made.push(...sideHead(side), h("p", {}, error.message));
    }
    if (number !== asked) return;
  }
  $("sides").replaceChildren(...made);
}

function sideHead(side) {
  const away = button("×", () => (drop(side), refresh()), {
    "aria-label": `without ${side.name}`,
  });
  return [h("h3", {}, side.name, " ", away)];
}

function shownSide(side, found) {
  const change = button("Go on there", () =>
    step(() => model.under(side.name, (header) => changed(header, side.chosen))),
  );
  const head = [...sideHead(side), h("p", {}, change)];
  if (found.refused) {
    if (found.refused.unusable) return [...head, h("p", {}, found.refused.unusable)];
    const text = `Line ${numberOf(model.branch.numbers, found.explained + 1)} is not possible there.`;
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
