//! Equilibria with their reactions, and what has none.

use liftoff::prelude::*;
use liftoff_analysis::{AnalysisError, Equilibrium, LimitEnd, Stability, Subject, equilibria, load_limit};
use liftoff_core::system::precise;
use liftoff_fixtures::{Plank, SpringPendulum};

fn resting<M: BarSystem>(model: &M, start: Pose) -> Result<Vec<Equilibrium>, AnalysisError> {
    let simulation = Simulation::new(model).unwrap().start(start).unwrap();
    equilibria(&Subject::new(&simulation, precise::<M>(model.parameters().as_ref())).unwrap())
}

/// Five feet under a plank with its centre of mass above the middle one: each bears between nothing
/// and what the lever of the far end lets it, the end feet a half, those next to them two thirds,
/// the middle one all.
#[test]
fn reactions_of_a_plank_are_known_between_bounds() {
    let plank = Plank { m: 2.0, i: 1.0, c: 2.0, d: 1.0, g: 10.0 };
    let found = resting(&plank, Pose::nominal()).unwrap();
    let [rest] = &found[..] else { panic!("{found:?}") };
    assert_eq!((rest.closed.len(), rest.stability()), (5, Stability::Neutral));
    for (load, most) in rest.loads.iter().zip([0.5, 2.0 / 3.0, 1.0, 2.0 / 3.0, 0.5]) {
        let [low, high] = load.normal;
        assert!(low.abs() < 1e-7 && (high - 20.0 * most).abs() < 1e-7, "{load:?}");
    }
}

/// A bar that lies on two rough feet.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[support(A = floor, rough)]
#[support(B = floor, rough)]
#[figure(A = (0, 0), B = (l, 0))]
#[coordinate(phi = angle(AB), from = right)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
struct Lying {
    m: f64,
    l: f64,
    g: f64,
}

/// Each foot bears a half; along the floor they may push or pull against each other without bound.
#[test]
fn one_reaction_without_bounds_leaves_others_unique() {
    let found = resting(&Lying { m: 2.0, l: 3.0, g: 9.81 }, Pose::nominal()).unwrap();
    let [rest] = &found[..] else { panic!("{found:?}") };
    assert_eq!(rest.closed, ["A", "B"]);
    for load in &rest.loads {
        assert!(load.normal.iter().all(|force| (force - 9.81).abs() < 1e-11), "{load:?}");
        assert_eq!(load.friction, Some([f64::NEG_INFINITY, f64::INFINITY]));
    }
}

/// A bar between a floor and a wall, both with dry friction.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[support(A = floor, friction = mu)]
#[support(B = wall(0), facing = right, friction = nu)]
#[figure(A = (l / 2, 0), B = (0, sqrt(3) * l / 2))]
#[coordinate(phi = angle(AB), from = horizontal)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
struct Leaning {
    m: f64,
    l: f64,
    mu: f64,
    nu: f64,
    g: f64,
}

/// It can stay where tan φ ≥ (1 − μ ν)/2μ, and nowhere below. At the border both friction forces
/// are at their limits: the wall bears N(B) = μ m g/(1 + μ ν).
#[test]
fn a_ladder_with_friction_stays_where_its_cones_meet() {
    let (m, l, mu, nu, g) = (2.0, 3.0, 0.4, 0.3, 9.81);
    let least = f64::atan((1.0 - mu * nu) / (2.0 * mu));
    let at = |phi: f64| resting(&Leaning { m, l, mu, nu, g }, Pose::new("phi", phi));
    for above in [1e-6, 0.1, 0.3] {
        let found = at(least + above).unwrap();
        let rest = found.iter().find(|rest| rest.closed == ["A", "B"]).unwrap();
        assert_eq!(rest.stability(), Stability::Fixed);
        let wall = rest.loads[1].normal;
        if above < 1e-5 {
            let border = mu * m * g / (1.0 + mu * nu);
            assert!(wall.iter().all(|n| (n / border - 1.0).abs() < 1e-4), "{wall:?} {border}");
        } else {
            assert!(wall[1] - wall[0] > 0.1, "{wall:?}");
        }
    }
    for below in [1e-6, 0.1] {
        // Upright, on its foot, it can be.
        let found = at(least - below).unwrap_or_default();
        assert!(found.iter().all(|rest| rest.closed == ["A"]), "{found:?}");
    }
}

/// A bar without support.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[figure(A = (0, 0), B = (l, 0))]
#[coordinate(phi = angle(AB))]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
struct Falling {
    m: f64,
    l: f64,
    g: f64,
}

#[test]
fn falling_bodies_have_no_equilibrium() {
    let error = resting(&Falling { m: 1.0, l: 1.0, g: 9.81 }, Pose::nominal()).map(|found| found.len());
    assert_eq!(error, Err(AnalysisError::NotFound { tried: 1 }));
}

/// A bar that is shaken: nothing stays at rest.
#[derive(BarSystem)]
#[bar(OA, mass = m, length = l)]
#[pin(O = (0, 0))]
#[couple(OA = k * sin(t))]
#[figure(A = (0, -l))]
#[coordinate(phi = angle(OA), from = down)]
struct Shaken {
    m: f64,
    l: f64,
    k: f64,
}

