//! Small scenes, and snapshots of their runs that no driver moves.

use crate::event::EventKind;
use crate::model::ContactSet;
use crate::prelude::*;
use crate::simulation::awaited::Awaited;
use crate::simulation::snapshot::{PhaseStart, Snapshot};

/// A ball over a rough floor, a wall that is there from t = 1 on, and wind behind x = 2.
#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[support(P = floor, restitution = e, friction = mu)]
#[support(w = wall(3), facing = left, under = P, while("t > 1"))]
#[force(P = (q, 0), while("x > 2"))]
#[figure(P = (0, 1))]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
pub(crate) struct Ball {
    pub(crate) m: f64,
    pub(crate) g: f64,
    pub(crate) e: f64,
    pub(crate) mu: f64,
    pub(crate) q: f64,
}

pub(crate) const BALL: Ball = Ball { m: 2.0, g: 10.0, e: 0.5, mu: 0.25, q: 3.0 };
/// The places of the floor and the wall.
pub(crate) const FLOOR: usize = 0;
pub(crate) const WALL: usize = 1;

pub(crate) fn set(contact: usize) -> ContactSet {
    ContactSet::EMPTY.with(contact)
}

/// A ball in a state (x, y, ẋ, ẏ).
pub(crate) fn start(ball: &Ball, state: [f64; 4]) -> Simulation {
    let start = Pose::new("x", state[0]).with("y", state[1]).with("x'", state[2]).with("y'", state[3]);
    Simulation::new(ball).unwrap().start(start).unwrap()
}

/// The snapshot of a simulation at its start.
pub(crate) fn with_start(simulation: &Simulation, check: impl FnOnce(Snapshot<'_>)) {
    let awaited = Awaited::from_setup(simulation);
    check(Snapshot::new(simulation, &awaited, simulation.started().unwrap()));
}

/// The same once the run has begun, with what its first phase begins with.
pub(crate) fn with_begun(simulation: &Simulation, check: impl FnOnce(Snapshot<'_>, &PhaseStart)) {
    with_start(simulation, |mut now| {
        now.begin().unwrap();
        let start = now.phase_start();
        check(now, &start);
    });
}

pub(crate) fn kinds(snapshot: &Snapshot<'_>) -> Vec<EventKind> {
    snapshot.transition.events.iter().map(|event| event.kind).collect()
}

/// A slender rod with one end on a rough floor.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[support(A = floor, friction = mu)]
#[figure(A = (0, 0), B = (4 * l / 5, 3 * l / 5))]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
#[coordinate(theta = angle(AB), from = right)]
pub(crate) struct Rod {
    pub(crate) m: f64,
    pub(crate) l: f64,
    pub(crate) g: f64,
    pub(crate) mu: f64,
}

/// A slender rod whose end does not slip on its floor.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[support(A = floor, rough, restitution = e)]
#[figure(A = (0, 0), B = (4 * l / 5, 3 * l / 5))]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
#[coordinate(theta = angle(AB), from = right)]
pub(crate) struct Gripping {
    pub(crate) m: f64,
    pub(crate) l: f64,
    pub(crate) g: f64,
    pub(crate) e: f64,
}

/// A level sled on two rough feet, its centre at a third of its length.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l, centre = l / 3)]
#[support(A = floor, friction = mu, restitution = e)]
#[support(B = floor, friction = mu, restitution = e)]
#[figure(A = (0, 0), B = (l, 0))]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
#[coordinate(theta = angle(AB), from = right)]
pub(crate) struct Sled {
    pub(crate) m: f64,
    pub(crate) l: f64,
    pub(crate) g: f64,
    pub(crate) mu: f64,
    pub(crate) e: f64,
}

/// A long bar over a corner.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[support(P = corner(0, 0), under = AB)]
#[figure(A = (-l / 2, l), B = (l / 2, l))]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
#[coordinate(theta = angle(AB), from = right)]
pub(crate) struct Overhang {
    pub(crate) m: f64,
    pub(crate) l: f64,
    pub(crate) g: f64,
}

/// A particle where a floor touches the top of a circle.
#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[support(P = floor)]
#[support(c = circle((a, -a), a), under = P)]
#[figure(P = (a, 0))]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
pub(crate) struct Osculating {
    pub(crate) m: f64,
    pub(crate) a: f64,
    pub(crate) g: f64,
}

/// A particle on a thread, beside a wall.
#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[ground(O = (0, 0))]
#[thread(rope = O -> P, length = l)]
#[support(w = wall(d), facing = left, under = P)]
#[figure(P = (0, -l))]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
pub(crate) struct Tethered {
    pub(crate) m: f64,
    pub(crate) l: f64,
    pub(crate) d: f64,
    pub(crate) g: f64,
}

/// A bar that two cranks carry, parallel to the ground.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(OA, mass = m, length = a)]
#[bar(AB, mass = m, length = b)]
#[bar(QB, mass = m, length = a)]
#[pin(O = (0, 0))]
#[pin(Q = (b, 0))]
#[figure(A = (0, a), B = (b, a))]
#[coordinate(phi = angle(OA))]
#[coordinate(psi = angle(QB))]
#[coordinate(chi = angle(AB))]
pub(crate) struct Linkage {
    pub(crate) m: f64,
    pub(crate) a: f64,
    pub(crate) b: f64,
    pub(crate) g: f64,
}

/// A crank that a drive alone moves.
#[derive(BarSystem)]
#[bar(OA, mass = m, length = l)]
#[pin(O = (0, 0))]
#[figure(A = (l, 0))]
#[coordinate(phi = angle(OA), from = right)]
#[drive(phi = sin(w * t))]
pub(crate) struct Driven {
    pub(crate) m: f64,
    pub(crate) l: f64,
    pub(crate) w: f64,
}
