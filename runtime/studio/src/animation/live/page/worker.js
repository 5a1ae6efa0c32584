// Derives and runs, away from the page: what takes long does not stop it.

"use strict";

let exports = null;

/// What comes of a request.
function ask(request) {
  const bytes = new TextEncoder().encode(JSON.stringify(request));
  const at = exports.input(bytes.length);
  new Uint8Array(exports.memory.buffer, at, bytes.length).set(bytes);
  exports.call();
  const told = new Uint8Array(exports.memory.buffer, exports.output(), exports.output_length());
  return JSON.parse(new TextDecoder().decode(told));
}

onmessage = async ({ data }) => {
  if (data.module) {
    exports = (await WebAssembly.instantiate(data.module, {})).exports;
    return postMessage({ ready: true });
  }
  const begun = performance.now();
  try {
    postMessage({ number: data.number, told: ask(data.request), took: performance.now() - begun });
  } catch (error) {
    postMessage({ number: data.number, failed: String(error) });
  }
};
