// The motion of what is chosen.

/// The model and its run.
let described = null;

function tell(text) {
  byId("told").textContent = text;
}

function wrong(text) {
  byId("wrong").textContent = text ?? "";
  byId("wrong").hidden = !text;
}

/// Runs with what is chosen in place of what is given.
async function rerun() {
  if (!described) return;
  const { spec, outputs } = described;
  const told = await busy(ask({ ask: "run", spec, outputs, ...chosen }));
  if (!told) return;
  wrong(told.why ?? told.stopped);
  if (told.told !== "motion") return;
  showMotion(told.played);
  const line = (text) => Object.assign(document.createElement("li"), { textContent: text });
  byId("happened")?.querySelector("ol").replaceChildren(...told.events.map(line));
  tell(`run in ${told.took.toFixed(0)} ms`);
}

/// What comes of a request; one that takes long can be stopped.
async function busy(request) {
  const late = setTimeout(() => (byId("stop").hidden = false), 500);
  const told = await request;
  clearTimeout(late);
  if (!engine.busy) byId("stop").hidden = true;
  return told;
}

byId("stop").addEventListener("click", () => {
  stopAsking();
  byId("stop").hidden = true;
  tell("stopped");
});
