// What is no log, of which the engine makes one: a program, or a source, of which the user says what it does not tell;
// and files that are packed.
import { $, h, numbersOf } from "./elements.js";
import { utf8 } from "./engine.js";
import { unzipped } from "./model.js";

const GZIP = [0x1f, 0x8b, 8];
const OF_LENGTHS = 8; // the last bytes of gzip, a sum and a length, may be zero
const ZIP = [0x50, 0x4b, 0x03, 0x04];
const OF_KIT = "a program of the kit: the specification ran it";

const has = (bytes, marks, at = 0) => marks.every((mark, i) => bytes[at + i] === mark);

/** A piece that gzip has packed, before zero bytes of padding, of which some may be its own; null if it is damaged. */
async function plainPiece(bytes) {
  let end = bytes.length;
  let plain = await unzipped(bytes).catch(() => null);
  while (end && !bytes[end - 1]) end--;
  for (const most = Math.min(end + OF_LENGTHS, bytes.length - 1); !plain && end <= most; end++)
    plain = await unzipped(bytes.subarray(0, end)).catch(() => null);
  return plain;
}

/** What gzip has packed in one piece, or several one after another; null if they are damaged. */
async function plainOf(bytes) {
  const whole = await plainPiece(bytes);
  if (whole) return whole;
  for (let at = 1; (at = bytes.indexOf(GZIP[0], at)) > 0; at++) {
    if (!has(bytes, GZIP, at)) continue;
    const first = await plainPiece(bytes.subarray(0, at)); // it has a sum of its content at its end
    const rest = first && (await plainOf(bytes.subarray(at)));
    if (rest) return new Uint8Array(await new Blob([first, rest]).arrayBuffer());
  }
  return null;
}

/** Name and bytes of a file, unpacked as `s7check trace` does. Throws an Error that says why that cannot be. */
export async function unpacked(name, bytes) {
  if (has(bytes, ZIP)) throw new Error(`${name} is a zip archive: take the log out of it and open that.`);
  if (!name.endsWith(".gz") && !has(bytes, GZIP)) return { name, bytes };
  const plain = await plainOf(bytes);
  if (!plain) throw new Error(`${name}: unusable: expected a sound gzip file; found one damaged, incomplete or too large`);
  return { name: name.replace(/\.gz$/, ""), bytes: plain };
}

/** A log in UTF-8 without a byte order mark, which may name UTF-16. */
export function asUtf8(bytes) {
  const utf16 = { "255,254": "utf-16le", "254,255": "utf-16be" }[bytes.subarray(0, 2)];
  if (utf16) return utf8.encode(new TextDecoder(utf16).decode(bytes));
  return has(bytes, [0xef, 0xbb, 0xbf]) ? bytes.subarray(3) : bytes;
}

/** A text in the encoding that a column map names, in UTF-8. */
function inUtf8(bytes, map) {
  const { encoding = "utf-8" } = JSON.parse(new TextDecoder().decode(map));
  return utf8.encode(new TextDecoder(encoding.replace(/-sig$/, ""), { fatal: true }).decode(bytes));
}

/** A log, objects, as its bytes. */
const asBytes = (log) => utf8.encode(log.map((line) => `${JSON.stringify(line)}\n`).join(""));

const withoutEnding = (name) => name.replace(/\.\w+$/, "");

/** What the form of a program says, as the engine takes it. */
function how(form) {
  const readings = Array.from(form.readings.selectedOptions, ({ value }) => value.split(" "));
  const twice = readings.find(([name], i) => readings[i + 1]?.[0] === name);
  if (twice) throw new Error(`${twice[0]}: choose one answer`);
  const seed = form.seed.value === "" ? {} : { seed: Number(form.seed.value) };
  return { ...seed, ...(readings.length ? { readings: Object.fromEntries(readings) } : {}) };
}

