// What stands still.

const STRIP = 9;

/// A surface that carries: its edge, and the hatched strip on its solid side.
function surface(edge, strip) {
  svg("path", { class: "solid", d: strip }, layers.scenery);
  svg("path", { class: "edge", d: edge }, layers.scenery);
}

/// The ends of a line through a place, well beyond the picture.
function ends(at, angle) {
  const along = direction(-angle);
  const reach = length(view.size);
  const from = subtract(times(0.5, view.size), at);
  const nearest = add(at, times(from[0] * along[0] + from[1] * along[1], along));
  return [-1, 1].map((side) => add(nearest, times(side * reach, along)));
}

const DRAWINGS = {
  line({ at, angle, solid }) {
    const [a, b] = ends(toScreen(at), angle);
    if (!solid) return svg("path", { class: "guide", d: polyline([a, b]) }, layers.scenery);
    // The screen's y points down: the solid side is a quarter turn clockwise from the line.
    const down = times(STRIP, direction(-angle + Math.PI / 2));
    surface(polyline([a, b]), polyline([a, b, add(b, down), add(a, down)]));
  },
  circle({ at, radius, solid }) {
    const [x, y] = toScreen(at).map(px);
    const ring = (r) => `M${px(x - r)} ${y}a${px(r)} ${px(r)} 0 1 0 ${px(2 * r)} 0a${px(r)} ${px(r)} 0 1 0 ${px(-2 * r)} 0`;
    const r = view.k * radius;
    if (solid === "nowhere") return svg("path", { class: "guide", d: ring(r) }, layers.scenery);
    const other = solid === "around" ? r + STRIP : Math.max(r - STRIP, 0);
    surface(ring(r), ring(r) + ring(other));
  },
  wedge({ at, name }) {
    const tip = toScreen(at);
    const push = pushAtStart(name);
    const [back, wide] = [times(-16, push), times(7, left(push))];
    const base = add(tip, back);
    surface(polyline([add(base, wide), tip, subtract(base, wide)]), polyline([add(base, wide), tip, subtract(base, wide)]));
  },
  foot({ at }) {
    const tip = toScreen(at);
    const [a, b] = [add(tip, [-9, 14]), add(tip, [9, 14])];
    svg("path", { class: "edge", d: `${polyline([a, tip, b])}Z` }, layers.scenery);
    surface(polyline([add(a, [-4, 0]), add(b, [4, 0])]), `${polyline([add(a, [-4, 0]), add(b, [4, 0]), add(b, [4, 6]), add(a, [-4, 6])])}Z`);
  },
  cross({ at }) {
    const [x, y] = toScreen(at);
    svg("path", { class: "edge", d: `M${px(x - 5)} ${px(y)}h10M${px(x)} ${px(y - 5)}v10` }, layers.scenery);
  },
};

/// The direction on the screen in which a support pushes at the start.
function pushAtStart(name) {
  const pushes = motion.geometry.contacts.flatMap((contact) => contact.pushes);
  const push = pushes.find(({ support }) => support === name);
  if (!push) return [0, -1];
  const [x, y] = normal(push, tStart);
  return finite([x, y]) ? [x, -y] : [0, -1];
}

/// What stands in one place is drawn once.
function distinct(scenery) {
  const seen = new Set();
  return scenery.filter(({ name: _, at, ...form }) => {
    const place = form.shape === "line" ? height(at, form.angle) : at;
    const key = JSON.stringify([{ ...form, shape: form.shape === "cross" ? "foot" : form.shape }, place]);
    return !seen.has(key) && seen.add(key);
  });
}

/// How far a line through a point lies from the origin, along its normal.
const height = ([x, y], angle) => Math.round((y * Math.cos(angle) - x * Math.sin(angle)) * 1e9) / 1e9;

const hatch = svg("pattern", { id: "hatch", width: 6, height: 6, patternUnits: "userSpaceOnUse" }, svg("defs", {}, stage));
svg("path", { d: "M-1 7 7 -1M-1 1 1 -1M5 7 7 5" }, hatch);

const things = distinct(motion.scenery);
onView.push(() => {
  layers.scenery.replaceChildren();
  for (const thing of things) DRAWINGS[thing.shape](thing);
});
