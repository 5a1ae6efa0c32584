//! Frequencies, growth rates and shapes against closed forms.

use std::f64::consts::{FRAC_PI_2, PI};

use liftoff::prelude::*;
use liftoff_analysis::{AnalysisError, Equilibrium, Linearisation, Mode, Stability, Subject, equilibria};
use liftoff_core::system::precise;
use liftoff_fixtures::{DoublePendulum, SpringPendulum};
use nalgebra::DMatrix;

fn subject<M: BarSystem>(model: &M, start: Pose) -> Subject {
    let simulation = Simulation::new(model).unwrap().start(start).unwrap();
    Subject::new(&simulation, precise::<M>(model.parameters().as_ref())).unwrap()
}

fn modes<M: BarSystem>(model: &M, start: Pose, closed: &[&str]) -> Vec<Mode> {
    let subject = subject(model, start);
    let linear = Linearisation::compute(&subject, subject.contacts(closed).unwrap()).unwrap();
    assert!(linear.residual() < 1e-13, "{:e}", linear.residual());
    linear.modes()
}

/// Two equal bars: ω² = (3 ∓ 6/√7) g/l.
#[test]
fn a_double_pendulum_of_bars_has_its_frequencies() {
    let (l, g) = (0.7, 9.81);
    let found = modes(&DoublePendulum { m: 2.0, l, g }, Pose::nominal(), &[]);
    for (mode, sign) in found.iter().zip([-1.0, 1.0]) {
        let exact = (3.0 + sign * 6.0 / 7f64.sqrt()) * g / l;
        let error = mode.rate.im * mode.rate.im / exact - 1.0;
        assert!(error.abs() < 1e-13 && mode.rate.re == 0.0, "{error:e}");
    }
    // The second equation: ½ ω² a + (⅓ ω² − ½ g/l) b = 0.
    let square = (3.0 - 6.0 / 7f64.sqrt()) * g / l;
    let ratio = (0.5 * g / l - square / 3.0) / (0.5 * square);
    assert!((found[0].shape[0] / found[0].shape[1] - ratio).norm() < 1e-12);
}

/// From any pose all four equilibria are found, the one beside it first; as many modes grow as bars
/// stand. Where both bars are horizontal no force tells which way to look.
#[test]
fn a_double_pendulum_has_four_equilibria() {
    let all = [(0.0, 0.0, 0), (PI, PI, 2), (0.0, PI, 1), (PI, 0.0, 1)];
    let model = DoublePendulum { m: 1.0, l: 1.0, g: 9.81 };
    let from = |a: f64, b: f64| equilibria(&subject(&model, Pose::new("a", a).with("b", b))).unwrap();
    let is_near = |rest: &Equilibrium, place: [f64; 2]| {
        let turn = |i: usize| (rest.positions[i] - place[i]) / (2.0 * PI);
        (0..2).all(|i| (turn(i) - turn(i).round()).abs() < 1e-15)
    };
    for (a, b, growing) in all {
        let found = from(a + 0.1, b - 0.15);
        let stability = if growing == 0 { Stability::Stable } else { Stability::Unstable(growing) };
        assert!(found.len() == 4 && is_near(&found[0], [a, b]), "{found:?}");
        assert_eq!(found[0].stability(), stability, "{a} {b}");
    }
    let found = from(PI / 2.0, PI / 2.0);
    assert_eq!(found.len(), 4);
    assert!(all.iter().all(|(a, b, _)| found.iter().any(|rest| is_near(rest, [*a, *b]))));
}

