// The motion: what was computed, and its values at any time.

const [tStart, tEnd] = motion.interval;

/// The largest index i with list[i] <= t (< t if before); 0 if there is none.
function lastAt(list, t, before = false) {
  let [low, high] = [0, list.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    const passed = before ? list[middle] < t : list[middle] <= t;
    if (passed) low = middle + 1; else high = middle;
  }
  return Math.max(low - 1, 0);
}

const starts = motion.phases.map((phase) => phase.times[0]);

/// The phase at a time; at an event the one after it, or before it.
const phaseAt = (t, before) => motion.phases[lastAt(starts, t, before)];

/// The cubic through values at 0, 1/3, 2/3 and 1.
function cubic([a, b, c, d], theta) {
  const [p, q, r, s] = [theta, 3 * theta - 1, 3 * theta - 2, theta - 1];
  return -0.5 * q * r * s * a + 4.5 * p * r * s * b - 4.5 * p * q * s * c + 0.5 * p * q * r * d;
}

/// The values of a quantity at the start, thirds and end of an interval of a phase.
function nodes(phase, quantity, interval) {
  const [values, step] = [phase.values[quantity], motion.steps[quantity]];
  const at = (i) => {
    const whole = values[values.length === 1 ? 0 : i];
    return whole === null ? NaN : whole * step;
  };
  return [0, 1, 2, 3].map((i) => at(3 * interval + i));
}

/// The value of a quantity at a time.
function value(quantity, t, before = false) {
  const phase = phaseAt(t, before);
  if (!phase) return NaN;
  const { times } = phase;
  const interval = Math.min(lastAt(times, t), Math.max(times.length - 2, 0));
  const [t0, t1] = [times[interval], times[interval + 1]];
  const theta = t1 > t0 ? Math.min(Math.max((t - t0) / (t1 - t0), 0), 1) : 0;
  return cubic(nodes(phase, quantity, interval), theta);
}

const position = (point, t) => [value(2 * point, t), value(2 * point + 1, t)];

/// A place: a point by its index, or one that stands still.
const spot = (place, t) => (Array.isArray(place) ? place : position(place, t));

/// A direction of unit length: an angle, from one place to another, or that less an angle.
function heading(along, t) {
  if (typeof along === "number") return direction(along);
  const [from, to, less] = along;
  const ahead = unit(subtract(spot(to, t), spot(from, t)));
  return less ? turned(ahead, -less) : ahead;
}

/// Indices of the quantities of a group.
const ofGroup = (group) => motion.quantities.flatMap((quantity, i) => (quantity.group === group ? [i] : []));

const quantityNamed = (name) => motion.quantities.findIndex((quantity) => quantity.name === name);

/// All values of a quantity that were kept, in no order that matters.
function allValues(quantity) {
  const step = motion.steps[quantity];
  const whole = motion.phases.flatMap((phase) => phase.values[quantity]);
  return whole.filter((x) => x !== null).map((x) => x * step);
}

/// The value below which a part of ordered numbers lies.
const quantile = (sorted, part) => sorted[Math.round(part * (sorted.length - 1))];

const ordered = (numbers) => numbers.sort((a, b) => a - b);

/// The radius of the largest circle about a point.
const reach = (point) => Math.max(0, ...motion.geometry.rounds.filter(({ centre }) => centre === point).map(({ radius }) => radius));

/// The rectangle [x0, y0, x1, y1] that all points and the circles about them stay in.
function extent() {
  const wider = (ends, by) => ends.map((end, k) => end + (k ? by : -by));
  const along = (axis) => motion.points.flatMap((_, i) => wider(range(allValues(2 * i + axis)), reach(i)));
  const [xs, ys] = [range(along(0)), range(along(1))];
  return [xs[0], ys[0], xs[1], ys[1]];
}

/// The least and the greatest of numbers; nothing of none.
function range(numbers) {
  let [low, high] = [Infinity, -Infinity];
  for (const x of numbers) [low, high] = [Math.min(low, x), Math.max(high, x)];
  return low <= high ? [low, high] : [];
}
