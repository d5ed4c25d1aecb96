// A source that is no log: the user says what it does not tell, and the engine makes a log of it.
import { $, numbersOf } from "./elements.js";

/** What the form says, as the engine takes it. */
function asked(form) {
  const { cpu, obs, mode, records, ...how } = Object.fromEntries(new FormData(form));
  const given = { cpu, obs: numbersOf(obs), ...(mode ? { mode } : {}) };
  if (records) given.records = records.split(/[\s,]+/).filter(Boolean);
  return { given, ...Object.fromEntries(Object.entries(how).filter(([, value]) => value)) };
}

/** The bytes of a log, and lines that say what it holds; null if it is no source, or the user wants none. */
export async function imported(engine, name, bytes) {
  const { kind, what } = (await engine.ask({ message: "kind", count: bytes.length }, bytes)).object;
  if (!kind) return null;
  const [title, form] = $("import").children;
  title.textContent = `${name}: ${what}`;
  $("refused").textContent = "";
  return new Promise((resolve) => {
    $("import").onclose = () => resolve(null);
    form.onsubmit = async (submitted) => {
      submitted.preventDefault();
      try {
        const message = { message: "import", kind, count: bytes.length, ...asked(form) };
        const { log, told } = (await engine.ask(message, bytes)).object;
        const text = log.map((line) => `${JSON.stringify(line)}\n`).join("");
        resolve({ bytes: new TextEncoder().encode(text), told: [`Made from ${what}.`, ...told] });
        $("import").close();
      } catch (error) {
        $("refused").textContent = error.message;
      }
    };
    $("import").showModal();
  });
}