/// Fig. 1b of the paper, both halves.
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[bar(AB, mass = m2, length = l)]
#[bar(BC, mass = m1, length = l)]
#[bar(CD, mass = m1, length = l)]
#[bar(DE, mass = m2, length = l)]
#[support(A = floor)]
#[support(C = floor)]
#[support(E = floor)]
#[figure(
    A = (-6 * l / 5, 0),
    B = (-3 * l / 5, 4 * l / 5),
    C = (0, 0),
    D = (3 * l / 5, 4 * l / 5),
    E = (6 * l / 5, 0),
)]
#[coordinate(ab = angle(AB), from = horizontal)]
#[coordinate(bc = angle(BC), from = horizontal)]
#[coordinate(cd = angle(CD), from = horizontal)]
#[coordinate(de = angle(DE), from = horizontal)]
#[coordinate(x = x(C))]
#[coordinate(y = y(C))]
struct Frame {
    m1: f64,
    m2: f64,
    l: f64,
    g: f64,
}

/// The mirror image in x = 0: each angle is that of the image, x is opposite.
fn reflection() -> DMatrix<f64> {
    let images = [(0, 3, 1.0), (1, 2, 1.0), (2, 1, 1.0), (3, 0, 1.0), (4, 4, -1.0), (5, 5, 1.0)];
    images.iter().fold(DMatrix::zeros(6, 6), |mut matrix, &(row, column, sign)| {
        matrix[(row, column)] = sign;
        matrix
    })
}

fn frame(lambda: f64, angles: [f64; 4]) -> Subject {
    let start = Pose::new("x", 0.0).with("y", 0.0);
    let names = ["ab", "bc", "cd", "de"].iter().zip(angles);
    let start = names.fold(start, |pose, (name, angle)| pose.with(*name, angle));
    subject(&Frame { m1: 1.0 - lambda, m2: lambda, l: 1.3, g: 9.81 }, start)
}

/// Upright, the antisymmetric motion of Fig. 1b grows √[(1/3 + 2λ)/(1/12 + λ − λ²)] times as fast
/// as the symmetric one, λ the outer bars' part of the mass.
#[test]
fn the_symmetric_motion_of_the_frame_is_unstable() {
    for lambda in [0.0, 0.25, 0.5, 0.75, 1.0] {
        let subject = frame(lambda, [FRAC_PI_2; 4]);
        let all = subject.contacts(&["A", "C", "E"]).unwrap();
        let linear = Linearisation::compute(&subject, all).unwrap();
        assert!(linear.residual() < 1e-13, "{:e}", linear.residual());
        let parts = linear.by_symmetry(&reflection()).unwrap();
        let exact = ((1.0 / 3.0 + 2.0 * lambda) / (1.0 / 12.0 + lambda - lambda * lambda)).sqrt();
        assert!((parts.growth_ratio().unwrap() / exact - 1.0).abs() < 1e-10, "{lambda}: {parts:?}");
        // Together they are all modes.
        let growing = |linear: &Linearisation| {
            linear.modes().iter().map(Mode::growth).filter(|rate| *rate > 1e-6).collect::<Vec<_>>()
        };
        let [antisymmetric, symmetric] = [&parts.antisymmetric, &parts.symmetric].map(growing);
        let (apart, together) = ([antisymmetric, symmetric].concat(), growing(&linear));
        assert_eq!((apart.len(), together.len()), (2, 2), "{lambda}: {apart:?} {together:?}");
        assert!(
            apart.iter().zip(&together).all(|(a, b)| (a - b).abs() < 1e-12 * b),
            "{apart:?} {together:?}"
        );
    }
}

#[test]
fn asymmetric_systems_have_no_symmetric_modes() {
    let lean = frame(0.5, [1.4, 1.4, 1.5, 1.5]);
    let fallen = frame(0.5, [1.4; 4]);
    let parts = |subject: &Subject, closed: &[&str], reflection: &DMatrix<f64>| {
        let linear = Linearisation::compute(subject, subject.contacts(closed).unwrap()).unwrap();
        linear.by_symmetry(reflection).map(|parts| [parts.symmetric.degrees(), parts.antisymmetric.degrees()])
    };
    let mirror = reflection();
    assert_eq!(parts(&fallen, &["A", "C", "E"], &mirror), Ok([1, 2]));
    assert_eq!(parts(&fallen, &[], &mirror), Ok([3, 3]));
    // Neither a position, nor contacts, nor a reflection that are symmetric.
    for (subject, closed, reflection) in [
        (&lean, &["A", "C", "E"][..], &mirror),
        (&fallen, &["A", "C"], &mirror),
        (&fallen, &["A", "C", "E"], &DMatrix::identity(5, 5)),
        (&fallen, &["A", "C", "E"], &(2.0 * &mirror)),
        (&fallen, &["A", "C", "E"], &(f64::NAN * &mirror)),
    ] {
        assert_eq!(parts(subject, closed, reflection), Err(AnalysisError::Asymmetric));
    }
}

