//! Two bars, hinged with friction.

use liftoff::method::MethodId;
use liftoff::prelude::*;
use nalgebra::{SMatrix, SVector};

use crate::friction::run;

/// A double pendulum with friction at both hinges.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[bar(BC, mass = p, length = k)]
#[pin(A = (0, 0))]
#[hinge(A, friction = nu, radius = r)]
#[hinge(B, friction = mu, radius = r)]
#[coordinate(phi = angle(AB), from = down)]
#[coordinate(psi = angle(BC), from = down)]
#[figure(B = (l / 5, -l * sqrt(24) / 5), C = (l / 5 + k / 3, -l * sqrt(24) / 5 - k * sqrt(8) / 3))]
struct Pair {
    m: f64,
    l: f64,
    p: f64,
    k: f64,
    mu: f64,
    nu: f64,
    r: f64,
    g: f64,
}

const PAIR: Pair = Pair { m: 1.2, l: 0.9, p: 0.8, k: 0.7, mu: 0.4, nu: 0.3, r: 0.06, g: 9.81 };

type Unknowns = SVector<f64, 10>;

/// Maximal coordinates, both bars by centre and direction, with the forces of the hinges: ẍ, ÿ, φ̈
/// of each bar, then F on AB at A, and F on BC at B. The couples of friction follow these by
/// repetition.
fn oracle(pair: &Pair, [phi, psi]: [f64; 2], [u, w]: [f64; 2]) -> Unknowns {
    let Pair { m, l, p, k, mu, nu, r, g } = *pair;
    // Half a bar, from its first point to its centre, the direction from which it turns and what
    // its turning adds.
    let half = |angle: f64, length: f64| [0.5 * length * angle.sin(), -0.5 * length * angle.cos()];
    let ([ax, ay], [bx, by]) = (half(phi, l), half(psi, k));
    let mut matrix = SMatrix::<f64, 10, 10>::zeros();
    let mut right = Unknowns::zeros();
    // m c̈ = m g + F_A − F_B, I φ̈ = (−a) × F_A + a × (−F_B) + c_A − c_B
    for (row, mass) in [(0, m), (1, m), (3, p), (4, p)] {
        matrix[(row, row)] = mass;
    }
    (right[1], right[4]) = (-m * g, -p * g);
    for axis in 0..2 {
        matrix[(axis, 6 + axis)] = -1.0;
        matrix[(axis, 8 + axis)] = 1.0;
        matrix[(3 + axis, 8 + axis)] = -1.0;
    }
    (matrix[(2, 2)], matrix[(5, 5)]) = (m * l * l / 12.0, p * k * k / 12.0);
    (matrix[(2, 6)], matrix[(2, 7)]) = (-ay, ax);
    (matrix[(2, 8)], matrix[(2, 9)]) = (-ay, ax);
    (matrix[(5, 8)], matrix[(5, 9)]) = (-by, bx);
    // c̈ − φ̈ × a + φ̇² a … = 0 at A, and the two bars meet at B.
    let held = [(6, 0, -1.0, ax, ay, u), (8, 0, 1.0, ax, ay, u), (8, 3, -1.0, bx, by, w)];
    for (row, first, end, x, y, rate) in held {
        let sign = if (row, first) == (8, 3) { -1.0 } else { 1.0 };
        // Acceleration of centre + end · a: c̈ + end (φ̈ × a − φ̇² a).
        matrix[(row, first)] += sign;
        matrix[(row + 1, first + 1)] += sign;
        matrix[(row, first + 2)] += -sign * end * y;
        matrix[(row + 1, first + 2)] += sign * end * x;
        right[row] += sign * end * rate * rate * x;
        right[row + 1] += sign * end * rate * rate * y;
    }
    let lu = matrix.lu();
    let mut forces = [0.0; 2];
    loop {
        let mut loaded = right;
        let [at_a, at_b] = [-u.signum() * nu * r * forces[0], -(w - u).signum() * mu * r * forces[1]];
        loaded[2] += at_a - at_b;
        loaded[5] += at_b;
        let found = lu.solve(&loaded).expect("a regular matrix");
        let next = [found[6].hypot(found[7]), found[8].hypot(found[9])];
        let change = (next[0] - forces[0]).abs().max((next[1] - forces[1]).abs());
        if change <= 4.0 * f64::EPSILON * (next[0] + next[1]) {
            return found;
        }
        forces = next;
    }
}

