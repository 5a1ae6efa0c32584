//! The judge against closed forms and numbers of 25 digits that no engine had a part in; more of
//! them are among the tests of references, which are its motions.

use liftoff_core::scalar::{DoubleDouble, Real, Scalar};
use liftoff_judge::{Change, Judge, Motion, Task};

const MOST_WORK: u64 = 2 * Task::WORK;

fn follow(judge: &Judge, state: &[f64], until: f64) -> Motion {
    let task = Task { most_work: MOST_WORK, ..Task::new(state, until) };
    let motion = judge.follow(&task);
    assert_eq!(motion.stopped, None);
    motion
}

/// The number with these digits, of which 30 decimals are kept.
fn digits(text: &str) -> DoubleDouble {
    let hi: f64 = text.parse().expect("a number");
    let places = |text: &str| -> i128 {
        let (whole, part) = text.split_once('.').expect("decimals");
        format!("{whole}{part:0<30.30}").parse().expect("digits")
    };
    let low = places(text) - places(&format!("{hi:.40}"));
    DoubleDouble::new(hi, low as f64 * 1e-30)
}

fn assert_near(value: DoubleDouble, text: &str, within: f64) {
    let error = (value - digits(text)).abs().to_f64();
    assert!(error < within, "{error:e} of {text}: {value:?}");
}

const BALL: &str = "#[gravity(g)] #[particle(P, mass = m)] #[support(P = floor, restitution = e)] \
    #[figure(P = (0, 1))] #[coordinate(x = x(P))] #[coordinate(y = y(P))] struct Ball { m: f64, g: f64, e: f64 }";

/// tₙ = √(2h/g) (1 + 2e + … + 2eⁿ).
#[test]
fn a_ball_bounces() {
    let judge = Judge::new(BALL, &[1.0, 9.81, 0.8], &["x", "y"]).expect("a scene");
    let motion = follow(&judge, &[0.0, 1.0, 0.0, 0.0], 2.5);
    let expected = [
        "0.45152364098573089300438960606833",
        "1.173961466562900361914768366573",
        "1.7519117270246359691257556876129",
        "2.2142719353940244805606929945539",
    ];
    assert_eq!(motion.events.len(), 4);
    for (event, text) in motion.events.iter().zip(expected) {
        assert_eq!(event.change, Change::Impact);
        assert_near(event.t, text, 1e-27);
    }
    assert_near(motion.end[1], "0.11795005964214820531258281700668", 1e-26);
    assert_near(motion.end[3], "-0.98869085614313927624287317156911", 1e-26);
}

/// √(2h/g) (1 + e)/(1 − e) for e = 0.8, h = 1: 9 √(2/g).
#[test]
fn infinitely_many_impacts_come_to_their_end() {
    let judge = Judge::new(BALL, &[1.0, 2.0, 0.8], &["x", "y"]).expect("a scene");
    let motion = follow(&judge, &[0.0, 1.0, 1.0, 0.0], 10.0);
    let last = motion.events.last().expect("events");
    assert_eq!(last.change, Change::Settle);
    // e = 0.8 is the double nearest to it.
    let e = DoubleDouble::from_f64(0.8);
    let one = DoubleDouble::from_f64(1.0);
    let end = (one + e) / (one - e);
    assert!((last.t - end).abs().to_f64() < 1e-24, "{:?} {end:?}", last.t);
    assert!(motion.end[1].abs().to_f64() < 1e-28);
}

/// MECHANICS 3, λ = 1/2: C opens first, at 0.465444058966, then A and E at 0.3936146021 and
/// 0.3939232502.
#[test]
fn the_feet_of_the_zigzag_open_one_after_the_other() {
    let text = "#[gravity(g)] #[bar(AB, mass = m2, length = l)] #[bar(BC, mass = m1, length = l)] \
        #[bar(CD, mass = m1, length = l)] #[bar(DE, mass = m2, length = l)] \
        #[support(A = floor)] #[support(C = floor)] #[support(E = floor)] #[mirror(x = 0)] \
        #[figure(A = (-6 * l / 5, 0), B = (-3 * l / 5, 4 * l / 5), C = (0, 0))] \
        #[coordinate(outer = angle(AB), from = right)] #[coordinate(inner = angle(BC), from = right)] \
        #[coordinate(y = y(C))] struct Zigzag { m1: f64, m2: f64, l: f64, g: f64 }";
    let judge = Judge::new(text, &[0.5, 0.5, 1.0, 1.0], &["outer", "inner", "y"]);
    let judge = judge.unwrap_or_else(|error| panic!("{error}"));
    let phi: f64 = 1.2;
    // On the energy level of rest at π/2.
    let rate = -((1.0 - phi.sin()) / (1.0 / 3.0 + phi.sin() * phi.sin())).sqrt();
    let motion = follow(&judge, &[phi, -phi, 0.0, rate, -rate, 0.0], 1.7);
    let opened: Vec<_> = motion.events.iter().map(|event| (event.change, event.contacts.clone())).collect();
    assert_eq!(opened[..2], [(Change::Open, vec![1]), (Change::Open, vec![0, 2])], "{opened:?}");
    assert_near(motion.events[0].state[0], "0.465444058966", 1e-11);
    assert_near(-motion.events[1].state[1], "0.3936146021", 1e-9);
    assert_near(motion.events[1].state[0], "0.3939232502", 1e-9);
}