/// A ladder between floor and wall, its foot held by a spring from the wall.
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[support(A = floor)]
#[support(B = wall(0), facing = right)]
#[ground(O = (0, 0))]
#[spring(OA, stiffness = k, length = r)]
#[figure(A = (l / 2, 0), B = (0, sqrt(3) * l / 2))]
#[coordinate(phi = angle(AB), from = horizontal)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
struct Ladder {
    m: f64,
    l: f64,
    k: f64,
    r: f64,
    g: f64,
}

/// T = ⅙ m l² φ̇², V = ½ m g l sin φ + ½ k (l cos φ − r)²: the constrained mode, and what bears
/// there.
#[test]
fn a_ladder_held_by_a_spring_vibrates() {
    let (m, l, k, r, g) = (3.0, 2.0, 400.0, 0.9, 9.81);
    let subject = subject(&Ladder { m, l, k, r, g }, Pose::new("phi", 1.1));
    let found = equilibria(&subject).unwrap();
    let both = found.iter().find(|rest| rest.closed == ["A", "B"]).unwrap();
    let phi = both.coordinate("phi").unwrap();
    let stretch = l * phi.cos() - r;
    let force = 0.5 * m * g * l * phi.cos() - k * stretch * l * phi.sin();
    assert!(force.abs() < 1e-12 * m * g * l, "{force:e} at {phi}");
    let stiffness =
        -0.5 * m * g * l * phi.sin() + k * l * l * phi.sin() * phi.sin() - k * stretch * l * phi.cos();
    let exact = stiffness / (m * l * l / 3.0);
    let modes = both.linear.modes();
    assert!((modes[0].frequency().powi(2) / exact - 1.0).abs() < 1e-12, "{modes:?} {exact}");
    assert_eq!(both.stability(), Stability::Stable);
    let [floor, wall] = &both.loads[..] else { panic!("{:?}", both.loads) };
    assert!(floor.normal.iter().all(|n| (n - m * g).abs() < 1e-10), "{floor:?}");
    assert!(wall.normal.iter().all(|n| (n - k * stretch).abs() < 1e-9), "{wall:?} {}", k * stretch);
}

/// ẍ + (c/m) ẋ + (k/m) x = 0, stretched by its weight; across it swings with ω² = g / length.
#[test]
fn a_damped_spring_has_its_decay() {
    let pendulum = SpringPendulum { m: 2.0, l: 0.5, k: 50.0, c: 3.0, g: 9.81 };
    let SpringPendulum { m, l, k, c, g } = pendulum;
    let found = equilibria(&subject(&pendulum, Pose::nominal())).unwrap();
    let rest = found.iter().find(|rest| rest.stability() == Stability::Stable).unwrap();
    let modes = rest.linear.modes();
    let axial = modes.iter().find(|mode| mode.growth() < -1e-3).unwrap();
    assert!((axial.growth() + 0.5 * c / m).abs() < 1e-12, "{axial:?}");
    assert!((axial.frequency() - (k / m).sqrt()).abs() < 1e-12, "{axial:?}");
    assert!((axial.damping_ratio() - 0.5 * c / (m * k).sqrt()).abs() < 1e-12);
    let swing = modes.iter().find(|mode| mode.growth().abs() < 1e-9).unwrap();
    assert!((swing.frequency().powi(2) - g / (l + m * g / k)).abs() < 1e-11, "{swing:?}");
}
