// The worker: one request after the other, the last of each kind alone where several wait.

const engine = { compiled: null, worker: null, ready: null, busy: null, waiting: [], number: 0, before: [] };

/// The engine as text: in the page, or in a script beside it.
async function packed() {
  const { textContent, dataset } = byId("engine");
  if (!dataset.from) return textContent;
  await new Promise((done, failed) => {
    const script = Object.assign(document.createElement("script"), { src: dataset.from, onload: done });
    script.onerror = () => failed(new Error(`${dataset.from} is missing`));
    document.head.append(script);
  });
  return globalThis.liftoffEngine;
}

/// Compiled while it is unpacked.
async function compiled() {
  const bytes = await fetch(`data:application/gzip;base64,${await packed()}`);
  const stream = bytes.body.pipeThrough(new DecompressionStream("gzip"));
  return WebAssembly.compileStreaming(new Response(stream, { headers: { "Content-Type": "application/wasm" } }));
}

/// Begins a worker; one that has been stopped is followed by another, which is not compiled again.
function begin() {
  const source = new Blob([byId("worker").textContent], { type: "text/javascript" });
  const worker = new Worker(URL.createObjectURL(source));
  engine.worker = worker;
  engine.ready = new Promise((done) => {
    worker.onmessage = ({ data }) => (data.ready ? done() : answered(data));
  });
  engine.compiled ??= compiled();
  engine.compiled.then((module) => worker.postMessage({ module }), (error) => wrong(`no engine: ${error.message}`));
}

/// What comes of a request; null where another of its kind has taken its place, or it was stopped.
function ask(request) {
  return new Promise((done) => {
    const older = engine.waiting.findIndex((other) => other.request.ask === request.ask);
    if (older >= 0) engine.waiting.splice(older, 1)[0].done(null);
    engine.waiting.push({ request, done });
    next();
  });
}

async function next() {
  if (engine.busy || engine.waiting.length === 0) return;
  const asked = (engine.busy = engine.waiting.shift());
  engine.number += 1;
  asked.number = engine.number;
  const { worker } = engine;
  await engine.ready;
  if (worker !== engine.worker || engine.busy !== asked) return;
  if (asked.request.ask === "derive") engine.before = asked.request;
  worker.postMessage({ number: asked.number, request: asked.request });
}

function answered({ number, told, took, failed }) {
  const asked = engine.busy;
  if (!asked || asked.number !== number) return;
  engine.busy = null;
  if (failed) {
    // What has failed within may be in any state.
    restart();
    asked.done({ told: "refused", why: `the engine failed: ${failed}` });
  } else {
    asked.done({ ...told, took });
  }
  next();
}

/// Gives up what is asked for.
function stopAsking() {
  const given = [engine.busy, ...engine.waiting].filter(Boolean);
  [engine.busy, engine.waiting] = [null, []];
  given.forEach((asked) => asked.done(null));
  restart();
}

/// A worker that knows the last text.
function restart() {
  engine.worker.terminate();
  begin();
  if (engine.before.ask) engine.waiting.unshift({ request: engine.before, done: () => {} });
  next();
}
