//! What is read of the members, against single runs and closed forms.

use super::super::Cell;
use super::{Ladder, numbers, run};
use liftoff::prelude::*;

#[test]
fn members_are_what_single_runs_are() {
    let table = run(
        "ladder",
        &[
            "vary s=0.3:0.9:7",
            "start phi=1.5*s",
            "set m=1+s",
            "observe first open phi",
            "observe t of first open B",
            "observe end E",
        ],
    );
    assert!(table.is_whole() && table.rows.len() == 7);
    for row in &table.rows {
        let s = row.point[0];
        let ladder = Ladder { m: 1.0 + s, l: 2.0, g: 9.81 };
        let alone = Simulation::new(&ladder).unwrap().start(Pose::new("phi", 1.5 * s)).unwrap();
        let alone = alone.until("phi = 0").unwrap().run().unwrap();
        let open = alone.events().iter().find(|event| event.kind == EventKind::Open).unwrap();
        let energy = Output::parse(Ladder::LAYOUT, "E").unwrap();
        let expected = [open.state[0], open.t, alone.value(&energy, alone.end_time())].map(Cell::Number);
        assert_eq!(row.outcome.as_deref(), Ok(&expected[..]));
    }
}

/// A member that may end with its first event has the same values there as one that runs to its
/// end.
#[test]
fn what_ends_early_is_seen_alike() {
    let early = ["vary e=0:0.9:4", "observe first impact y'", "observe first impact"];
    let late = [early[0], early[1], early[2], "observe end"];
    let (early, late) = (run("ball", &early), run("ball", &late));
    assert_eq!(numbers(&early, 0), numbers(&late, 0));
    // From h = 1 with g = 2 at the speed 2, back with e times it; the value is that after the
    // impact.
    for (row, cell) in early.cells(0) {
        assert!((cell.number().unwrap() - 2.0 * row.point[0]).abs() < 1e-12, "{row:?}");
    }
    assert!(early.cells(1).all(|(_, cell)| *cell == Cell::Name("P".into())));
}

/// Falls of 1 s, then flights of 2e, 2e², … s, for 4 s in all.
#[test]
fn observations_count_look_back_and_find_extremes() {
    let words = [
        "vary e=0.5,0.9",
        "observe count impact",
        "observe t of last impact P",
        "observe max y'",
        "observe min y",
        "observe end",
        "observe t of 2nd impact",
        "observe 3rd impact y'",
    ];
    let table = run("ball", &words);
    let close = |found: &[f64], expected: [f64; 2]| {
        assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-9), "{found:?} for {expected:?}");
    };
    // e = 0.9: 1, 2.8, and 4.42 is too late. e = 0.5: they come to their end at 3.
    assert_eq!(numbers(&table, 0)[1], 2.0);
    close(&numbers(&table, 1)[1..], [2.8, 0.0]);
    // The first rebound is the fastest upward, and the floor the lowest point.
    close(&numbers(&table, 2), [1.0, 1.8]);
    close(&numbers(&table, 3), [0.0, 0.0]);
    assert!(table.cells(4).all(|(_, cell)| *cell == Cell::Name("end".into())));
    // After the third impact 2 e³; with e = 0.9 there is none in time.
    close(&numbers(&table, 5), [2.0, 2.8]);
    assert!((table.rows[0].outcome.as_ref().unwrap()[6].number().unwrap() - 0.25).abs() < 1e-9);
    assert_eq!(table.rows[1].outcome.as_ref().unwrap()[6], Cell::Missing);
}

#[test]
fn absent_events_are_missing_values() {
    let table = run("pendulum", &["vary phi=0.1:1:3", "observe first open", "observe first open phi"]);
    let cells: Vec<_> = table.rows.iter().map(|row| row.outcome.clone().unwrap()).collect();
    assert!(cells.iter().all(|cells| *cells == [Cell::Name("none".into()), Cell::Missing]));
    assert!(table.csv().contains("\n2,1,none,,\n"), "{}", table.csv());
}

/// In lanes as by themselves: the energy is that of the start.
#[test]
fn smooth_members_are_read_at_their_ends() {
    let table = run("pendulum", &["vary phi=0.1:1:50", "observe end E", "observe end t"]);
    for (row, cell) in table.cells(0) {
        // V = − m g l/2 cos φ.
        let expected = -9.81 / 2.0 * row.point[0].cos();
        assert!((cell.number().unwrap() - expected).abs() < 1e-10, "{row:?}");
    }
    assert!(numbers(&table, 1).iter().all(|t| *t == 1.0));
}

/// What is varied may stand in conditions and times: the wall is taken away at 0.1 s, the run ends
/// at an angle.
#[test]
fn conditions_and_times_use_varied_names() {
    let words = ["vary s=0.5,0.25", "until phi = 2*s", "observe end phi"];
    assert!(numbers(&run("ladder", &words), 0).iter().zip([1.0, 0.5]).all(|(a, b)| (a - b).abs() < 1e-12));
    let words = ["vary s=0.5,0.25", "release B=s/5", "observe t of first release B"];
    assert!(numbers(&run("ladder", &words), 0).iter().zip([0.1, 0.05]).all(|(a, b)| (a - b).abs() < 1e-15));
}
