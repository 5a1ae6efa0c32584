//! Hand-built assemblies of the systems with closed forms. Uniform bars; m = l = g = 1 where
//! nothing is given.

use std::f64::consts::PI;

use liftoff_tests::oracle::{Anchor, AngleTie, Assembly, Contact, Mark, Pin, State, Support};
use liftoff_tests::paper::{FallingPair, Zigzag};
use nalgebra::Vector2;

pub fn pin(at: Mark, x: f64, y: f64) -> Pin {
    Pin { at, ground: Vector2::new(x, y) }
}

pub fn floor(name: &str, point: Mark) -> Support {
    line(name, point, Vector2::y())
}

fn line(name: &str, point: Mark, normal: Vector2<f64>) -> Support {
    let contact = Contact::Point { point: point.into(), through: Vector2::zeros(), normal };
    Support { name: name.into(), contact, rough: false }
}

fn corner(name: &str, body: usize, x: f64) -> Support {
    let contact = Contact::Corner { body, corner: Vector2::new(x, 0.0), side: 1.0 };
    Support { name: name.into(), contact, rough: false }
}

fn chain(masses: &[f64], length: f64, gravity: f64) -> Assembly {
    Assembly { gravity: Vector2::new(0.0, -gravity), ..Assembly::chain(masses, length) }
}

/// A chain of n unit bars pinned at the origin.
pub fn pendulum(bars: usize) -> Assembly {
    Assembly { pins: vec![pin(Mark::along(0, 0.0), 0.0, 0.0)], ..chain(&vec![1.0; bars], 1.0, 1.0) }
}

/// A free chain of n unit bars at rest without gravity, its first point at the origin.
pub fn at_rest_from(bars: usize, angles: &[f64]) -> (Assembly, State) {
    let assembly = chain(&vec![1.0; bars], 1.0, 0.0);
    let state = placed(&assembly, angles, &vec![0.0; bars], Vector2::zeros(), Vector2::zeros());
    (assembly, state)
}

fn placed(
    assembly: &Assembly,
    angles: &[f64],
    spins: &[f64],
    position: Vector2<f64>,
    velocity: Vector2<f64>,
) -> State {
    let anchor = Anchor { at: Mark::along(0, 0.0).into(), position, velocity };
    assembly.state(angles, spins, &[anchor]).expect("a chain")
}

/// A level rod at rest on two floors at distance d either side of its centre.
pub fn level_rod(offset: f64) -> (Assembly, State) {
    let (mut assembly, state) = at_rest_from(1, &[0.0]);
    assembly.gravity.y = -1.0;
    assembly.supports =
        [("A", -offset), ("B", offset)].map(|(name, at)| floor(name, Mark::along(0, 0.5 + at))).into();
    (assembly, state)
}

/// A bar at θ to the floor with its first point on it, moving so that its centre has no horizontal
/// velocity.
pub fn bar_over_floor(theta: f64, rate: f64) -> (Assembly, State) {
    let mut assembly = chain(&[1.0], 1.0, 1.0);
    assembly.supports = vec![floor("A", Mark::along(0, 0.0))];
    let velocity = Vector2::new(0.5 * theta.sin() * rate, 0.0);
    let state = placed(&assembly, &[theta], &[rate], Vector2::zeros(), velocity);
    (assembly, state)
}

/// A ladder from its foot A on the floor up to B on the wall x = 0, θ from the floor.
pub fn ladder(theta: f64, rate: f64) -> (Assembly, State) {
    let mut assembly = chain(&[1.0], 1.0, 1.0);
    assembly.supports = vec![floor("A", Mark::along(0, 0.0)), line("B", Mark::along(0, 1.0), Vector2::x())];
    let (foot, slip) = (Vector2::new(theta.cos(), 0.0), Vector2::new(-theta.sin() * rate, 0.0));
    let state = placed(&assembly, &[PI - theta], &[-rate], foot, slip);
    (assembly, state)
}

