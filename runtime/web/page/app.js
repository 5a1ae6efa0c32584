// The text, what is wrong with it, and what comes of it.

const gallery = JSON.parse(byId("texts").textContent);
let described = null;

/// The text and what is chosen, in the address behind `#`: no server sees it. It is data: nothing of it is run.
function shared() {
  try {
    const { text, set, start } = JSON.parse(decodeURIComponent(escape(atob(location.hash.slice(1)))));
    const numbers = (values) => Object.fromEntries(Object.entries(values ?? {}).filter(([, x]) => Number.isFinite(x)));
    return typeof text === "string" ? { text, set: numbers(set), start: numbers(start) } : null;
  } catch {
    return null;
  }
}

byId("share").addEventListener("click", async () => {
  const data = JSON.stringify({ text: editor.text(), ...chosen });
  location.hash = btoa(unescape(encodeURIComponent(data)));
  try {
    await navigator.clipboard.writeText(location.href);
    tell("copied");
  } catch {
    tell("the link is in the address");
  }
});

function tell(text) {
  byId("told").textContent = text;
}

function wrong(text) {
  byId("wrong").textContent = text ?? "";
  byId("wrong").hidden = !text;
}

/// Derives the text; what is wrong stands under its words, and the last motion stays.
async function derive() {
  const text = editor.text();
  const model = byId("which").hidden ? null : byId("models").value;
  const told = await busy(ask({ ask: "derive", text, model }));
  if (!told || text !== editor.text()) return;
  const mistakes = told.mistakes ?? [];
  editor.mark(mistakes.map(({ from, to, text }) => ({ from, to, severity: "error", message: text })));
  wrong(told.why ?? mistakes.map((mistake) => mistake.text).join("\n"));
  if (told.told !== "model") return;
  const names = JSON.stringify(told.models);
  if (byId("models").dataset.names !== names) {
    byId("models").replaceChildren(...told.models.map((name) => new Option(name)));
    byId("models").dataset.names = names;
  }
  byId("which").hidden = told.models.length < 2;
  for (const [kind, list] of [["set", told.parameters], ["start", told.start]]) {
    for (const name of Object.keys(chosen[kind])) {
      if (!list.some((slider) => slider.name === name)) delete chosen[kind][name];
    }
  }
  described = told;
  showSliders(told);
  byId("drawing").innerHTML = told.drawing ?? "a parameter has no value";
  if (!frames.shown) byId("motion").innerHTML = told.drawing ?? "";
  document.body.dataset.drawn ??= performance.now();
  showEquations();
  rerun();
}

async function showEquations() {
  if (!byId("derived").open || !described) return;
  const told = await ask({ ask: "equations" });
  if (told?.html) byId("equations").innerHTML = told.html;
}

/// Runs with what is chosen.
async function rerun() {
  if (!described) return;
  // A start that is given replaces the declared one.
  const own = Object.fromEntries(described.start.filter(({ value }) => value !== null).map(({ name, value }) => [name, value]));
  const start = Object.keys(chosen.start).length ? { ...own, ...chosen.start } : {};
  const told = await busy(ask({ ask: "run", set: chosen.set, start }));
  if (!told) return;
  wrong(told.why ?? told.stopped);
  if (told.told !== "motion") return;
  showMotion(told.page);
  byId("events").replaceChildren(...told.events.map((text) => Object.assign(document.createElement("li"), { textContent: text })));
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
byId("derived").addEventListener("toggle", showEquations);
byId("models").addEventListener("change", derive);

let typed = null;
const begun = shared();
if (begun) Object.assign(chosen, { set: begun.set, start: begun.start });
const editor = codemirror.editor(byId("text"), begun?.text ?? gallery[0].text, () => {
  clearTimeout(typed);
  typed = setTimeout(derive, 250);
});
byId("gallery").replaceChildren(...gallery.map(({ name }) => new Option(name)));
if (begun) byId("gallery").prepend(new Option("(the link's)", "", true, true));
byId("gallery").addEventListener("change", () => {
  const found = gallery.find(({ name }) => name === byId("gallery").value);
  if (!found) return;
  Object.assign(chosen, { set: {}, start: {} });
  frames.at = null;
  editor.replace(found.text);
});
derive();