/// States by a generator of its own, all angles and rates of both signs.
fn states() -> impl Iterator<Item = ([f64; 2], [f64; 2])> {
    let mut seed = 7_u64;
    let mut next = move || {
        seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (seed >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    };
    (0..60).map(move |_| ([3.1 * next(), 3.1 * next()], [6.0 * next(), 6.0 * next()]))
}

#[test]
fn two_hinges_rub_as_maximal_coordinates_have_it() {
    for ([phi, psi], [u, w]) in states() {
        let expected = oracle(&PAIR, [phi, psi], [u, w]);
        let start = Pose::new("phi", phi).with("psi", psi).with("phi'", u).with("psi'", w);
        let record = run(Simulation::new(&PAIR).unwrap().start(start).unwrap().limit(1e-6));
        let value = |text: &str| record.function(text).unwrap()(0.0);
        let size = expected.amax();
        for (text, place) in [("phi''", 2), ("psi''", 5), ("fx(A, AB)", 6), ("fy(B, BC)", 9)] {
            assert!((value(text) - expected[place]).abs() < 1e-10 * size, "{text} {phi} {psi} {u} {w}");
        }
        let normal = expected[8].hypot(expected[9]);
        assert!((value("R(B)") + (w - u).signum() * PAIR.mu * normal).abs() < 1e-10 * size);
    }
}

/// Whatever sticks, slips and sticks again, what friction takes is missing in the energy.
#[test]
fn energy_and_what_friction_takes_are_one() {
    for ([phi, psi], [u, w]) in states().take(6) {
        let start = Pose::new("phi", phi).with("psi", psi).with("phi'", u).with("psi'", w);
        let record = run(Simulation::new(&PAIR).unwrap().start(start).unwrap().limit(3.0));
        let (energy, first) = (record.function("E + D").unwrap(), record.function("E").unwrap()(0.0));
        for k in 0..=30 {
            let t = 0.1 * f64::from(k);
            assert!((energy(t) - first).abs() < 1e-9 * first.abs().max(1.0), "{t} {}", energy(t) - first);
        }
    }
}

/// The same bars, welded at B.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[bar(BC, mass = p, length = k)]
#[pin(A = (0, 0))]
#[weld(AB, BC, angle = a)]
#[coordinate(phi = angle(AB), from = down)]
#[figure(B = (l / 5, -l * sqrt(24) / 5))]
struct Rigid {
    m: f64,
    l: f64,
    p: f64,
    k: f64,
    a: f64,
    g: f64,
}

#[test]
fn a_hinge_that_sticks_is_a_weld() {
    let pair = Pair { mu: 50.0, nu: 0.0, r: 0.1, ..PAIR };
    let Pair { m, l, p, k, g, .. } = pair;
    let rigid = Rigid { m, l, p, k, a: 0.4, g };
    let start = Pose::new("phi", 0.9).with("psi", 1.3).with("phi'", 1.0).with("psi'", 1.0);
    let record = run(Simulation::new(&pair).unwrap().start(start).unwrap().limit(2.0));
    let start = Pose::new("phi", 0.9).with("phi'", 1.0);
    let welded = run(Simulation::new(&rigid).unwrap().start(start).unwrap().limit(2.0));
    let of = |record: &Trajectory, text: &str, t: f64| record.function(text).unwrap()(t);
    for t in [0.0, 0.5, 1.0, 1.5, 2.0] {
        assert!((of(&record, "phi", t) - of(&welded, "phi", t)).abs() < 1e-9);
        assert!((of(&record, "psi", t) - of(&record, "phi", t) - 0.4).abs() < 1e-9);
        assert!((of(&record, "R(B)", t) * pair.r - of(&welded, "couple(AB, BC)", t)).abs() < 1e-8);
    }
}

/// Whether a journal turns is asked of its own surface: a small one does not stop at a lax
/// tolerance while it turns.
#[test]
fn small_journals_reverse_at_any_tolerance() {
    for r in [1e-1, 1e-3, 1e-5] {
        let pair = Pair { r, ..PAIR };
        let times = |tolerance: f64| -> Vec<(EventKind, f64)> {
            let start = Pose::new("phi", 1.0).with("psi", 0.5).with("phi'", -2.0).with("psi'", 1.0);
            let simulation =
                Simulation::new(&pair).unwrap().start(start).unwrap().tolerance(tolerance).limit(1.0);
            run(simulation).events().iter().map(|event| (event.kind, event.t)).collect()
        };
        let known = times(1e-12);
        assert!(known.len() > 4, "{known:?}");
        for tolerance in [1e-3, 1e-5, 1e-8] {
            let found = times(tolerance);
            assert_eq!(found.len(), known.len(), "{r} {tolerance}: {found:?} {known:?}");
            for (own, known) in found.iter().zip(&known) {
                assert!(
                    own.0 == known.0 && (own.1 - known.1).abs() < 20.0 * tolerance,
                    "{r} {own:?} {known:?}"
                );
            }
        }
    }
}

/// Where the force of a hinge nearly vanishes its length is hardly smooth: steps of Gauss's method
/// that did not see it were refused for their energy.
#[test]
fn gauss_sees_where_a_force_nearly_vanishes() {
    for (pair, [phi, psi, u, w]) in [
        (
            Pair {
                m: 0.856946940637837,
                l: 0.6809604577071663,
                p: 1.0549327498221188,
                k: 0.7227440270173361,
                mu: 0.41286015205402704,
                nu: 0.13276442961990656,
                r: 0.01092175940884119,
                g: 9.81,
            },
            [2.02481449257876, -1.4438759140319541, -3.1880284674396435, 5.947738026125553],
        ),
        (
            Pair {
                m: 1.1945110367225322,
                l: 0.5613183519765295,
                p: 0.7078091187716828,
                k: 0.906593294990439,
                mu: 0.10321752704056167,
                nu: 0.3513910400261042,
                r: 0.07288085790223567,
                g: 9.81,
            },
            [-2.515112116901994, 0.3256228090697162, 1.3998005122034218, -5.509250814182261],
        ),
        (
            Pair {
                m: 1.2118560180328222,
                l: 0.7602307518600786,
                p: 1.499615706687257,
                k: 0.3998202470477574,
                mu: 0.10543022154503398,
                nu: 0.28737724603168224,
                r: 0.0291833697634832,
                g: 9.81,
            },
            [1.8620883134105028, 1.1435559182321073, 1.2174844647327978, 0.6982805730401758],
        ),
        (
            Pair {
                m: 0.8885127375732104,
                l: 0.7796805950751757,
                p: 1.5261228770241662,
                k: 0.894535312972951,
                mu: 0.1928620869368677,
                nu: 0.21527930448273405,
                r: 0.020301194271789245,
                g: 9.81,
            },
            [-1.6490223866273241, 1.4041416132766376, -4.437443726882917, 0.37577702216421915],
        ),
    ] {
        let start = || Pose::new("phi", phi).with("psi", psi).with("phi'", u).with("psi'", w);
        let [own, known] = [MethodId::Gauss, MethodId::Dop853].map(|method| {
            let simulation = Simulation::new(&pair).unwrap().start(start()).unwrap().method(method);
            run(simulation.limit(2.0)).final_state().to_vec()
        });
        for (own, known) in own.iter().zip(&known) {
            assert!((own - known).abs() < 1e-8 * known.abs().max(1.0), "{own} {known}");
        }
    }
}
