// From the model's plane to the picture: X = x₀ + k x, Y = y₀ − k y in pixels.

const MARGIN = 56;

const stage = byId("stage");
const layers = Object.fromEntries(
  ["scenery", "trails", "bodies", "cones", "marks", "forces", "words", "ruler"].map((name) => [name, svg("g", { class: name }, stage)]),
);

const view = { k: 1, origin: [0, 0], size: [1, 1], fitted: true, follows: false, held: [0, 0] };

const toScreen = ([x, y]) => [view.origin[0] + view.k * x, view.origin[1] - view.k * y];
const toWorld = ([X, Y]) => [(X - view.origin[0]) / view.k, (view.origin[1] - Y) / view.k];

/// Everything that must be drawn anew when the view changes.
const onView = [];

function viewChanged() {
  set(stage, { "data-k": view.k, "data-x": view.origin[0], "data-y": view.origin[1] });
  for (const draw of onView) draw();
}

/// The rectangle to show: the motion, and what stands still and has a place.
function shown() {
  const [x0, y0, x1, y1] = extent();
  const [xs, ys] = [[x0, x1], [y0, y1]];
  for (const { at, shape, radius = 0 } of motion.scenery) {
    if (shape === "line") continue;
    xs.push(at[0] - radius, at[0] + radius);
    ys.push(at[1] - radius, at[1] + radius);
  }
  const [across, up] = [range(xs.filter(Number.isFinite)), range(ys.filter(Number.isFinite))];
  return across.length && up.length ? [across[0], up[0], across[1], up[1]] : [0, 0, 1, 1];
}

function fit() {
  const [x0, y0, x1, y1] = shown();
  const [width, height] = view.size;
  const room = [width, height].map((side) => Math.max(side - 2 * MARGIN, side / 2));
  const k = Math.min(room[0] / (x1 - x0), room[1] / (y1 - y0));
  view.k = Number.isFinite(k) ? k : room[0];
  view.origin = [width / 2 - (view.k * (x0 + x1)) / 2, height / 2 + (view.k * (y0 + y1)) / 2];
  view.fitted = true;
  viewChanged();
}

/// Zooms about a place of the picture that stays where it is.
function zoom(factor, [X, Y]) {
  view.k *= factor;
  view.origin = add([X, Y], times(factor, subtract(view.origin, [X, Y])));
  view.fitted = false;
  viewChanged();
}

function pan(by) {
  view.origin = add(view.origin, by);
  view.fitted = false;
  viewChanged();
}

function resize() {
  const { width, height } = stage.getBoundingClientRect();
  if (!width || !height) return;
  const grown = subtract([width, height], view.size);
  view.size = [width, height];
  stage.setAttribute("viewBox", `0 0 ${width} ${height}`);
  if (view.fitted) return fit();
  pan(times(0.5, grown));
}

/// The middle of all points at a time.
function middle(t) {
  const places = motion.points.map((_, i) => position(i, t)).filter(finite);
  return times(1 / (places.length || 1), places.reduce(add, [0, 0]));
}

/// Keeps the middle of the system where it is from now on, or no more.
function setFollow(on, t) {
  view.follows = on;
  view.held = toScreen(middle(t));
}

/// Shifts the view so that the middle of the system is where it is held.
function followTo(t) {
  const shift = subtract(view.held, toScreen(middle(t)));
  if (length(shift) < 0.01) return;
  view.origin = add(view.origin, shift);
  view.fitted = false;
  viewChanged();
}

/// A round length, drawn to scale.
onView.push(() => {
  const [width, height] = view.size;
  const size = round125(width / 10 / view.k);
  const [right, low] = [width - 14, height - 14];
  const from = right - size * view.k;
  layers.ruler.replaceChildren();
  svg("path", { d: `M${px(from)} ${low - 5}v5H${px(right)}v-5` }, layers.ruler);
  const plain = size >= 1e-3 && size < 1e5;
  const text = `${plain ? Number(size.toPrecision(1)) : digits(size, 1)} m`;
  svg("text", { x: px((from + right) / 2), y: low - 8, "text-anchor": "middle", text }, layers.ruler);
});
