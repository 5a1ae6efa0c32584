// The text, what is wrong with it, and what comes of it.

const gallery = JSON.parse(byId("texts").textContent);

/// A text with what is chosen, from elsewhere: numbers alone.
function admitted({ text, set, start } = {}) {
  const numbers = (values) => Object.fromEntries(Object.entries(values ?? {}).filter(([, x]) => Number.isFinite(x)));
  return typeof text === "string" ? { text, set: numbers(set), start: numbers(start) } : null;
}

/// The text and what is chosen, in the address behind `#`: no server sees it. It is data: nothing of it is run.
function shared() {
  try {
    return admitted(JSON.parse(decodeURIComponent(escape(atob(location.hash.slice(1))))));
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

/// The texts so far, each with what was chosen, and which of them is shown; the browser keeps them.
const past = { states: [], at: -1 };
const KEPT = "liftoff";
const MOST = 100;

function restore() {
  try {
    const { states, at } = JSON.parse(localStorage.getItem(KEPT));
    const kept = states.map(admitted);
    if (kept[at] && kept.every(Boolean)) Object.assign(past, { states: kept, at });
  } catch {
    // Nothing is kept, or nothing of ours.
  }
}

/// Adds what is shown now, in place of what was undone.
function remember({ leaves = false } = {}) {
  const now = { text: editor.text(), set: { ...chosen.set }, start: { ...chosen.start } };
  if (JSON.stringify(now) !== JSON.stringify(past.states[past.at])) {
    past.states = [...past.states.slice(0, past.at + 1), now].slice(-MOST);
    past.at = past.states.length - 1;
    // The link in the address is of another text, unless the page goes where it leads.
    if (location.hash && !leaves) history.replaceState(null, "", "#");
  }
  keep();
}

function keep() {
  byId("undo").disabled = past.at <= 0;
  byId("redo").disabled = past.at >= past.states.length - 1;
  byId("gallery").value = gallery.find(({ text }) => text === editor.text())?.name ?? "";
  try {
    localStorage.setItem(KEPT, JSON.stringify(past));
  } catch {
    tell("the browser keeps no text: a reload loses it");
  }
}

function step(by) {
  remember();
  const state = past.states[past.at + by];
  if (!state) return;
  past.at += by;
  Object.assign(chosen, { set: { ...state.set }, start: { ...state.start } });
  editor.replace(state.text);
  keep();
}

byId("undo").addEventListener("click", () => step(-1));
byId("redo").addEventListener("click", () => step(1));
for (const kind of ["change", "reset"]) byId("sliders").addEventListener(kind, () => remember());
addEventListener("pagehide", () => remember({ leaves: true }));

byId("csv").addEventListener("click", async () => {
  const told = await busy(ask({ ask: "table", ...chosen }));
  if (!told?.csv) return wrong(told?.why);
  const href = URL.createObjectURL(new Blob([told.csv], { type: "text/csv" }));
  Object.assign(document.createElement("a"), { href, download: `${described.name}.csv` }).click();
  URL.revokeObjectURL(href);
});

/// Shows one of the views.
function look(view) {
  for (const tab of document.querySelectorAll("nav [role=tab]")) {
    const isSeen = tab.getAttribute("aria-controls") === view;
    tab.setAttribute("aria-selected", isSeen);
    byId(tab.getAttribute("aria-controls")).classList.toggle("seen", isSeen);
  }
  showEquations();
}

document.querySelector("nav").addEventListener("click", ({ target }) => {
  if (target.role === "tab") look(target.getAttribute("aria-controls"));
});

/// Derives a text; what is wrong stands under its words, and the last motion stays.
async function derive(text) {
  const model = byId("which").hidden ? null : byId("models").value;
  const told = await busy(ask({ ask: "derive", text, model }));
  if (!told || text !== editor.text()) return;
  const mistakes = told.mistakes ?? [];
  editor.mark(mistakes.map(({ from, to, text }) => ({ from, to, severity: "error", message: text })));
  wrong(told.why ?? mistakes.map((mistake) => mistake.text).join("\n"));
  if (told.told === "model") describe(told);
  remember();
  if (told.told !== "model") return;
  showEquations();
  rerun();
}

/// Shows a model: its drawing, what can be chosen of it, and which others its text has.
function describe(told) {
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
  document.body.dataset.drawn ??= performance.now();
}

async function showEquations() {
  if (!byId("derived").classList.contains("seen") || !described) return;
  const told = await ask({ ask: "equations" });
  if (told?.html) byId("equations").innerHTML = told.html;
}

byId("models").addEventListener("change", () => derive(editor.text()));

restore();
const begun = shared() ?? past.states[past.at];
if (begun) {
  Object.assign(chosen, { set: { ...begun.set }, start: { ...begun.start } });
} else {
  // The first of the gallery has been derived when the page was made.
  describe(JSON.parse(byId("first").textContent));
  const still = byId("drawing").querySelector("svg").cloneNode(true);
  byId("player").prepend(still);
}
const text = begun?.text ?? gallery[0].text;
derive(text);

let typed = null;
const editor = codemirror.editor(byId("text"), text, (changed) => {
  clearTimeout(typed);
  typed = setTimeout(() => derive(changed), 250);
});
const own = Object.assign(new Option("(your text)", ""), { disabled: true });
byId("gallery").replaceChildren(own, ...gallery.map(({ name }) => new Option(name)));
byId("gallery").addEventListener("change", () => {
  const found = gallery.find(({ name }) => name === byId("gallery").value);
  remember();
  Object.assign(chosen, { set: {}, start: {} });
  editor.replace(found.text);
});
look("moving");
remember();
