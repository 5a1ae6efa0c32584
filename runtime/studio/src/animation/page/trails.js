// Trails: where the points have been.

/// The control points of the cubic curve through values at the start, thirds and end.
const control = ([a, b, c, d]) => [a, (-5 * a + 18 * b - 9 * c + 2 * d) / 6, (2 * a - 9 * b + 18 * c - 5 * d) / 6, d];

/// The part of a cubic curve from its start to theta, by de Casteljau.
function firstPart([a, b, c, d], theta) {
  const mix = (p, q) => p + theta * (q - p);
  const [ab, bc, cd] = [mix(a, b), mix(b, c), mix(c, d)];
  const [abc, bcd] = [mix(ab, bc), mix(bc, cd)];
  return [a, ab, abc, mix(abc, bcd)];
}

/// Every interval of the motion: its phase, its index there, its times.
const intervals = motion.phases.flatMap((phase) => phase.times.slice(1).map((t1, i) => ({ phase, i, t0: phase.times[i], t1 })));

const beginnings = intervals.map(({ t0 }) => t0);

/// The curve of a point over an interval, in the model's plane.
const curve = (point, { phase, i }) => [0, 1].map((axis) => control(nodes(phase, 2 * point + axis, i)));

const segment = ([xs, ys]) => (xs.concat(ys).every(Number.isFinite)
  ? `M${xs[0]} ${ys[0]}C${[1, 2, 3].map((k) => `${xs[k]} ${ys[k]}`).join(" ")}` : "");

const moves = (point) => [0, 1].some((axis) => {
  const [low, high] = range(allValues(2 * point + axis));
  return high - low > 1e-9 * Math.max(Math.abs(high), Math.abs(low));
});

const trails = motion.points.flatMap((name, point) => {
  if (!moves(point)) return [];
  const group = svg("g", { class: `trail ink-${point % INKS}`, "data-trail": name }, layers.trails);
  return { point, curves: null, drawn: -1, done: svg("path", {}, group), tip: svg("path", {}, group) };
});

onView.push(() => {
  layers.trails.setAttribute("transform", `translate(${view.origin}) scale(${view.k} ${-view.k})`);
});

/// Draws a trail up to a time; what lies behind changes only from interval to interval.
function drawTrail(trail, count, t) {
  trail.curves ??= intervals.map((interval) => segment(curve(trail.point, interval)));
  if (trail.drawn !== count) trail.done.setAttribute("d", trail.curves.slice(0, count).join(""));
  trail.drawn = count;
  const current = intervals[count];
  if (!current) return;
  const theta = Math.min((t - current.t0) / (current.t1 - current.t0), 1);
  trail.tip.setAttribute("d", segment(curve(trail.point, current).map((along) => firstPart(along, theta))));
}

function drawTrails(t) {
  show(layers.trails, shows.trails);
  if (!shows.trails) return;
  const count = lastAt(beginnings, t);
  for (const trail of trails) drawTrail(trail, count, t);
}
