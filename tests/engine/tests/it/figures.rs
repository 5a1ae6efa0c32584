//! Signs, sides and branches that the figure settles, with the parameters of a model.

use liftoff::ModelError;
use liftoff::prelude::*;

/// Of coordinates computed in a few operations from numbers near 1.
const ROUNDING: f64 = 1e-14;

/// With every parameter 1 it stands upright at the wall.
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[support(A = floor)]
#[support(B = wall(0))]
#[figure(A = (sqrt(l * l - h * h), 0), B = (0, h))]
#[coordinate(phi = angle(AB), from = horizontal)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
struct Ladder {
    m: f64,
    l: f64,
    g: f64,
    h: f64,
}

#[test]
fn a_ladder_leans_on_the_wall_in_front_of_it() {
    let h: f64 = 0.8;
    let ladder = Ladder { m: 1.0, l: 1.0, g: 9.81, h };
    let phi = ladder.nominal()[0];
    assert!((phi - h.atan2((1.0 - h * h).sqrt())).abs() < ROUNDING, "{phi}");
    let simulation = Simulation::new(&ladder).unwrap().start(Pose::new("phi", 1.0)).unwrap();
    let start = simulation.limit(0.01).run().unwrap().events()[0].clone();
    // The foot on the floor in front of the wall, the head at the wall.
    assert!((start.state[1] - 1f64.cos()).abs() < ROUNDING, "{:?}", start.state);
    assert!(start.state[2].abs() < ROUNDING, "{:?}", start.state);
}

#[test]
fn a_figure_that_cannot_be_drawn_is_refused() {
    let refused = Simulation::new(&Ladder { m: 1.0, l: 1.0, g: 9.81, h: 1.2 }).err();
    let refused = refused.expect("an error").to_string();
    assert!(
        refused.starts_with("the figure gives `phi` no number with m = 1, l = 1, g = 9.81, h = 1.2:"),
        "{refused}"
    );
}

/// With every parameter 1 the rod is not there: √(1 − 4) is no number.
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[bar(OA, mass = m, length = r)]
#[bar(AB, mass = m, length = l)]
#[pin(O = (0, 0))]
#[slider(B = horizontal(-r))]
#[figure(A = (0, r), B = (sqrt(l * l - 4 * r * r), -r))]
#[coordinate(theta = angle(OA))]
#[coordinate(phi = angle(AB), from = horizontal)]
struct Crank {
    m: f64,
    l: f64,
    r: f64,
    g: f64,
}

#[test]
fn a_crank_s_rod_is_measured_where_it_is_drawn() {
    let (l, r): (f64, f64) = (2.5, 0.7);
    let crank = Crank { m: 1.0, l, r, g: 9.81 };
    let nominal = crank.nominal();
    let phi = (2.0 * r).atan2((l * l - 4.0 * r * r).sqrt());
    assert!((nominal[0] - core::f64::consts::FRAC_PI_2).abs() < ROUNDING, "{nominal:?}");
    assert!((nominal[1] - phi).abs() < ROUNDING, "{nominal:?}");
    let simulation = Simulation::new(&crank).unwrap().start(Pose::new("theta", 1.0)).unwrap();
    let start = simulation.limit(0.01).run().unwrap().events()[0].clone();
    let closed = (r * (1.0 + 1f64.sin()) / l).asin();
    assert!((start.state[1] - closed).abs() < ROUNDING, "{:?}", start.state);
}

/// Acute and to the right of the wall with every parameter 1.
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[support(B = wall(-w))]
#[figure(A = (0, 0), B = (c, l))]
#[coordinate(phi = angle(AB), from = horizontal)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
struct Leaning {
    m: f64,
    l: f64,
    g: f64,
    c: f64,
    w: f64,
}

#[test]
fn figures_of_other_parameters_are_refused() {
    let leaning = Leaning { m: 1.0, l: 1.0, g: 9.81, c: 0.5, w: 1.0 };
    assert!(Simulation::new(&leaning).is_ok());
    let sign = Simulation::new(&Leaning { c: -0.5, ..leaning.clone() }).err();
    assert_eq!(sign, Some(ModelError::Sign { coordinate: "phi".to_owned(), by: 0.5 }));
    let side = Simulation::new(&Leaning { w: -1.0, ..leaning }).err();
    assert_eq!(side, Some(ModelError::Side { support: "B".to_owned(), by: 0.5 }));
}

/// Two bars on a pin, bent by 0.4 to the left; the same turned by half a turn.
#[derive(BarSystem)]
#[bar(OA, mass = m, length = 1)]
#[bar(AB, mass = m, length = 1)]
#[pin(O = (0, 0))]
#[torsion(OA, AB, stiffness = 10)]
#[figure(A = (-0.98, 0.19899748742132398), B = (-1.96, 0))]
struct BentLeft {
    m: f64,
}

#[derive(BarSystem)]
#[bar(OA, mass = m, length = 1)]
#[bar(AB, mass = m, length = 1)]
#[pin(O = (0, 0))]
#[torsion(OA, AB, stiffness = 10)]
#[figure(A = (0.98, -0.19899748742132398), B = (1.96, 0))]
struct BentRight {
    m: f64,
}

/// An angle between two bars is within half a turn where they are drawn, also where one points
/// above the left and the other below it.
#[test]
fn an_angle_between_bars_is_that_of_the_figure() {
    fn find_energies(bent: &impl BarSystem) -> [f64; 2] {
        let run = Simulation::new(bent).unwrap().limit(0.5).run().unwrap();
        [0.0, 0.5].map(|t| run.value(&run.output("V").unwrap(), t))
    }
    let (left, right) = (find_energies(&BentLeft { m: 1.0 }), find_energies(&BentRight { m: 1.0 }));
    let bent = 2.0 * 0.19899748742132398f64.asin();
    assert!((left[0] - 5.0 * bent * bent).abs() < 1e-12, "{left:?}");
    assert!(left.iter().zip(right).all(|(a, b)| (a - b).abs() < 1e-9), "{left:?} {right:?}");
}