/** Runs a program of those in a file as its form says: the log, as of a source; shows the outcomes if all are wanted. */
async function simulated(engine, name, programs, all) {
  const [, form] = $("programs").children;
  $("not-run").textContent = $("outcomes").textContent = "";
  const { name: own, text } = programs[form.chosen.value];
  const chosen = how(form);
  const bytes = utf8.encode(text);
  const message = { message: "simulate", count: bytes.length, ...chosen, ...(all ? { all } : {}) };
  const made = (await engine.ask(message, bytes)).object;
  if (all) {
    const end = `${made.outcomes} outcome${made.outcomes > 1 ? "s" : ""}`;
    $("outcomes").textContent = [...made.text, end].join("\n");
    return null;
  }
  const letters = Object.entries(chosen.readings ?? {}).map((pair) => `, ${pair.join(" ")}`);
  const by = `${"seed" in chosen ? `, by the number ${chosen.seed}` : ""}${letters.join("")}`;
  const [from, to] = programs.length > 1 ? [own, own] : [name, withoutEnding(name)];
  return { name: to, bytes: asBytes(made.log), told: [`Made from ${from}, ${OF_KIT}${by}.`], again: true };
}

/** The log of one of the programs, which the user chooses with how it is run; null if the user wants none. */
async function run(engine, name, programs) {
  const only = utf8.encode(programs[0].text);
  if (programs.length === 1) await engine.ask({ message: "program", count: only.length }, only); // told at once
  const [title, form] = $("programs").children;
  const said = `${name}: ${programs.length > 1 ? `${programs.length} programs` : "a program"} of the kit`;
  if (title.textContent !== said) form.reset();
  title.textContent = said;
  form.chosen.replaceChildren(...programs.map((one, i) => h("option", { value: i }, `${one.name}: ${one.about}`)));
  $("not-run").textContent = $("outcomes").textContent = "";
  let running = false;
  return new Promise((resolve) => {
    $("programs").onclose = () => {
      if (running) engine.stop();
      resolve(null);
    };
    form.onsubmit = async (submitted) => {
      submitted.preventDefault();
      if (running) return;
      running = true;
      const made = await simulated(engine, name, programs, submitted.submitter?.value === "all").catch((error) => {
        $("not-run").textContent = error.message;
      });
      running = false;
      if (!made) return;
      resolve(made);
      $("programs").close();
    };
    $("programs").showModal();
  });
}

/**
 * The log that is `made` of a file which is none: its name, bytes, lines that say what it holds, and whether it can be
 * made again in another way. Without it, if nothing makes one or the user wants none; perhaps with why it is `refused`.
 */
export async function madeOf(engine, name, bytes) {
  const { kind, what, programs } = (await engine.ask({ message: "kind", count: bytes.length }, bytes)).object;
  if (kind !== "program") return { made: await imported(engine, name, bytes, kind, what) };
  try {
    const made = await run(engine, name, programs);
    return made ? { made } : { refused: "it is a program of the kit, and was not run" };
  } catch (error) {
    if (!error.answer) throw error;
    return { refused: error.message };
  }
}

/** What the form says, as the engine takes it. */
function asked(form) {
  const { cpu, obs, mode, records, columns, ...how } = Object.fromEntries(new FormData(form));
  const given = { cpu, obs: numbersOf(obs), ...(mode ? { mode } : {}) };
  if (records) given.records = records.split(/[\s,]+/).filter(Boolean);
  return { given, ...Object.fromEntries(Object.entries(how).filter(([, value]) => value)) };
}

/** The log of a source; null if it is none, or the user wants none. */
function imported(engine, name, bytes, kind, what) {
  if (!kind && !/\.csv$/i.test(name)) return null;
  kind ??= "csv";
  what ??= "a table";
  const [title, form] = $("import").children;
  title.textContent = `${name}: ${what}`;
  $("refused").textContent = "";
  form.columns.parentElement.hidden = kind !== "csv";
  form.columns.required = kind === "csv";
  form.dates.parentElement.hidden = kind !== "step7";
  return new Promise((resolve) => {
    $("import").onclose = () => resolve(null);
    form.onsubmit = async (submitted) => {
      submitted.preventDefault();
      try {
        const message = { message: "import", kind, ...asked(form) };
        let content = bytes;
        if (kind === "csv") {
          const map = new Uint8Array(await form.columns.files[0].arrayBuffer());
          content = inUtf8(bytes, map);
          message.map = Array.from(map, (one) => String.fromCharCode(one)).join("");
        }
        const { log, told } = (await engine.ask({ ...message, count: content.length }, content)).object;
        resolve({ name: withoutEnding(name), bytes: asBytes(log), told: [`Made from ${what}.`, ...told] });
        $("import").close();
      } catch (error) {
        $("refused").textContent = error.message;
      }
    };
    $("import").showModal();
  });
}