/// Lengths, times and masses in other units, by powers of ten: the same motion.
#[test]
fn units_do_not_matter() {
    let text = "#[gravity(g)] #[bar(AD, mass = m, length = l)] #[bar(DB, mass = m, length = l)] \
        #[support(P = corner(-l / 2, 0), under = AD)] #[support(Q = corner(l / 2, 0), under = DB)] \
        #[figure(D = (0, 0), A = (-l, 0), B = (l, 0))] #[coordinate(phi = angle(DB), from = horizontal)] \
        #[coordinate(y = -y(D))] #[mirror(x = 0)] struct Pair { m: f64, l: f64, g: f64 }";
    for [m, l, t] in [[1.0; 3], [1.0, 1e9, 1.0], [1.0, 1e-9, 1.0], [1.0, 1.0, 1e9], [1e9, 1.0, 1e-9]] {
        let judge = Judge::new(text, &[m, l, 9.81 * l / t / t], &["phi", "y"]).expect("a scene");
        let phi: f64 = 0.1;
        let motion = follow(&judge, &[phi, 0.5 * l * phi.tan(), 0.0, 0.0], 1.2 * t);
        assert_eq!(motion.events[0].contacts, [0, 1]);
        let opens = motion.events[0].t.to_f64() / t;
        assert!((opens - 0.8293618472282603).abs() < 1e-12, "{m} {l} {t}: {opens}");
    }
}

/// What ends a motion is found: y = ½ on the way up after the first impact, where the rate jumps
/// and −y' < 0 is no more.
#[test]
fn conditions_are_met() {
    use liftoff_judge::{Condition, Expression, Function, Operator, Relation};
    let judge = Judge::new(BALL, &[1.0, 2.0, 1.0], &["x", "y"]).expect("a scene");
    let y = |order| Expression::Coordinate { index: 1, order };
    let condition = |difference, relation| Condition { difference, relation, action: None };
    let less = |a, b| Expression::Join(Operator::Subtract, Box::new(a), Box::new(Expression::Number(b)));
    let end = |conditions: &[Condition]| {
        let motion = judge.follow(&Task { conditions, ..Task::new(&[0.0, 1.0, 0.0, 0.0], 9.0) });
        let last = motion.events.last().expect("an event").clone();
        (last.change, last.t.to_f64(), motion.end[1].to_f64())
    };
    let root = 0.5_f64.sqrt();
    // y = 1 − t²: below ½ at √½, above it again at 2 − √½.
    for (relation, t) in [(Relation::Changes, root), (Relation::Falls, root), (Relation::Rises, 2.0 - root)] {
        let (change, at, y) = end(&[condition(less(y(0), 0.5), relation)]);
        assert_eq!(change, Change::Stop);
        assert!((at - t).abs() < 1e-15 && (y - 0.5).abs() < 1e-15, "{relation:?} {at} {y}");
    }
    // At rest y' = 0 is not met, and not where it jumps, but at the top after the impact.
    let (_, at, _) = end(&[condition(y(1), Relation::Changes)]);
    assert!((at - 2.0).abs() < 1e-14, "{at}");
    // A sine of many turns: sin 300 t falls below zero at π/300.
    let turns =
        Expression::Join(Operator::Multiply, Box::new(Expression::Number(300.0)), Box::new(Expression::Time));
    let sine = Expression::Apply(Function::Sin, Box::new(turns));
    let (_, at, _) = end(&[condition(sine, Relation::Falls)]);
    assert!((at - core::f64::consts::PI / 300.0).abs() < 1e-15, "{at}");
    // E = 2 y + y'²/2 = 2: never.
    let energy =
        Expression::Join(Operator::Add, Box::new(Expression::Kinetic), Box::new(Expression::Potential));
    let (change, ..) = end(&[condition(less(energy, 1.999), Relation::Falls)]);
    assert_ne!(change, Change::Stop);
}

/// Two loops of parallelograms through every position in which all bars are level: φ̇² = φ̇₀² + 7 g
/// (1 − cos φ)/3l.
#[test]
fn loops_pass_singular_positions() {
    let text = "#[gravity(g)] #[bar(AB, mass = m, length = l)] #[bar(CD, mass = m, length = l)] \
        #[bar(EF, mass = m, length = l)] #[bar(BD, mass = m, length = l)] #[bar(DF, mass = m, length = l)] \
        #[pin(A = (0, 0))] #[pin(C = (l, 0))] #[pin(E = (2 * l, 0))] \
        #[figure(B = (0, l), D = (l, l), F = (2 * l, l))] #[coordinate(phi = -angle(AB), from = up)] \
        #[coordinate(phi_c = -angle(CD), from = up)] #[coordinate(phi_e = -angle(EF), from = up)] \
        #[coordinate(psi_b = angle(BD))] #[coordinate(psi_d = angle(DF))] struct Bars { m: f64, l: f64, g: f64 }";
    let judge = Judge::new(text, &[1.0, 1.0, 9.0], &["phi", "phi_c", "phi_e", "psi_b", "psi_d"]);
    let judge = judge.unwrap_or_else(|error| panic!("{error}"));
    let motion = follow(&judge, &[0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 0.0, 0.0], 4.0);
    let (phi, rate) = (motion.end[0], motion.end[5]);
    let one = DoubleDouble::from_f64(1.0);
    let square = one + DoubleDouble::from_f64(21.0) * (one - phi.sin_cos().1);
    assert!(phi.to_f64() > 6.0, "{phi:?}");
    assert!((rate * rate - square).abs().to_f64() < 1e-17, "{rate:?} {square:?}");
}
