//! The rules on single equations, against sines and cosines as numbers.

use core::f64::consts::{FRAC_PI_2, PI};
use std::collections::BTreeMap;

use super::super::rules::{equal_angles, equal_waves, nearest};
use super::super::{CoordinateValue, Elimination};
use crate::Analysis;
use crate::algebra::{Angle, Rational, Series, Symbol};
use crate::tests::analysis;

const PHI: Symbol = Symbol::coordinate(0);
const PSI: Symbol = Symbol::coordinate(1);
const GAMMA: Symbol = Symbol::parameter(0);

/// φ and ψ, and x.
fn system() -> Analysis {
    analysis(
        "#[bar(OA, mass = m, length = l)] #[bar(AB, mass = m, length = l)] #[pin(O = (0, 0))] #[particle(P, mass = m)]
         #[coordinate(phi = angle(OA))] #[coordinate(psi = angle(AB))] #[figure(A = (l, 0), B = (2 * l, 0), P = (0, 0))]
         struct Free { m: f64, l: f64 }",
    )
}

fn angle(phi: i32, psi: i32) -> Angle {
    Angle::from_symbol(PHI).scale(phi) + Angle::from_symbol(PSI).scale(psi)
}

fn values(phi: f64, psi: f64) -> BTreeMap<Symbol, f64> {
    BTreeMap::from([(PHI, phi), (PSI, psi), (GAMMA, 0.3)])
}

/// ψ of an elimination at φ.
fn psi_at(found: &Elimination, phi: f64) -> f64 {
    let CoordinateValue::Angle(angle) = &found.value else { panic!("{found:?}") };
    assert_eq!((found.coordinate, angle.coefficient(PSI)), (1, 0));
    angle.evaluate(&|symbol| values(phi, f64::NAN)[&symbol])
}

fn is_turned(a: f64, b: f64) -> bool {
    ((a - b) / (2.0 * PI) - ((a - b) / (2.0 * PI)).round()).abs() < 1e-12
}

/// c sin φ ± c sin(ψ + γ), c cos φ ± c cos(ψ + γ): two solutions each, of which the figure tells
/// one.
#[test]
fn equal_waves_give_the_angle_of_the_figure() {
    let system = system();
    let shifted = angle(0, 1) + Angle::from_symbol(GAMMA);
    for (sine, sign, phi) in
        [(true, 1, 0.7), (true, -1, 0.7), (false, 1, 0.7), (false, -1, 0.7), (true, 1, -2.0)]
    {
        let wave = if sine { Series::sin } else { Series::cos };
        let gap = (wave(&angle(1, 0)) + wave(&shifted).scale(sign.into())).scale(Rational::new(5, 2));
        let beta = match (sine, sign) {
            (true, 1) => [-phi, PI + phi],
            (true, _) => [phi, PI - phi],
            (false, 1) => [PI - phi, PI + phi],
            (false, _) => [phi, -phi],
        };
        for psi in beta.map(|beta| beta - 0.3) {
            let sample = values(phi, psi);
            let number = gap.evaluate(&|symbol| sample[&symbol]);
            assert!(number.abs() < 1e-12, "{number}");
            let found = equal_waves(&system.kinematics, 4, &gap, &[sample]).unwrap();
            assert!(found.row == 4 && is_turned(psi_at(&found, phi), psi), "{sine} {sign} {psi}: {found:?}");
        }
    }
}

/// sin(ψ + γ) = 0 and cos(ψ + γ) = 0.
#[test]
fn a_wave_that_vanishes_gives_the_angle_of_the_figure() {
    let system = system();
    let shifted = angle(0, 1) + Angle::from_symbol(GAMMA);
    let cases = [(Series::sin(&shifted), [0.0, PI]), (Series::cos(&shifted), [FRAC_PI_2, -FRAC_PI_2])];
    for (gap, solutions) in cases {
        for psi in solutions.map(|beta| beta - 0.3) {
            let found = equal_waves(&system.kinematics, 0, &gap, &[values(0.0, psi)]).unwrap();
            assert!(is_turned(psi_at(&found, 0.0), psi), "{psi}: {found:?}");
        }
    }
}

