//! Routh's path by small steps of the impulse.

use crate::contact::friction::impact::path::{RouthContact, Vertex};
use crate::contact::friction::tests::random::{Random, cases};
use crate::model::Law;

/// Steps until a path from ġ = −1 has compressed.
const STEPS: f64 = 4_000.0;

/// ġ, v, P, P_t and ∫ ġ dP.
type Point = [f64; 5];

fn slope(it: &RouthContact<f64>, slip: f64) -> [f64; 2] {
    // At rest what holds it, or friction against the slip that would follow.
    let held = -it.w_nt / it.w_tt;
    let ratio = if slip == 0.0 && held.abs() <= it.mu {
        held
    } else {
        let sense = if slip == 0.0 { it.w_nt.signum() } else { slip.signum() };
        -sense * it.mu
    };
    [ratio, it.w_nt + ratio * it.w_tt]
}

/// The ends of compression and of restitution; none where the path goes on for ever.
fn integrated(it: &RouthContact<f64>, slip: f64) -> Option<[Point; 2]> {
    let h = 1.0 / (it.w_nn * STEPS);
    let mut now: Point = [-1.0, slip, 0.0, 0.0, 0.0];
    let mut compressed: Option<Point> = None;
    for _ in 0..(40.0 * STEPS) as usize {
        let [ratio, rate] = slope(it, now[1]);
        let mut step = h;
        // A slip that would turn stops.
        let stops = now[1] != 0.0 && now[1] * (now[1] + rate * h) <= 0.0;
        if stops {
            step = -now[1] / rate;
        }
        let rise = it.w_nn + ratio * it.w_nt;
        let next = [
            now[0] + rise * step,
            if stops { 0.0 } else { now[1] + rate * step },
            now[2] + step,
            now[3] + ratio * step,
            now[4] + (now[0] + 0.5 * rise * step) * step,
        ];
        if compressed.is_none() && next[0] >= 0.0 {
            compressed = Some(next);
        }
        if let Some(first) = compressed {
            let over = match it.law {
                Law::Newton | Law::Moreau => next[0] >= it.e,
                Law::Poisson => next[2] >= (1.0 + it.e) * first[2],
                Law::Stronge => next[4] - first[4] >= -it.e * it.e * first[4],
            };
            if over {
                return Some([first, next]);
            }
        }
        now = next;
    }
    None
}

fn point(it: &Vertex<f64>) -> [f64; 4] {
    [it.normal, it.slip, it.impulse, it.friction]
}

#[test]
fn paths_are_those_of_small_steps() {
    let mut random = Random(0x510E_527F_ADE6_82D1);
    let (mut reversed, mut stuck, mut down) = (0, 0, 0);
    for k in 0..cases(240) {
        let w_nn = random.between(0.5, 2.0);
        let w_tt = random.between(0.5, 2.0);
        let w_nt = random.between(-0.95, 0.95) * f64::sqrt(w_nn * w_tt);
        let (mu, e) = (random.between(0.0, 2.0), random.between(0.05, 1.0));
        let law = [Law::Newton, Law::Poisson, Law::Stronge][k % 3];
        let slip = random.between(-1.0, 1.0) * [0.0, 0.3, 1.0, 3.0][random.below(4)];
        let it = RouthContact { w_nn, w_nt, w_tt, mu, e, law };
        let (path, steps) = match (it.path(-1.0, slip), integrated(&it, slip)) {
            (Some(path), Some(steps)) => (path, steps),
            // Newton's law may ask for more than a path gives that falls again; steps may not come
            // so far.
            (path, _) => {
                assert!(path.is_none_or(|it| it.vertices.iter().any(|at| at.impulse > 30.0 / w_nn)), "{k}");
                continue;
            }
        };
        let ends = [&path.vertices[path.compressed], &path.vertices[path.vertices.len() - 1]];
        for (found, expected) in ends.into_iter().zip(steps) {
            for (found, expected) in point(found).iter().zip(expected) {
                assert!((found - expected).abs() <= 2e-2, "{k} {law:?} {path:?} {steps:?}");
            }
        }
        let end = point(ends[1]);
        reversed += usize::from(end[1] * slip < 0.0);
        stuck += usize::from(end[1] == 0.0 && slip != 0.0);
        down += usize::from(path.vertices.iter().any(|at| at.normal < -1.0 - 1e-9));
    }
    assert!(reversed > 10 && stuck > 40 && down > 3, "{reversed} {stuck} {down}");
}

