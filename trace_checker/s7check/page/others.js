// The timelines of the branches that are not chosen, below that of the chosen one.
import { $, h } from "./elements.js";
import { button, page, step } from "./shown.js";
import { Timeline } from "./timeline.js";

const MOST = 8;

/** The name of the session with the lines of a branch. */
export const sessionOf = (one) => JSON.stringify(["branch", one.header, one.name]);

/** Shows them, unless a later click has asked something else than the one with this number. */
export async function showOthers(number) {
  const { branches, current } = page.model.document;
  const others = branches.map((one, i) => ({ one, i })).filter(({ i }) => i !== current);
  $("others").replaceChildren();
  for (const { one, i } of others.slice(0, MOST)) {
    const session = sessionOf(one);
    const { explained, refused } = await page.desk.bring(one, session);
    if (number !== page.asked) return;
    const box = h("div", { className: "scroll timeline", role: "region", "aria-label": `Timeline of ${one.name}` });
    const title = button(one.name, () => step(() => page.model.choose(i)));
    $("others").append(h("h3", {}, title), box);
    const states = (first, last) => page.desk.states(first, last, session);
    const timeline = new Timeline(box, states, (index) => step(() => page.model.choose(i, index)));
    const wrong = refused ? explained + 1 : -1;
    await timeline.show([one.header, ...one.lines], one.shown, explained, wrong, one.numbers);
  }
}
