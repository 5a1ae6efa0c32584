// The text, what is wrong with it, and what comes of it.

const gallery = JSON.parse(byId("texts").textContent);

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

/// Derives a text; what is wrong stands under its words, and the last motion stays.
async function derive(text) {
  const model = byId("which").hidden ? null : byId("models").value;
  const told = await busy(ask({ ask: "derive", text, model }));
  if (!told || text !== editor.text()) return;
  const mistakes = told.mistakes ?? [];
  editor.mark(mistakes.map(({ from, to, text }) => ({ from, to, severity: "error", message: text })));
  wrong(told.why ?? mistakes.map((mistake) => mistake.text).join("\n"));
  if (told.told !== "model") return;
  describe(told);
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
  if (!byId("derived").open || !described) return;
  const told = await ask({ ask: "equations" });
  if (told?.html) byId("equations").innerHTML = told.html;
}

byId("derived").addEventListener("toggle", showEquations);
byId("models").addEventListener("change", () => derive(editor.text()));

const begun = shared();
if (begun) {
  Object.assign(chosen, { set: begun.set, start: begun.start });
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
byId("gallery").replaceChildren(...gallery.map(({ name }) => new Option(name)));
if (begun) byId("gallery").prepend(new Option("(the link's)", "", true, true));
byId("gallery").addEventListener("change", () => {
  const found = gallery.find(({ name }) => name === byId("gallery").value);
  if (!found) return;
  Object.assign(chosen, { set: {}, start: {} });
  editor.replace(found.text);
});
