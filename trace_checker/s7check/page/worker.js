// The Worker: the engine, compiled to WebAssembly. The runtime of its compiler stands before this text.
let engine = null;

const answers = {
  async open({ wasm, tree }) {
    engine = (await load(wasm, {})).exports;
    engine.open(new Int8Array(tree));
    return [];
  },
  // One message, or one with the bytes that follow it and more messages.
  ask({ messages }) {
    return engine
      .ask(new Int8Array(messages))
      .split("\n")
      .filter(Boolean)
      .map((line) => JSON.parse(line));
  },
};

let turn = Promise.resolve(); // a question waits until the engine is open
self.onmessage = ({ data }) => {
  turn = turn.then(() => answer(data));
};

async function answer(data) {
  try {
    self.postMessage({ id: data.id, answers: await answers[data.kind](data) });
  } catch (error) {
    const deep = error instanceof RangeError;
    self.postMessage({
      id: data.id,
      failed: deep ? "a depth that the browser does not allow" : String(error.message ?? error),
    });
  }
}