/// Two bars A–D–B, feet A and B on the floor at x = ∓cos φ.
pub fn a_frame(phi: f64, rate: f64) -> (Assembly, State) {
    let mut assembly = chain(&[1.0, 1.0], 1.0, 1.0);
    assembly.supports = vec![floor("A", Mark::along(0, 0.0)), floor("B", Mark::along(1, 1.0))];
    let (foot, slip) = (Vector2::new(-phi.cos(), 0.0), Vector2::new(phi.sin() * rate, 0.0));
    let state = placed(&assembly, &[phi, -phi], &[rate, -rate], foot, slip);
    (assembly, state)
}

/// Fig. 1a on both corners: A–D–B, D at (0, −(l/2) tan φ).
pub fn falling_pair(pair: &FallingPair, phi: f64, rate: f64) -> (Assembly, State) {
    let mut assembly = chain(&[pair.m, pair.m], pair.l, pair.g);
    assembly.supports = vec![corner("P", 0, -0.5 * pair.l), corner("Q", 1, 0.5 * pair.l)];
    let sink = -0.5 * pair.l * rate / phi.cos().powi(2);
    let anchor = Anchor {
        at: Mark::along(1, 0.0).into(),
        position: Vector2::new(0.0, -pair.drop(phi)),
        velocity: Vector2::new(0.0, sink),
    };
    let state = assembly.state(&[-phi, phi], &[-rate, rate], &[anchor]).expect("a chain");
    (assembly, state)
}

/// Fig. 1b on its feet A, C, E: bars AB, BC, CD, DE, C at the origin.
pub fn zigzag(system: &Zigzag, phi: f64, rate: f64) -> (Assembly, State) {
    let masses = [system.m2, system.m1, system.m1, system.m2];
    let mut assembly = chain(&masses, system.l, system.g);
    assembly.supports = vec![
        floor("A", Mark::along(0, 0.0)),
        floor("C", Mark::along(2, 0.0)),
        floor("E", Mark::along(3, system.l)),
    ];
    let anchor =
        Anchor { at: Mark::along(2, 0.0).into(), position: Vector2::zeros(), velocity: Vector2::zeros() };
    let spins = [rate, -rate, rate, -rate];
    let state = assembly.state(&[phi, -phi, phi, -phi], &spins, &[anchor]).expect("a chain");
    (assembly, state)
}

/// Declares all four angles of [`zigzag`] equal.
pub fn tie_all(assembly: &mut Assembly) {
    let ties = (1..4)
        .map(|k| AngleTie { terms: vec![(0, 1.0), (k, if k % 2 == 1 { 1.0 } else { -1.0 })], value: 0.0 });
    assembly.ties = ties.collect();
}

/// Classical Runge–Kutta from `state` until `guard` falls through zero, the last step shortened
/// onto it.
pub fn march(
    assembly: &Assembly,
    mut state: State,
    closed: &[usize],
    guard: impl Fn(&State) -> f64,
) -> State {
    for _ in 0..100_000 {
        let next = step(assembly, &state, closed, 1e-3);
        if guard(&next) < 0.0 {
            let length =
                liftoff_tests::numerics::root(|h| guard(&step(assembly, &state, closed, h)), 0.0, 1e-3);
            return step(assembly, &state, closed, length.expect("bracketed"));
        }
        state = next;
    }
    panic!("the guard never fell");
}

fn step(assembly: &Assembly, state: &State, closed: &[usize], h: f64) -> State {
    let slope = |at: &State| {
        let motion = assembly.solve(at, closed).expect("regular");
        State { positions: at.rates.clone(), rates: motion.accelerations, time: 1.0 }
    };
    let plus = |k: &State, h: f64| State {
        positions: &state.positions + &k.positions * h,
        rates: &state.rates + &k.rates * h,
        time: state.time + k.time * h,
    };
    let k1 = slope(state);
    let k2 = slope(&plus(&k1, 0.5 * h));
    let k3 = slope(&plus(&k2, 0.5 * h));
    let k4 = slope(&plus(&k3, h));
    let sum = |a: &State, b: &State, c: &State, d: &State| State {
        positions: &a.positions + (&b.positions + &c.positions) * 2.0 + &d.positions,
        rates: &a.rates + (&b.rates + &c.rates) * 2.0 + &d.rates,
        time: a.time + (b.time + c.time) * 2.0 + d.time,
    };
    plus(&sum(&k1, &k2, &k3, &k4), h / 6.0)
}
