// Contacts: closed or open, their reactions, and the impulses of impacts.

const LONGEST = 84;
const FLASH = 0.4;
const CONE = 56;

/// The direction in which something pushes.
const normal = ({ along, turns }, t) => Array(turns).fill().reduce(left, heading(along, t));

/// The direction of a positive tangential reaction.
const tangent = (push, t) => times(push.slip, left(normal(push, t)));

/// The force of a unit reaction: [where, direction].
const unitForce = (push, t) => [touched(push, t), normal(push, t)];

/// Where something pushes: a point, or the place at which a rim is touched.
const touched = (push, t) => subtract(spot(push.at, t), times(push.rim, normal(push, t)));

/// The size that the longest arrow shows: nearly the largest of a list.
const largest = (values) => quantile(ordered(values.map(Math.abs).filter((x) => x > 0)), 0.98) || 1;

const contacts = motion.geometry.contacts.map((contact, i) => ({
  ...contact, i, normal: quantityNamed(`N(${contact.label})`), friction: quantityNamed(`R(${contact.label})`),
  coefficient: quantityNamed(`mu(${contact.pushes[0]?.support})`),
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
function reaction({ i, label, shares, pushes, normal: n, friction }) {
  const names = shares ? pushes.map(({ support }) => support) : [label];
  const arrows = names.map((name) => arrow("reaction", name));
  return (t) => {
    const closed = isClosed(i, t);
    const [N, R] = [n, friction].map((quantity) => (closed && quantity >= 0 ? value(quantity, t) / (shares ?? 1) : 0));
    const all = pushes.map((push) => unitForce(push, t));
    const forces = shares ? all : mean(all);
    forces.forEach(([at, along], k) => {
      const slip = R && shares ? times(R, tangent(pushes[k], t)) : [0, 0];
      arrows[k](at, add(times(N, along), slip), largestForce);
    });
  };
}

/// Draws an impulse for a moment after its impact.
function flash({ t: when, contact, label, value: P }) {
  const { pushes } = contacts[contact];
  const struck = pushes.filter(({ support }) => support === label);
  const unitForces = (of, t) => of.map((push) => unitForce(push, t));
  const forces = (t) => (struck.length ? unitForces(struck, t) : mean(unitForces(pushes, t)));
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
function mark({ i, pulls, pushes }) {
  const shown = pulls ? [] : pushes;
  const nodes = shown.map(({ support }) => svg("circle", { r: 4.5, "data-contact": support }, layers.marks));
  return (t) => shown.forEach((push, k) => {
    const [x, y] = toScreen(touched(push, t));
    show(nodes[k], finite([x, y]));
    if (finite([x, y])) set(nodes[k], { cx: px(x), cy: px(y), class: isClosed(i, t) ? "closed" : "open" });
  });
}

/// The friction cone of a closed contact: the reaction lies within it, on its edge where the contact slides. A guide has it on the side
/// that it pushes to.
function cone({ i, pushes, coefficient, normal: n }) {
  const shown = coefficient < 0 ? [] : pushes;
  const nodes = shown.map(({ support }) => svg("path", { class: "cone", "data-cone": support }, layers.cones));
  return (t) => shown.forEach((push, k) => {
    const facing = n >= 0 && value(n, t) < 0 ? -1 : 1;
    const [tip, ahead, mu] = [toScreen(touched(push, t)), times(facing, normal(push, t)), value(coefficient, t)];
    const visible = isClosed(i, t) && finite([...tip, ...ahead, mu]);
    show(nodes[k], visible);
    if (!visible) return;
    const edge = (side) => {
      const [x, y] = unit(add(ahead, times(side * mu, left(ahead))));
      return add(tip, times(CONE, [x, -y]));
    };
    nodes[k].setAttribute("d", polyline([edge(1), tip, edge(-1)]));
  });
}

const cones = contacts.map(cone);
const reactions = contacts.map(reaction);
const flashes = impulses.map(flash);
const marks = contacts.map(mark);

/// Draws contacts and forces at a time.
function drawForces(t) {
  for (const draw of [...cones, ...marks, ...reactions, ...flashes]) draw(t);
}
