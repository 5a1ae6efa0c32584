//! Which support of Fig. 1b opens first, against Newton and Euler's equations of each bar solved in 40 digits (mpmath): from
//! rest at φ₀, while A, C and E bear, with l = g = m₁ + m₂ = 1, s = sin φ, λ = m₂, φ̇² = (s₀ − s)/(⅓ + 2λs²).

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
    let sweep = Sweep::of(models.find("zigzag").unwrap());
    let sweep = sweep.set(&format!("m1=1-{lambda}")).unwrap().set(&format!("m2={lambda}")).unwrap();
    let sweep = sweep.start(&format!("phi_inner={phi}")).unwrap();
    sweep.start(&format!("phi_outer={phi}")).unwrap().observe("first open").unwrap()
}

/// N_C = 6 N_E at λ = ¼ whatever s and s₀ are: there all three open at once, below A and E do, above C.
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

/// The height from which nothing opens before B and D touch the floor: N_C (λ = ½) or N_E (λ = 0.1) touches zero there,
/// N = ∂N/∂s = 0.
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
