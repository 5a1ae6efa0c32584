// The graphs: which there are, which are shown, and their keys with the values at the time shown.

/// Groups of quantities: its title, whether it is shown at first, whether zero belongs to it.
const GROUPS = {
  angle: ["Angles", true, false],
  length: ["Positions", true, false],
  "angular-rate": ["Angular rates", false, false],
  rate: ["Velocities", false, false],
  reaction: ["Reactions", true, true],
  tension: ["Tensions", true, true],
  friction: ["Friction", true, true],
  slip: ["Slip velocities", false, true],
  gap: ["Gaps", false, true],
  energy: ["Energies", true, true],
};
const CROWD = 8;

const panels = [];

function entriesOf(quantities) {
  return quantities.map((quantity, i) => ({
    quantity,
    name: motion.quantities[quantity].name,
    label: motion.quantities[quantity].label,
    ink: i % INKS,
    dash: DASHES[i % DASHES.length],
    hidden: i >= CROWD,
  }));
}

/// The entry of a curve in the key: its stroke, name and value; a press hides or shows it.
function keyEntry(list, entry, graph) {
  const button = html("button", { class: "entry", "aria-pressed": !entry.hidden, "data-quantity": entry.name }, list);
  const stroke = svg("svg", { class: "stroke", viewBox: "0 0 24 8", "aria-hidden": true }, button);
  svg("path", { class: `curve ink-${entry.ink}`, "stroke-dasharray": entry.dash, d: "M0 4H24" }, stroke);
  printed(entry.label, html("span", {}, button));
  entry.output = html("output", { "aria-live": "off" }, button);
  button.addEventListener("click", () => {
    entry.hidden = !entry.hidden;
    button.setAttribute("aria-pressed", !entry.hidden);
    graph.resize();
  });
}

/// A name in print: what follows an underscore stands lower.
function printed(label, parent) {
  label.split(/_(\w+)/).forEach((text, i) => {
    if (text) html(i % 2 ? "sub" : "span", { text: text.replaceAll("_", " ") }, parent);
  });
}

/// What all of some quantities are measured in, after a comma.
function unitOf(quantities) {
  const units = new Set(quantities.map((quantity) => motion.quantities[quantity].unit ?? ""));
  const [unit] = units;
  return units.size === 1 && unit ? `, ${unit}` : "";
}

function addPanel(title, quantities, shown, fromZero) {
  const figure = html("figure", { class: "panel" }, byId("panels"));
  printed(title + unitOf(quantities), html("h2", {}, figure));
  const key = html("div", { class: "key" }, figure);
  const entries = entriesOf(quantities);
  const graph = makeGraph(figure, entries, fromZero);
  for (const entry of entries) keyEntry(key, entry, graph);
  const button = html("button", { "aria-pressed": shown, text: title }, byId("groups"));
  show(figure, shown);
  const panel = { figure, graph, entries, shown };
  button.addEventListener("click", () => {
    panel.shown = !panel.shown;
    button.setAttribute("aria-pressed", panel.shown);
    show(figure, panel.shown);
    graph.resize();
    follow(panel, clock.t);
  });
  panels.push(panel);
}

/// Moves the cursor of a panel and writes its values.
function follow({ shown, graph, entries }, t) {
  if (!shown) return;
  graph.follow(t);
  for (const { quantity, output } of entries) {
    const now = value(quantity, t);
    // What is given in these steps has no digits below them.
    const small = Math.abs(now) < 0.5 * motion.steps[quantity];
    output.textContent = digits(small ? 0 : now);
    output.value = output.textContent;
    output.dataset.value = now;
  }
}

ofGroup("output").forEach((quantity) => addPanel(motion.quantities[quantity].label, [quantity], true, false));
for (const [group, [title, shown, fromZero]] of Object.entries(GROUPS)) {
  const quantities = ofGroup(group);
  if (quantities.length) addPanel(title, quantities, shown, fromZero);
}

onTime.push((t) => panels.forEach((panel) => follow(panel, t)));