/// A slip that ends just as the compression or the restitution does, with W_Nt = 0: what follows
/// sticks, and what ends is at rest.
#[test]
fn a_slip_may_end_with_a_stage() {
    let (mu, e) = (0.5, 0.5);
    for law in [Law::Newton, Law::Poisson, Law::Stronge] {
        let it = RouthContact { w_nn: 1.0, w_nt: 0.0, w_tt: 1.0, mu, e, law };
        for sense in [1.0, -1.0] {
            // Compression takes P = 1, both take 1 + e.
            for part in [1.0, 1.0 + e] {
                let path = it.path(-1.0, sense * mu * part).unwrap();
                let end = point(&path.vertices[path.vertices.len() - 1]);
                assert_eq!(end, [e, 0.0, 1.0 + e, -sense * mu * part], "{law:?} {part}");
                let slip = sense * mu * (part - 1.0);
                let compressed = point(&path.vertices[path.compressed]);
                assert_eq!(compressed, [0.0, slip, 1.0, -sense * mu], "{law:?} {part}");
            }
        }
    }
}

/// The tip of a bar on a pin: v = q ġ throughout, W = w (1, q; q, q²). The compression, with dġ/dP =
/// w (1 + μ |q|), is followed by a rise with w (1 − μ |q|), slipping back, or, where that is
/// negative, by none, as it sticks.
#[test]
fn a_contact_that_moves_along_one_line_stops_at_once() {
    let mut random = Random(0x9B05_688C_2B3E_6C1F);
    let (mut rose, mut stuck) = (0, 0);
    for k in 0..cases(600) {
        let (w, q) = (random.between(0.5, 2.0), random.between(-2.0, 2.0));
        let (mu, e) = (random.between(0.0, 2.0), random.between(0.05, 1.0));
        let law = [Law::Newton, Law::Poisson, Law::Stronge][k % 3];
        let it = RouthContact { w_nn: w, w_nt: w * q, w_tt: w * q * q, mu, e, law };
        let slip = -q;
        let part = -mu * q.abs();
        let found = it.path(-1.0, slip);
        let (rises, sticks) = (part > -0.99, part < -1.01);
        let compressed = 1.0 / (w * (1.0 - part));
        let ratio = (1.0 + part) / (1.0 - part);
        let normal = match law {
            Law::Newton | Law::Moreau => e,
            Law::Poisson => e * ratio,
            Law::Stronge => e * ratio.sqrt(),
        };
        if sticks && law == Law::Newton {
            assert!(found.is_none(), "{k} {found:?}");
        } else if sticks || rises {
            let path = found.unwrap();
            let first = point(&path.vertices[path.compressed]);
            let end = point(&path.vertices[path.vertices.len() - 1]);
            let normal = if rises { normal } else { 0.0 };
            let expected = [normal, q * normal];
            assert!((first[2] - compressed).abs() < 1e-9 * compressed, "{k} {law:?} {path:?}");
            assert!(first[..2].iter().all(|rate| *rate == 0.0), "{k} {law:?} {path:?}");
            assert!(
                end.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-9),
                "{k} {law:?} {expected:?} {path:?}"
            );
            rose += usize::from(rises);
            stuck += usize::from(sticks);
        }
    }
    assert!(rose > 50 && stuck > 50, "{rose} {stuck}");
}
