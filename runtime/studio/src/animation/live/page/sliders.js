// Parameters and starts: a slider and a number each.

/// What differs from the declaration.
const chosen = { set: {}, start: {} };

/// Rows for all that can be changed.
function showSliders({ parameters, start }) {
  const rows = [
    ...parameters.map((slider) => row("set", slider)),
    ...start.map((slider) => row("start", slider)),
  ];
  const reset = Object.assign(document.createElement("button"), { type: "reset", id: "reset", textContent: "Reset values" });
  byId("sliders").replaceChildren(...rows, reset);
  showReset();
}

/// Values are reset where some are chosen.
function showReset() {
  byId("reset").hidden = !Object.values(chosen).some((values) => Object.keys(values).length);
}

byId("sliders").addEventListener("reset", () => {
  Object.assign(chosen, { set: {}, start: {} });
  showReset();
  rerun();
});

/// The unit that a value is shown in, and the factor to it: angles of a start are degrees, as a text may have them.
function display(kind, unit) {
  const isAngle = kind === "start" && /^rad\b/.test(unit);
  return isAngle ? [unit.replace("rad", "°"), 180 / Math.PI] : [unit, 1];
}

/// A circle; else from nothing to twice a value, or both ways about nothing.
function bounds(kind, value, unit) {
  const isAngle = kind === "start" && unit === "°";
  const size = isAngle ? Math.max(180, Math.abs(value)) : value ? 2 * Math.abs(value) : kind === "set" ? 1 : 3;
  const [least, most] = kind === "set" && value >= 0 ? [0, size] : [-size, size];
  return { min: least, max: most, step: isAngle ? 0.5 : (most - least) / 400 };
}

function row(kind, { name, unit, value }) {
  const label = document.createElement("label");
  const [shownUnit, factor] = display(kind, unit);
  const shown = (value) => (value === null || value === undefined ? "" : Number((value * factor).toPrecision(12)));
  const [range, number] = ["range", "number"].map((type) => Object.assign(document.createElement("input"), { type }));
  Object.assign(range, bounds(kind, Number(shown(value)), shownUnit));
  Object.assign(number, { step: "any" });
  for (const input of [range, number]) {
    input.dataset.name = name;
    input.setAttribute("aria-label", input === range ? name : `${name}, a number`);
    // What it is reset to; a slider without a value stands in its middle.
    input.defaultValue = shown(value);
    input.value = shown(chosen[kind][name] ?? value);
    input.addEventListener("input", () => change(kind, name, factor, input, input === range ? number : range));
  }
  label.append(name, range, number, shownUnit);
  return label;
}

function change(kind, name, factor, input, other) {
  const value = Number(input.value) / factor;
  if (input.value === "" || !Number.isFinite(value)) delete chosen[kind][name];
  else chosen[kind][name] = value;
  other.value = input.value;
  showReset();
  rerun();
}
