//! Conditions that impacts and changes of forces make true, which no root of theirs tells.

use crate::switched_loads::Lifted;
use liftoff::prelude::*;

/// A ball on a floor: a load acts while it rises, and a wall is there while it does.
#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[support(P = floor, restitution = e)]
#[support(side = wall(1), under = P, facing = left, while("y' > 0"))]
#[force(lift = (0, f), at = P, while("y' > 0"))]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
#[figure(P = (0, 1))]
struct Ball {
    m: f64,
    g: f64,
    e: f64,
    f: f64,
}

/// Falls 1 in 1 and comes up with a half of its velocity 2.
const BALL: Ball = Ball { m: 1.0, g: 2.0, e: 0.5, f: 1.0 };

fn dropped(until: &[&str]) -> Trajectory {
    let start = Pose::new("x", 0.0).with("y", 1.0).with("x'", 0.3);
    let simulation = Simulation::new(&BALL).unwrap().start(start).unwrap().limit(2.9).tolerance(1e-12);
    until.iter().fold(simulation, |run, text| run.until(text).unwrap()).run().unwrap()
}

fn list_events(run: &Trajectory) -> Vec<(EventKind, &'static str)> {
    run.events().iter().map(|event| (event.kind, event.supports.first().copied().unwrap_or(""))).collect()
}

/// It rises with y' = 1 under g − f = 1 for 1 to ½, falls with g for √½.
#[test]
fn conditions_made_true_by_an_impact_trigger_at_once() {
    use EventKind::{Arm, Disarm, End, Impact, Start};
    let run = dropped(&[]);
    let up = [(Impact, "P"), (Arm, "side"), (Arm, "force lift")];
    let down = [(Disarm, "force lift"), (Disarm, "side")];
    let expected = [&[(Start, "")][..], &up, &down, &up, &[(End, "")]].concat();
    let sorted = |mut all: Vec<(EventKind, &'static str)>| {
        all.sort_by_key(|(kind, name)| (format!("{kind:?}"), *name));
        all
    };
    assert_eq!(sorted(list_events(&run)), sorted(expected), "{:?}", run.events());
    let at = |k: usize| run.events()[k].t;
    assert!([1, 2, 3].iter().all(|&k| (at(k) - 1.0).abs() < 1e-11), "{:?}", run.events());
    assert!([4, 5].iter().all(|&k| (at(k) - 2.0).abs() < 1e-10), "{:?}", run.events());
    assert!((at(6) - 2.0 - 0.5_f64.sqrt()).abs() < 1e-10, "{:?}", run.events());
    assert!(run.audit().is_clean(), "{:?}", run.audit());
}

#[test]
fn a_run_ends_where_an_impact_makes_its_condition_true() {
    let run = dropped(&["y' > 0.5"]);
    let stop = run.events().last().unwrap();
    assert_eq!(stop.kind, EventKind::Stop, "{:?}", run.events());
    assert!((stop.t - 1.0).abs() < 1e-11 && (stop["y'"] - 1.0).abs() < 1e-10, "{stop}");
    // What an impact passes it does not have: the first y' = 0.5 is on the way up, under g − f.
    let run = dropped(&["y' = 0.5"]);
    assert!((run.events().last().unwrap().t - 1.5).abs() < 1e-10, "{:?}", run.events());
    // What holds before and after is not met.
    let run = dropped(&["y' < 3"]);
    assert_eq!(run.events().last().unwrap().kind, EventKind::End);
}

#[test]
fn a_reaction_that_falls_at_once_ends_a_run() {
    let model = Lifted { m: 1.0, l: 2.0, g: 10.0, f: 3.0 };
    let simulation = Simulation::new(&model).unwrap().start(Pose::new("phi", 0.0).with("x", 0.0)).unwrap();
    let run = simulation.limit(2.0).until("N(A) < 4").unwrap().run().unwrap();
    let stop = run.events().last().unwrap();
    assert_eq!((stop.kind, stop.t), (EventKind::Stop, 1.0), "{:?}", run.events());
}

/// Plastic impacts leave nothing but rounding, which is no rise.
#[test]
fn roundoff_meets_no_condition() {
    let ball = Ball { e: 0.0, ..BALL };
    let start = Pose::new("x", 0.0).with("y", 1.0).with("x'", 0.3);
    let run = Simulation::new(&ball).unwrap().start(start).unwrap().limit(3.0).run().unwrap();
    assert!(list_events(&run).iter().all(|(kind, _)| *kind != EventKind::Arm), "{:?}", run.events());
}
