//! Redundant contacts: how a plank's feet share its weight is not determined, how it moves is.

use liftoff::prelude::*;
use liftoff::{EventKind, Output};
use liftoff_fixtures::{LongPlank, Plank};

fn slide() -> Pose {
    Pose::new("phi", 0.0).with("x", 0.0).with("y", 0.0).with("phi'", 0.0).with("x'", 0.5).with("y'", 0.0)
}

/// It goes on at its speed on all feet, and every foot's share is of least norm: (α + β x)₊.
#[test]
fn a_plank_slides_on_all_feet() {
    for c in [0.0, 0.25, 1.8, 2.0, 3.9, 4.0] {
        let plank = Plank { m: 2.0, i: 1.0, c, d: 1.0, g: 10.0 };
        let run = Simulation::new(&plank).unwrap().start(slide()).unwrap().limit(2.0).run().unwrap();
        assert_eq!(
            run.events().iter().map(|e| e.kind).collect::<Vec<_>>(),
            [EventKind::Start, EventKind::End]
        );
        assert_eq!(run.segments()[0].closed, ["A", "F1", "F2", "F3", "F4"]);
        let state = run.final_state();
        assert!((state[1] - 1.0).abs() < 1e-12 && state[0].abs() < 1e-12 && state[2].abs() < 1e-12);
        let share =
            |foot: &str| run.value(&Output::parse(Plank::LAYOUT, &format!("N({foot})")).unwrap(), 1.0);
        let shares = ["A", "F1", "F2", "F3", "F4"].map(share);
        let moment: f64 = shares.iter().zip(0..).map(|(share, foot)| share * f64::from(foot)).sum();
        assert!((shares.iter().sum::<f64>() - 20.0).abs() < 1e-11 && (moment - 20.0 * c).abs() < 1e-10);
        assert!(shares.iter().all(|share| *share >= 0.0), "{c} {shares:?}");
    }
}

/// With its centre of mass beyond the last foot it tips about that foot.
#[test]
fn a_plank_tips_about_its_last_foot() {
    let plank = Plank { m: 1.0, i: 1.0, c: 4.5, d: 1.0, g: 10.0 };
    let run = Simulation::new(&plank).unwrap().start(slide()).unwrap().limit(0.1).run().unwrap();
    assert_eq!(run.segments()[0].closed, ["F4"]);
}

/// Two hundred feet, in time of the order of milliseconds; dropped, they strike at once and stay.
#[test]
fn a_plank_on_two_hundred_feet() {
    let plank = LongPlank { m: 2.0, i: 1e4, c: 130.3, d: 1.0, g: 10.0 };
    let simulation = || Simulation::new(&plank).unwrap();
    let run = simulation().start(slide()).unwrap().limit(1.0).run().unwrap();
    assert_eq!(run.segments()[0].closed.len(), 200);
    assert!((run.final_state()[1] - 0.5).abs() < 1e-10);
    let dropped = Pose::new("phi", 0.0).with("x", 0.0).with("y", 1.0).with("phi'", 0.0).with("x'", 0.5);
    let run = simulation().start(dropped).unwrap().limit(1.0).run().unwrap();
    let impact = &run.events()[1];
    assert_eq!((impact.kind, impact.supports.len()), (EventKind::Impact, 200));
    assert!((impact.t - 0.2f64.sqrt()).abs() < 1e-10);
    assert_eq!(run.segments()[1].closed.len(), 200);
}
