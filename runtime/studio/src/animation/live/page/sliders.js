// Parameters and starts: a slider and a number each.

/// What differs from the declaration.
const chosen = { set: {}, start: {} };

/// Rows for all that can be changed.
function showSliders({ parameters, start }) {
  const rows = [
    ...parameters.map((slider) => row("set", slider)),
    ...start.map((slider) => row("start", slider)),
  ];
  byId("sliders").replaceChildren(...rows);
}

/// From nothing to twice a value, or both ways about nothing.
function bounds(kind, value) {
  const size = value ? 2 * Math.abs(value) : kind === "set" ? 1 : 3;
  return kind === "set" && value >= 0 ? [0, size] : [-size, size];
}

function row(kind, { name, unit, value }) {
  const label = document.createElement("label");
  const known = chosen[kind][name] ?? value;
  const [range, number] = ["range", "number"].map((type) => Object.assign(document.createElement("input"), { type }));
  const [least, most] = bounds(kind, value ?? 0);
  Object.assign(range, { min: least, max: most, step: (most - least) / 400 });
  Object.assign(number, { step: "any" });
  for (const input of [range, number]) {
    input.dataset.name = name;
    input.setAttribute("aria-label", input === range ? name : `${name}, a number`);
    input.value = known ?? "";
    input.addEventListener("input", () => change(kind, name, input.value, input === range ? number : range));
  }
  if (known === null || known === undefined) range.value = (least + most) / 2;
  label.append(name, range, number, unit);
  return label;
}

function change(kind, name, text, other) {
  const value = Number(text);
  if (text === "" || !Number.isFinite(value)) delete chosen[kind][name];
  else chosen[kind][name] = value;
  other.value = text;
  rerun();
}