#[test]
fn other_sums_of_waves_are_not_solved() {
    let system = system();
    let [sin, cos] = [Series::sin, Series::cos];
    let (phi, psi, x) = (angle(1, 0), angle(0, 1), Series::symbol(Symbol::coordinate(2)));
    let solved = |gap: Series| equal_waves(&system.kinematics, 0, &gap, &[values(0.7, 0.7)]).is_some();
    assert!(solved(sin(&phi) - sin(&psi)) && solved((sin(&phi) - sin(&psi)) * &x));
    assert!(!solved(sin(&phi) - sin(&psi).scale(2.into())));
    assert!(!solved(sin(&phi) - sin(&psi) * &x));
    assert!(!solved(sin(&phi) - cos(&psi)));
    assert!(!solved(sin(&phi) - sin(&psi) + Series::one()));
    assert!(!solved(sin(&phi.scale(2)) - sin(&psi.scale(2))));
}

#[test]
fn angles_outside_waves_are_equated() {
    let system = system();
    let of = |gap: &Series| equal_angles(&system.kinematics, 3, gap);
    let [phi, psi, x] = [0, 1, 2].map(|i| Series::symbol(Symbol::coordinate(i)));
    let twice = of(&(phi.scale(2.into()) - &psi)).unwrap();
    assert!(twice.row == 3 && (psi_at(&twice, 0.7) - 1.4).abs() < 1e-12);
    let against = of(&(&phi + &psi)).unwrap();
    assert!((psi_at(&against, 0.7) + 0.7).abs() < 1e-12);
    let opaque = Series::symbol(Symbol::opaque(0));
    assert!(of(&(&psi - &opaque)).is_some());
    let cosine = Series::cos(&angle(1, 0));
    for other in [&x - &phi, &psi * &cosine, &phi * &psi, phi.scale(2.into()) - psi.scale(3.into())] {
        assert!(of(&other).is_none(), "{other:?}");
    }
    assert!(of(&(phi.scale(Rational::HALF) - &psi)).is_none());
    assert!(of(&(Series::symbol(Symbol::rate(0)) - &psi)).is_none() && of(&(&psi - Series::one())).is_none());
}

/// Of φ = 0 and ψ = 0 the one that is nearer in all figures; where their distances from zero differ
/// by less than 1e-9, both.
#[test]
fn the_branch_is_the_one_near_in_every_figure() {
    let [a, b] = [angle(1, 0), angle(0, 1)];
    let of = |figures: &[(f64, f64)]| {
        let samples: Vec<_> = figures.iter().map(|&(phi, psi)| values(phi, psi)).collect();
        nearest([a.clone(), b.clone()], &samples).map(|(branch, open)| {
            assert!([(&a, &b), (&b, &a)].contains(&(&branch.zero, &branch.other)));
            (branch.zero == a, open)
        })
    };
    let cases: [(&[(f64, f64)], _); 11] = [
        (&[(0.1, 1.0)], Some((true, false))),
        (&[(-1.0, 0.1)], Some((false, false))),
        (&[(0.1, -1.0), (-0.1, 1.0)], Some((true, false))),
        (&[(0.1, 1.0), (0.2, 1.0)], Some((true, true))),
        (&[(1.0, 0.1), (1.0, 0.2)], Some((false, true))),
        (&[(0.1, 1.0), (1.0, 0.1)], None),
        (&[(1.0, -1.0), (0.5, 0.5)], Some((true, false))),
        (&[(1.0, 1.0), (1.0, 0.1)], Some((false, true))),
        (&[(1.0, 1.0), (0.1, 1.0)], Some((true, true))),
        (&[(1.0, 1.0 - 1e-10), (0.1, 1.0)], Some((true, true))),
        (&[(1.0, 1.0 + 1e-10), (1.0, 0.1)], Some((false, true))),
    ];
    for (figures, expected) in cases {
        assert_eq!(of(figures), expected, "{figures:?}");
    }
    // Whole turns away is near.
    assert_eq!(of(&[(0.1 - 4.0 * PI, 1.0)]), Some((true, false)));
    // What has no number in the figure leaves nothing to be checked.
    let drive = Angle::from_symbol(Symbol::opaque(0));
    let samples = [values(0.1, 1.0), values(0.2, 1.0)];
    let (_, open) = nearest([&a + &drive, &b + &drive], &samples).unwrap();
    assert!(!open);
}
