// SVG and HTML elements; vectors.

/// Colours of curves, and dashes that tell them apart where they coincide or have no colour.
const INKS = 6;
const DASHES = ["", "7 3", "2 3", "9 3 2 3"];

/// A new SVG element in a parent.
function svg(name, attributes, parent) {
  const node = document.createElementNS("http://www.w3.org/2000/svg", name);
  set(node, attributes);
  parent?.append(node);
  return node;
}

/// A new HTML element in a parent.
function html(name, attributes, parent) {
  const node = document.createElement(name);
  set(node, attributes);
  parent?.append(node);
  return node;
}

function set(node, attributes) {
  for (const [name, value] of Object.entries(attributes)) {
    if (name === "text") node.textContent = value; else node.setAttribute(name, value);
  }
}

/// Shows or hides a node.
function show(node, visible) {
  node.style.display = visible ? "" : "none";
}

const byId = (id) => document.getElementById(id);

/// A place on the screen, to a hundredth of a pixel.
const px = (x) => Math.round(x * 100) / 100;

/// Points as a path.
const polyline = (points) => points.map(([x, y], i) => `${i ? "L" : "M"}${px(x)} ${px(y)}`).join("");

const finite = (point) => point.every(Number.isFinite);

const add = ([a, b], [c, d]) => [a + c, b + d];
const subtract = ([a, b], [c, d]) => [a - c, b - d];
const times = (k, [a, b]) => [k * a, k * b];
const length = ([a, b]) => Math.hypot(a, b);
const left = ([a, b]) => [-b, a];
const direction = (angle) => [Math.cos(angle), Math.sin(angle)];
const turned = (v, angle) => add(times(Math.cos(angle), v), times(Math.sin(angle), left(v)));

/// v over its length; of nothing, nothing.
const unit = (v) => times(1 / (length(v) || 1), v);
