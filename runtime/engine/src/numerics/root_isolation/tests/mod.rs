//! Functions whose roots and extrema are known in closed form.

mod bandwidths;
mod bernstein;
mod bounds;
mod cases;
mod census;
mod fast;
mod histories;
mod kinks;
mod known;
mod motion;
mod searches;
mod series;
mod smooth;
mod units;

use core::f64::consts::PI;

use proptest::prelude::*;

use super::extrema::LocatedExtremum;
use super::{Accuracy, Crossing, ExtremumKind, GuardError, Root, RootStart};
use super::{extrema, find_root, find_root_series, watch};

/// θ of a root found by bisection on a function good to an ulp: the spacing of θ, twice.
const ULPS: f64 = 4.0 * f64::EPSILON;

fn product(roots: &[f64], theta: f64) -> f64 {
    roots.iter().map(|r| theta - r).product()
}

/// A positive factor that is no polynomial.
fn bend(phase: f64, theta: f64) -> f64 {
    1.0 + 0.5 * (3.0 * theta + phase).sin()
}

/// Where the first root of a function is.
fn first_root(
    mut g: impl FnMut(f64) -> f64,
    start: RootStart,
    accuracy: impl Into<Accuracy>,
) -> Result<Option<f64>, GuardError> {
    Ok(find_root(&mut g, start, accuracy.into())?.map(theta))
}

/// Where the first root of Σ cₖ θᵏ is.
fn first_root_series(c: &[f64], start: RootStart, delta: f64) -> Result<Option<f64>, GuardError> {
    Ok(find_root_series(c, start, delta)?.map(theta))
}

fn theta(root: Root) -> f64 {
    root.theta
}

fn all_extrema(g: impl FnMut(f64) -> f64, delta: f64) -> Vec<LocatedExtremum> {
    let mut found = Vec::new();
    extrema(g, delta, |extremum| found.push(extremum)).expect("finite");
    found
}

fn crossing(verdict: Result<Crossing, GuardError>) -> Option<f64> {
    match verdict {
        Ok(Crossing::At { theta }) => Some(theta),
        _ => None,
    }
}

