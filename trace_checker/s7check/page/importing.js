// What is no log, of which the engine makes one: a program, or a source, of which the user says what it does not tell.
import { $, h, numbersOf } from "./elements.js";

/** A text in the encoding that a column map names, in UTF-8. */
function inUtf8(bytes, map) {
  const { encoding = "utf-8" } = JSON.parse(new TextDecoder().decode(map));
  return new TextEncoder().encode(new TextDecoder(encoding.replace(/-sig$/, ""), { fatal: true }).decode(bytes));
}

/** A log, objects, as its bytes. */
const asBytes = (log) => new TextEncoder().encode(log.map((line) => `${JSON.stringify(line)}\n`).join(""));

/** The log of one run of a program of the kit, as of a source. Throws NoAnswer. */
export async function simulated(engine, name, bytes) {
  const { log } = (await engine.ask({ message: "simulate", count: bytes.length }, bytes)).object;
  return { bytes: asBytes(log), told: [`Made from ${name}, a program of the kit: the specification ran it.`] };
}

/** The program of several that the user chooses; null if none. */
export function chosen(name, programs) {
  const [title, form] = $("programs").children;
  title.textContent = `${name}: ${programs.length} programs of the kit`;
  form.chosen.replaceChildren(...programs.map((one, i) => h("option", { value: i }, `${one.name}: ${one.about}`)));
  return new Promise((resolve) => {
    $("programs").returnValue = "";
    $("programs").onclose = () => resolve($("programs").returnValue ? programs[form.chosen.value] : null);
    $("programs").showModal();
  });
}

/** What the form says, as the engine takes it. */
function asked(form) {
  const { cpu, obs, mode, records, columns, ...how } = Object.fromEntries(new FormData(form));
  const given = { cpu, obs: numbersOf(obs), ...(mode ? { mode } : {}) };
  if (records) given.records = records.split(/[\s,]+/).filter(Boolean);
  return { given, ...Object.fromEntries(Object.entries(how).filter(([, value]) => value)) };
}

/** The bytes of a log, and lines that say what it holds; null if it is no source, or the user wants none. */
export async function imported(engine, name, bytes) {
  let { kind, what } = (await engine.ask({ message: "kind", count: bytes.length }, bytes)).object;
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
        resolve({ bytes: asBytes(log), told: [`Made from ${what}.`, ...told] });
        $("import").close();
      } catch (error) {
        $("refused").textContent = error.message;
      }
    };
    $("import").showModal();
  });
}
