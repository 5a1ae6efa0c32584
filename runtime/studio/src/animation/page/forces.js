// Contacts: closed or open, their reactions, and the impulses of impacts.

const LONGEST = 84;
const FLASH = 0.4;

const sceneryOf = (support) => motion.scenery.find((thing) => thing.name === support);

/// The direction in which a place pushes.
function normal({ kind, support, point, bar, side }, t) {
  if (kind === "corner") return times(side, left(unit(subtract(position(bar[1], t), position(bar[0], t)))));
  const { shape, at, number, inside } = sceneryOf(support);
  if (shape === "line") return left(direction(number));
  return times(inside ? -1 : 1, unit(subtract(position(point, t), at)));
}

/// The direction of a positive tangential reaction: along the line or bar, on a circle a quarter turn from the radius.
function tangent(place, t) {
  const { kind, support, point, bar, slip } = place;
  if (kind === "corner") return times(slip, unit(subtract(position(bar[1], t), position(bar[0], t))));
  const { shape, at, number } = sceneryOf(support);
  if (shape === "line") return times(slip, direction(number));
  return times(slip, left(unit(subtract(position(point, t), at))));
}

/// Where a place is: the point, or the corner under the bar.
const spot = ({ kind, support, point }, t) => (kind === "corner" ? sceneryOf(support).at : position(point, t));

/// The forces of a unit reaction, or with it a tangential one, at a place: [where, direction] of each.
function unitForces(place, t) {
  if (place.kind !== "thread") return [[spot(place, t), normal(place, t)]];
  const at = place.path.map((point) => position(point, t));
  const pull = ([a, b]) => [a, unit(subtract(b, a))];
  return [pull(at), pull([...at].reverse())];
}

/// The size that the longest arrow shows: nearly the largest of a list.
const largest = (values) => quantile(ordered(values.map(Math.abs).filter((x) => x > 0)), 0.98) || 1;

const contacts = motion.geometry.contacts.map(({ label, shared, places }, i) => ({
  i, label, shared, places, normal: quantityNamed(`N(${label})`), friction: quantityNamed(`R(${label})`),
}));
const largestForce = largest(contacts.flatMap((contact) => allValues(contact.normal)));
const impulses = motion.events.flatMap((event) => event.impulses.map((impulse) => ({ t: event.t, ...impulse })));
const largestImpulse = largest(impulses.map((impulse) => impulse.value));

/// An arrow whose tail is where the force acts.
function arrow(kind, name) {
  const node = svg("g", { class: kind, [`data-${kind}`]: name }, layers.forces);
  const [shaft, head] = [svg("path", { class: "shaft" }, node), svg("path", { class: "head" }, node)];
  return (at, force, size) => {
    const tail = toScreen(at);
    const relative = Math.min(length(force) / size, 1.5);
    const visible = finite(tail) && relative > 0.004;
    show(node, visible);
    if (!visible) return node;
    const along = unit([force[0], -force[1]]);
    const tip = add(tail, times(relative * LONGEST, along));
    const sharp = Math.min(11, relative * LONGEST);
    const [neck, wide] = [subtract(tip, times(sharp, along)), times(0.4 * sharp, left(along))];
    shaft.setAttribute("d", polyline([tail, neck]));
    head.setAttribute("d", `${polyline([add(neck, wide), tip, subtract(neck, wide)])}Z`);
    return node;
  };
}

/// The mean of places and directions, where only the total of a contact is known.
function mean(forces) {
  const average = (pick) => times(1 / forces.length, forces.map(pick).reduce(add));
  return [[average(([at]) => at), unit(average(([, along]) => along))]];
}

/// Draws the forces of a contact from its total reaction; for each force an arrow.
function reaction({ i, label, shared, places, normal: n, friction }) {
  const names = shared ? places.flatMap((place) => (place.kind === "thread" ? [0, 1] : [0]).map(() => place.support)) : [label];
  const arrows = names.map((name) => arrow("reaction", name));
  const share = shared ? places.length : 1;
  return (t) => {
    const closed = isClosed(i, t);
    const [N, R] = [n, friction].map((quantity) => (closed && quantity >= 0 ? value(quantity, t) / share : 0));
    const all = places.flatMap((place) => unitForces(place, t));
    const forces = shared ? all : mean(all);
    forces.forEach(([at, along], k) => {
      const slip = R && shared ? times(R, tangent(places[k], t)) : [0, 0];
      arrows[k](at, add(times(N, along), slip), largestForce);
    });
  };
}

/// Draws an impulse for a moment after its impact.
function flash({ t: when, contact, label, value: P }) {
  const { places } = contacts[contact];
  const struck = places.filter((place) => place.support === label);
  const forces = (t) => (struck.length ? struck.flatMap((place) => unitForces(place, t)) : mean(places.flatMap((place) => unitForces(place, t))));
  const arrows = forces(when).map(() => arrow("impulse", label));
  let drawn = true;
  return (t) => {
    // At rest only what happens within the frame.
    const age = (t - when) / (clock.playing ? FLASH * clock.rate() : 0.5 * clock.frame());
    const visible = age >= 0 && age < 1;
    if (!visible && !drawn) return;
    drawn = visible;
    arrows.forEach((draw, k) => {
      const [at, along] = visible ? forces(when)[k] : [[NaN, NaN], [0, 0]];
      draw(at, times(P, along), largestImpulse).style.opacity = 1 - age * age;
    });
  };
}

/// A dot where a contact is closed, a ring where it is open.
function mark({ i, places }) {
  const shown = places.filter((place) => place.kind !== "thread");
  const nodes = shown.map((place) => svg("circle", { r: 4.5, "data-contact": place.support }, layers.marks));
  return (t) => shown.forEach((place, k) => {
    const [x, y] = toScreen(spot(place, t));
    show(nodes[k], finite([x, y]));
    if (finite([x, y])) set(nodes[k], { cx: px(x), cy: px(y), class: isClosed(i, t) ? "closed" : "open" });
  });
}

const reactions = contacts.map(reaction);
const flashes = impulses.map(flash);
const marks = contacts.map(mark);

/// Draws contacts and forces at a time.
function drawForces(t) {
  for (const draw of [...marks, ...reactions, ...flashes]) draw(t);
}