/// Roots −0.3 … 1.3, at least 1e-6 apart and as far from the ends, and an orientation.
fn roots() -> impl Strategy<Value = (Vec<f64>, f64)> {
    let apart = |roots: &Vec<f64>| {
        let ends = roots.iter().all(|r| r.abs() > 1e-6 && (r - 1.0).abs() > 1e-6);
        ends && roots.windows(2).all(|pair| pair[1] - pair[0] > 1e-6)
    };
    prop::collection::vec(-0.3..1.3, 1..8)
        .prop_map(|mut roots: Vec<f64>| {
            roots.sort_by(f64::total_cmp);
            roots
        })
        .prop_filter("roots apart", apart)
        .prop_flat_map(|roots| (Just(roots), prop::sample::select(vec![-1.0, 1.0])))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 10_000, ..ProptestConfig::default() })]

    #[test]
    fn roots_of_polynomials((roots, sign) in roots(), phase in 0.0..6.0f64) {
        let g = |theta| sign * product(&roots, theta) * bend(phase, theta);
        let inside: Vec<f64> = roots.iter().copied().filter(|r| *r > 0.0 && *r < 1.0).collect();
        let found = first_root(g, RootStart::Free, 0.0).expect("finite");
        prop_assert_eq!(found.is_some(), !inside.is_empty(), "{:?} of {:?}", found, inside);
        if let Some(theta) = found {
            prop_assert!((theta - inside[0]).abs() <= ULPS, "{} {}", theta, inside[0]);
        }
        let down = inside.iter().copied().find(|r| g(r - 1e-7) > 0.0);
        let verdict = watch(g, RootStart::Free, 0.0).expect("finite");
        match down {
            _ if g(0.0) < 0.0 => prop_assert_eq!(verdict, Crossing::LeavesAtStart),
            Some(r) => {
                let theta = crossing(Ok(verdict)).expect("a crossing");
                prop_assert!((theta - r).abs() <= ULPS, "{} {}", theta, r);
            }
            None => prop_assert_eq!(verdict, Crossing::Clear),
        }
    }

    /// The dip between is 2.5e-15 of the curvature deep.
    #[test]
    fn pairs_a_tenth_of_a_millionth_apart(a in 1e-3..0.999f64, phase in 0.0..6.0f64, k in 0.1..10.0f64) {
        let g = |theta: f64| k * (theta - a) * (theta - a - 1e-7) * bend(phase, theta);
        let theta = crossing(watch(g, RootStart::Free, 1e-18)).expect("a crossing");
        prop_assert!((theta - a).abs() <= ULPS);
        prop_assert!((first_root(g, RootStart::Free, 0.0).expect("finite").expect("a root") - a).abs() <= ULPS);
        let up = first_root(|theta| -g(theta), RootStart::Free, 0.0).expect("finite");
        prop_assert!((up.expect("a root") - a).abs() <= ULPS);
    }

    /// Offsets of ±δ/2 touch, of 2δ do not, of −2δ cross.
    #[test]
    fn double_roots(
        a in 1e-3..0.999f64, k in 0.1..10.0f64, phase in 0.0..6.0f64, digits in 6.0..13.0f64, offset in -0.5..0.5f64,
    ) {
        let delta = 10f64.powf(-digits);
        let g = |shift: f64| {
            move |theta: f64| k * (theta - a).powi(2) * bend(phase, theta) + shift * delta
        };
        let verdict = watch(g(offset), RootStart::Free, delta).expect("finite");
        // p′ is exact to δ/100 times the degree squared; p″ is at least k/2.
        let near = delta / k + 1e-13 / k;
        let touched = matches!(verdict, Crossing::Touch { theta, value }
            if (theta - a).abs() <= near.max(1e-15) * 50.0 && (value - offset * delta).abs() < 0.01 * delta);
        prop_assert!(touched, "{:?} for {}", verdict, a);
        prop_assert_eq!(watch(g(2.0), RootStart::Free, delta), Ok(Crossing::Clear));
        prop_assert_eq!(first_root(g(2.0), RootStart::Free, delta), Ok(None));
        let theta = crossing(watch(g(-2.0), RootStart::Free, delta));
        if g(-2.0)(0.0) > 0.0 {
            let expected = a - (2.0 * delta / k / bend(phase, a)).sqrt();
            let theta = theta.expect("a crossing");
            prop_assert!(g(-2.0)(theta - 1e-12) >= 0.0 && g(-2.0)(theta + 1e-12) <= 0.0);
            prop_assert!((theta - expected).abs() < 0.2 * (a - expected), "{} {}", theta, expected);
        }
    }

    #[test]
    fn roots_and_extrema_of_a_sine(omega in 0.5..60.0f64, phase in 0.0..6.3f64, height in 1e-6..1e6f64) {
        let g = |theta: f64| height * (omega * theta + phase).sin();
        let first = (phase / PI).floor() + 1.0;
        let expected = Some((first * PI - phase) / omega).filter(|r| *r < 1.0 - 1e-9);
        let found = first_root(g, RootStart::Free, 0.0).expect("finite").filter(|r| *r < 1.0 - 1e-9);
        prop_assert_eq!(found.is_some(), expected.is_some());
        if let (Some(found), Some(expected)) = (found, expected) {
            // Rounding of the argument, up to 66.
            prop_assert!((found - expected).abs() < 20.0 * f64::EPSILON * 66.0 / omega);
        }
        // An extremum within 1e-6 of an end does not stand out from it.
        let peak = |i: f64| ((i + 0.5) * PI - phase) / omega;
        let clear = |theta: f64| theta > 1e-6 / omega && theta < 1.0 - 1e-6 / omega;
        let expected: Vec<f64> = (-1..40).map(|i| peak(f64::from(i))).filter(|t| clear(*t)).collect();
        let found: Vec<LocatedExtremum> = all_extrema(g, 0.0).into_iter().filter(|e| clear(e.theta)).collect();
        prop_assert_eq!(found.len(), expected.len(), "{:?} {:?}", found, expected);
        for (found, expected) in found.iter().zip(expected) {
            // Coefficients to 1e-15, their derivative times degree², over ω².
            prop_assert!((found.theta - expected).abs() < 1e-11, "{:?} {}", found, expected);
            let maximum = found.kind == ExtremumKind::Maximum;
            prop_assert_eq!(maximum, found.value > 0.0);
        }
    }

    /// N/mg = ¼ − (3/2)sS + (9/4)s², S = 1 + ε: two roots √(S²−1) · 2/3 apart.
    #[test]
    fn a_frame(exponent in 2.0..12.0f64, from in 0.0..0.3f64, width in 0.1..0.6f64) {
        let frame = |eps: f64| move |theta: f64| {
            let (s, big) = ((from + width * theta).sin(), 1.0 + eps);
            0.25 - 1.5 * s * big + 2.25 * s * s
        };
        let eps = 10f64.powf(-exponent);
        let delta = 1e-15;
        let at = |s: f64| (s.asin() - from) / width;
        let root = |eps: f64| at((1.0 + eps - (eps * (2.0 + eps)).sqrt()) / 3.0);
        let touch = at(1.0 / 3.0);
        let verdict = watch(frame(eps), RootStart::Free, delta).expect("finite");
        if root(eps) > 1e-6 && touch < 0.999 {
            let theta = crossing(Ok(verdict)).expect("a crossing");
            // The slope at the root is 3/2 √(2ε); rounding of N is 2e-16.
            prop_assert!((theta - root(eps)).abs() < 1e-15 / (width * eps.sqrt()));
            let graze = watch(frame(0.0), RootStart::Free, delta).expect("finite");
            let touched = matches!(graze, Crossing::Touch { theta, .. } if (theta - touch).abs() < 1e-12 / width);
            prop_assert!(touched, "{:?}", graze);
        } else if touch > 1.001 && root(eps) > 1.0 {
            prop_assert_eq!(verdict, Crossing::Clear);
        }
        prop_assert_eq!(watch(frame(-eps), RootStart::Free, 1e-15), Ok(Crossing::Clear));
    }

    /// A gap after lift-off rises as θ³, as θ² or as θ, and closes at `b`, or never opens.
    #[test]
    fn known_roots_at_the_start(order in 1..4, b in 0.1..0.9f64, size in 1e-9..1.0f64, noise in -1.0..1.0f64) {
        let delta = 1e-13;
        let gap = |theta: f64| size * theta.powi(order) * (b - theta) + 0.5 * noise * delta;
        let theta = crossing(watch(gap, RootStart::Root, delta)).expect("a crossing");
        prop_assert!((theta - b).abs() < 2.0 * delta / (size * 0.1f64.powi(order)), "{}", theta);
        let closed = watch(|theta| -gap(theta), RootStart::Root, delta);
        prop_assert_eq!(closed, Ok(Crossing::LeavesAtStart));
        let rising = |theta: f64| size * theta.powi(order) + 0.5 * noise * delta;
        prop_assert_eq!(watch(rising, RootStart::Root, delta), Ok(Crossing::Clear));
        prop_assert_eq!(first_root(rising, RootStart::Root, delta), Ok(None));
    }
}