#[test]
fn equilibria_with_time_are_refused() {
    let error = resting(&Shaken { m: 1.0, l: 1.0, k: 1.0 }, Pose::new("phi", 0.1)).map(|found| found.len());
    assert_eq!(error, Err(AnalysisError::Timed));
}

/// It hangs at y = l + m g/k, 1 m down or 10 km: there is no end before k = 0, whatever is asked
/// for. There it goes on beyond bounds.
#[test]
fn a_weight_on_a_spring_hangs_however_soft_the_spring_is() {
    let [m, l, c, g] = [1.0, 1.0, 0.5, 9.81];
    let subject = |k: f64| {
        let spring = SpringPendulum { m, k, l, c, g };
        let simulation =
            Simulation::new(&spring).unwrap().start(Pose::new("x", 0.0).with("y", l + m * g / 100.0));
        Ok(Subject::new(&simulation.unwrap(), precise::<SpringPendulum>(spring.parameters().as_ref()))
            .unwrap())
    };
    let found = equilibria(&subject(100.0).unwrap()).unwrap();
    let rest = found.iter().find(|rest| rest.coordinate("y").unwrap() > 0.0).unwrap();
    for k in [0.3, 0.01, 1e-3, 1e6] {
        let limit = load_limit(&subject, rest, [100.0, k]).unwrap();
        assert!(limit.is_none(), "{k}: {limit:?}");
    }
    let limit = load_limit(&subject, rest, [100.0, 0.0]).unwrap().unwrap();
    let y = limit.rest.coordinate("y").unwrap();
    assert!(limit.value < 1e-6 && (y / (l + m * g / limit.value) - 1.0).abs() < 1e-9, "{limit:?}");
    assert_eq!(limit.end, LimitEnd::Fold);
}

/// A beam on a hinge that a spring holds.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(OA, mass = m, length = l)]
#[pin(O = (0, 0))]
#[spring(AQ, stiffness = k, length = l)]
#[ground(Q = (l, l))]
#[figure(A = (l, 0))]
#[coordinate(phi = angle(OA), from = right)]
struct Held {
    m: f64,
    l: f64,
    k: f64,
    g: f64,
}

/// What the hinge of a beam bears is its weight without what the spring does: the moments about A
/// and the sums of both forces.
#[test]
fn joint_forces_at_rest_are_those_of_statics() {
    let (m, l, k, g) = (2.0, 1.5, 40.0, 9.81);
    let found = resting(&Held { m, l, k, g }, Pose::new("phi", 0.0)).unwrap();
    let stable = found.iter().find(|rest| rest.stability() == Stability::Stable).expect("a position of rest");
    let phi = stable.positions[0];
    let (a, q) = ([l * phi.cos(), l * phi.sin()], [l, l]);
    let along = [q[0] - a[0], q[1] - a[1]];
    let distance = along[0].hypot(along[1]);
    let spring = along.map(|part| k * (distance - l) * part / distance);
    let expected = [-spring[0], m * g - spring[1]];
    for (name, expected) in ["fx(O, OA)", "fy(O, OA)"].into_iter().zip(expected) {
        let (_, force) = stable.joint_forces.iter().find(|(known, _)| *known == name).expect(name);
        assert!((force - expected).abs() < 1e-10, "{name}: {force} for {expected}");
    }
}

/// A pendulum that a stop keeps off its lowest position, with the end bounded by an angle or by its
/// place.
macro_rules! kept_off {
    ($name:ident, $limit:meta) => {
        #[derive(BarSystem)]
        #[gravity(g)]
        #[pin(O = (0, 0))]
        #[bar(OA, mass = m, length = l)]
        #[$limit]
        #[coordinate(phi = angle(OA), from = down)]
        #[figure(A = (0.6 * l, -0.8 * l))]
        struct $name {
            m: f64,
            l: f64,
            g: f64,
        }
    };
}

kept_off!(ByAngle, limit(phi, low = 0.3));
kept_off!(ByPlace, limit(x(A), low = 0.29552020666133957 * l));

/// N = m g l/2 sin φ of the angle; the place has l cos φ for a lever.
#[test]
fn what_leans_on_a_limit_is_at_rest_there() {
    let (m, l, g) = (2.0, 1e-3, 9.81);
    let at = |found: Vec<Equilibrium>| {
        let [rest] = &found[..] else { panic!("{found:?}") };
        assert_eq!(rest.closed.len(), 1);
        (rest.positions[0], rest.loads[0].normal[0])
    };
    let start = || Pose::new("phi", 0.5);
    let (phi, couple) = at(resting(&ByAngle { m, l, g }, start()).unwrap());
    let (same, force) = at(resting(&ByPlace { m, l, g }, start()).unwrap());
    let moment = 0.5 * m * g * l * 0.3_f64.sin();
    assert!((phi - 0.3).abs() < 1e-12 && (same - 0.3).abs() < 1e-12, "{phi} {same}");
    assert!((couple - moment).abs() < 1e-9 * moment, "{couple}, not {moment}");
    assert!((force * l * 0.3_f64.cos() - moment).abs() < 1e-9 * moment, "{force}");
}
