// What moves: bodies, springs, threads, points.

/// Half the width of a spring, in pixels.
const COIL = 8;
/// Names of more points than these would hide what they name.
const WORDS = 14;

/// Each draws itself at a time.
const bodies = [];

/// The places of points on the screen; nothing where one is not known.
function places(points, t) {
  const all = points.map((point) => toScreen(position(point, t)));
  return all.every(finite) ? all : null;
}

/// Draws a path of points, or nothing where one is not known.
function draw(node, points, t, path) {
  const at = places(points, t);
  show(node, at);
  if (at) node.setAttribute("d", path(at));
}

/// A circle about a point, and a stroke from its centre that turns with it.
for (const { centre, radius, solid, along } of motion.geometry.rounds) {
  const rim = svg("circle", { class: solid === "within" ? "plate" : "rim", "data-round": motion.points[centre] }, layers.bodies);
  const spoke = along === null ? null : svg("path", { class: "rim", "data-spoke": motion.points[centre] }, layers.bodies);
  bodies.push((t) => {
    const at = toScreen(position(centre, t));
    for (const part of [rim, spoke]) if (part) show(part, finite(at));
    if (!finite(at)) return;
    set(rim, { cx: px(at[0]), cy: px(at[1]), r: px(view.k * radius) });
    if (!spoke) return;
    const [x, y] = left(heading(along, t));
    spoke.setAttribute("d", polyline([at, add(at, times(view.k * radius, [x, -y]))]));
  });
}

for (const { name, outline } of motion.geometry.bodies) {
  const node = svg("path", { class: outline.length > 2 ? "plate" : "bar", "data-body": name }, layers.bodies);
  bodies.push((t) => draw(node, outline, t, (at) => polyline(at) + (at.length > 2 ? "Z" : "")));
}

for (const { point, along } of motion.geometry.blocks) {
  const node = svg("rect", { class: "sleeve", width: 20, height: 12, x: -10, y: -6 }, layers.bodies);
  bodies.push((t) => {
    const [at, [x, y]] = [toScreen(position(point, t)), heading(along, t)];
    const visible = finite([...at, x, y]);
    show(node, visible);
    if (!visible) return;
    const turn = (Math.atan2(-y, x) * 180) / Math.PI;
    node.setAttribute("transform", `translate(${px(at[0])} ${px(at[1])}) rotate(${px(turn)})`);
  });
}

/// A coil between two places: straight at the ends, zigzag between.
function coil([a, b]) {
  const along = subtract(b, a);
  const across = times(COIL, left(unit(along)));
  const turn = (i) => add(add(a, times((i + 2.5) / 16, along)), times(i % 2 ? 1 : -1, across));
  const [from, to] = [add(a, times(2 / 16, along)), add(a, times(14 / 16, along))];
  return polyline([a, from, ...Array.from({ length: 12 }, (_, i) => turn(i)), to, b]);
}

/// A damper between two places: a cup, and a piston in it.
function dashpot([a, b]) {
  const along = subtract(b, a);
  const across = times(COIL, left(unit(along)));
  const at = (part, side) => add(add(a, times(part, along)), times(side, across));
  const cup = [at(0.6, 1), at(0.35, 1), at(0.35, -1), at(0.6, -1)];
  return polyline([a, at(0.35, 0)]) + polyline(cup) + polyline([at(0.5, 0.8), at(0.5, -0.8)]) + polyline([at(0.5, 0), b]);
}

for (const [i, { ends, coil: elastic, name }] of motion.geometry.springs.entries()) {
  const node = svg("path", { class: "spring", "data-spring": name }, layers.bodies);
  bodies.push((t) => {
    draw(node, ends, t, elastic ? coil : dashpot);
    if (phaseAt(t).off?.includes(i)) show(node, false);
  });
}

for (const { name, path, contact } of motion.geometry.threads) {
  const node = svg("path", { "data-thread": name }, layers.bodies);
  const cut = motion.events.find(({ kind, supports }) => kind === "cut" && supports.includes(name))?.t ?? Infinity;
  bodies.push((t) => {
    node.setAttribute("class", isClosed(contact, t) ? "thread" : "thread slack");
    draw(node, path, t, polyline);
    if (t >= cut) show(node, false);
  });
}

const isClosed = (contact, t) => phaseAt(t)?.closed.includes(contact) ?? false;

/// The points that a body's edges lead to from a point.
const neighbours = motion.points.map((_, i) => motion.geometry.bodies.flatMap(({ outline }) => {
  const at = outline.indexOf(i);
  const around = [-1, 1].map((by) => outline[(at + by + outline.length) % outline.length]);
  return at < 0 ? [] : around;
}));

/// Where a point's name stands: away from its neighbours, else above.
function beside(i, at, gap, t) {
  const towards = neighbours[i].map((other) => unit(subtract(toScreen(position(other, t)), at))).filter(finite);
  const away = subtract([0.2, -0.4], towards.reduce(add, [0, 0]));
  return add(at, times(gap, unit(away)));
}

/// The names written so far at the time shown, and room for one.
let written = [];
const APART = [13, 13];

/// A place for a name round its point: the wished one, or where it covers no other.
function free(at, wished) {
  const by = subtract(wished, at);
  const turns = [0, 1, -1, 2].map((quarter) => add(at, turned(by, (quarter * Math.PI) / 2)));
  const covers = ([x, y]) => written.some((other) => Math.abs(x - other[0]) < APART[0] && Math.abs(y - other[1]) < APART[1]);
  const place = turns.find((turn) => !covers(turn)) ?? wished;
  written.push(place);
  return place;
}

bodies.push(() => { written = []; });

motion.points.forEach((name, i) => {
  const heavy = motion.geometry.masses.includes(i);
  const node = svg("circle", { class: heavy ? "mass" : "joint", r: heavy ? 7 : 3.5, "data-point": name }, layers.bodies);
  const word = motion.points.length > WORDS ? null : svg("text", { text: name }, layers.words);
  bodies.push((t) => {
    const at = toScreen(position(i, t));
    for (const part of [node, word]) if (part) show(part, finite(at));
    if (!finite(at)) return;
    set(node, { cx: px(at[0]), cy: px(at[1]) });
    if (!word) return;
    const [x, y] = free(at, beside(i, at, heavy ? 19 : 15, t));
    set(word, { x: px(x), y: px(y) });
  });
});
