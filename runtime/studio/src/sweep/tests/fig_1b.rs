//! Which support of Fig. 1b opens first, against Newton and Euler's equations of each bar solved in
//! 40 digits (mpmath): from rest at φ₀, while A, C and E bear, with l = g = m₁ + m₂ = 1, s = sin φ,
//! λ = m₂, φ̇² = (s₀ − s)/(⅓ + 2λs²).

use super::super::Sweep;
use crate::registry::Models;
use crate::run_spec::{DefaultRun, RunSpec};
use liftoff::prelude::*;

/// Four bars in the shape of an M on a smooth floor.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m2, length = l)]
#[bar(BC, mass = m1, length = l)]
#[bar(CD, mass = m1, length = l)]
#[bar(DE, mass = m2, length = l)]
#[support(A = floor)]
#[support(C = floor)]
#[support(E = floor)]
#[support(B = floor, stop)]
#[support(D = floor, stop)]
#[figure(C = (0, 0), D = (3 * l / 5, 4 * l / 5), E = (6 * l / 5, 0))]
#[coordinate(phi_inner = angle(CD), from = horizontal)]
#[coordinate(phi_outer = angle(DE), from = horizontal)]
#[coordinate(y = y(C))]
#[mirror(x = 0)]
struct Zigzag {
    m1: f64,
    m2: f64,
    l: f64,
    g: f64,
}

impl DefaultRun for Zigzag {
    fn default_run() -> RunSpec {
        RunSpec::with(&[("m1", 0.5), ("m2", 0.5), ("l", 1.0), ("g", 1.0)])
    }
}

const C_TOUCHES: f64 = 0.501_596_246_137_363_2;
const E_TOUCHES: f64 = 0.772_124_149_011_321_8;

fn models() -> Models {
    crate::models![Zigzag]
}

/// From rest with all bars at the angle `phi`, a number or a varied name as λ is.
fn zigzag<'a>(models: &'a Models, lambda: &str, phi: &str) -> Sweep<'a> {
    let sweep = Sweep::new(models.find("zigzag").unwrap());
    let sweep = sweep.set(&format!("m1=1-{lambda}")).unwrap().set(&format!("m2={lambda}")).unwrap();
    let sweep = sweep.start(&format!("phi_inner={phi}")).unwrap();
    sweep.start(&format!("phi_outer={phi}")).unwrap().observe("first open").unwrap()
}

/// N_C = 6 N_E at λ = ¼ whatever s and s₀ are: there all three open at once, below A and E do,
/// above C.
#[test]
fn who_opens_first_changes_at_a_quarter_from_every_height() {
    let models = models();
    for phi in ["0.9", "1.2", "1.5"] {
        // No value of the coarse grid is ¼.
        let found =
            zigzag(&models, "lambda", phi).vary("lambda=0.1:0.9:4").unwrap().thresholds(1e-10).unwrap();
        let (first, last) = (found.first().unwrap(), found.last().unwrap());
        assert_eq!((first.before.as_str(), last.after.as_str()), ("A, E", "C"));
        // Between them, both within the bound of events that are one, all open at once.
        assert!(found.len() <= 2 && last.above - first.below < 1e-8, "{phi}: {found:?}");
        assert!(first.below <= 0.25 + 1e-10 && last.above >= 0.25 - 1e-10, "{phi}: {found:?}");
    }
}

/// The height from which nothing opens before B and D touch the floor: N_C (λ = ½) or N_E (λ = 0.1)
/// touches zero there, N = ∂N/∂s = 0.
#[test]
fn nothing_opens_from_low() {
    let models = models();
    let cases = [("0.5", "C", C_TOUCHES), ("0.1", "A, E", E_TOUCHES)];
    for (lambda, opens, expected) in cases {
        let sweep = zigzag(&models, lambda, "phi").vary("phi=0.3:1.2:7").unwrap();
        let found = sweep.thresholds(1e-10).unwrap();
        let [change] = &found[..] else { panic!("{lambda}: {found:?}") };
        assert_eq!((change.before.as_str(), change.after.as_str()), ("none", opens));
        // A double root: what the tolerance 1e-12 cannot tell from a touch is of its order.
        assert!((change.above - expected).abs() < 1e-9, "{lambda}: {change:?} for {expected}");
    }
}

/// N_C and N_E, of bars of mass m₁ = 1 − λ and m₂ = λ at s = sin φ, at rest at s₀: for Newton and
/// Euler's equations of an outer bar about its hinge, with φ̇² = (s₀ − s)/(⅓ + 2λs²) and all bars
/// at one angle.
fn reactions(lambda: f64, s0: f64, s: f64) -> [f64; 2] {
    let inertia = 1.0 / 3.0 + 2.0 * lambda * s * s;
    let square = (s0 - s) / inertia;
    // φ̈ = ½ d(φ̇²)/dφ.
    let bend = 0.5 * (-1.0 - 4.0 * lambda * s * square) / inertia;
    let c2 = 1.0 - s * s;
    // Per half, (m₁ + m₂) = g = l = 1: heights of both bars ½ sin φ, ÿ = ½ (φ̈ cos φ − φ̇² sin φ),
    // φ̈ = bend cos φ.
    let lift = 0.5 * (bend * c2 - square * s);
    let half = 1.0 + lift;
    // The outer bar about B, over cos φ: its centre at (3/2 cos φ, ½ sin φ) from C, B at (cos φ,
    // sin φ).
    let across = 1.5 * (-bend * s - square);
    let spin = lambda / 12.0 * bend;
    let moment = 0.5 * lambda * (1.0 + lift) + 0.5 * lambda * s * across + -spin;
    [2.0 * (half - moment), moment]
}

/// The curves in the plane of λ and φ₀: λ = ¼ between A, E and C, and from where nothing opens, N =
/// ∂N/∂s = 0.
#[test]
fn the_plane_of_fig_1b_has_the_curves_of_its_reactions() {
    let models = models();
    let sweep = zigzag(&models, "lambda", "phi").vary("lambda=0.05:0.75:5").unwrap();
    let found = sweep.vary("phi=0.45:1.5:5").unwrap().boundaries(1e-10).unwrap();
    let between = |a: &str, b: &str| {
        let mut curves = found.iter().filter(|curve| {
            [curve.left.as_str(), &curve.right] == [a, b] || [curve.left.as_str(), &curve.right] == [b, a]
        });
        let curve = curves.next().unwrap_or_else(|| panic!("{a} | {b}: {found:?}"));
        assert!(curves.next().is_none(), "{a} | {b}: {found:?}");
        curve
    };
    let quarter = between("A, E", "C");
    assert!(quarter.points.len() > 10 && quarter.points.iter().all(|point| (point[0] - 0.25).abs() < 1e-8));
    for (opens, which) in [("C", 0), ("A, E", 1)] {
        let curve = between("none", opens);
        assert!(curve.points.len() > 5);
        for &[lambda, phi] in &curve.points {
            // The least reaction on the way down.
            let least = |s0: f64| {
                let at = |k: usize| reactions(lambda, s0, s0 * k as f64 / 4000.0)[which];
                let k = (1..4000).min_by(|&a, &b| at(a).total_cmp(&at(b))).unwrap();
                let (a, b, c) = (at(k - 1), at(k), at(k + 1));
                b - (c - a).powi(2) / (8.0 * (a - 2.0 * b + c))
            };
            assert!(least(phi.sin()).abs() < 1e-7, "{opens} at {lambda}, {phi}: {}", least(phi.sin()));
        }
    }
}
