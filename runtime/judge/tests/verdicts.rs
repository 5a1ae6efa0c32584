//! Records written by hand: right ones agree, wrong ones do not.

use std::time::Duration;

use liftoff_judge::{Change, Happening, Judge, Record, Stretch, Verdict};

const PATIENCE: Duration = Duration::from_secs(60);
const G: f64 = 10.0;
const E: f64 = 0.5;

/// A ball over a floor, from the height 5: it strikes after 1 at 10 and rebounds at 5.
fn ball() -> Judge {
    let text = "#[gravity(g)] #[particle(P, mass = m)] #[support(P = floor, restitution = e)] \
        #[figure(P = (0, 1))] #[coordinate(x = x(P))] #[coordinate(y = y(P))] \
        struct Ball { m: f64, g: f64, e: f64 }";
    Judge::of(text, &[2.0, G, E], &["x", "y"]).expect("a scene")
}

fn falling(t: f64) -> (f64, Vec<f64>) {
    (t, vec![t, 5.0 - G * t * t / 2.0, 1.0, -G * t])
}

fn rising(t: f64, u: f64) -> (f64, Vec<f64>) {
    (t, vec![t, u * (t - 1.0) - G * (t - 1.0).powi(2) / 2.0, 1.0, u - G * (t - 1.0)])
}

fn bounced(u: f64) -> Record {
    let free = |samples| Stretch { closed: Vec::new(), samples };
    Record {
        t: 0.0,
        start: falling(0.0).1,
        events: vec![Happening {
            t: 1.0,
            change: Change::Impact,
            contacts: vec!["P".to_owned()],
            state: rising(1.0, u).1,
        }],
        stretches: vec![
            free([0.0, 0.3, 0.6, 1.0].map(falling).to_vec()),
            free([1.0, 1.2, 1.4].map(|t| rising(t, u)).to_vec()),
        ],
        end: 1.4,
        units: vec![5.0, 5.0, 7.0, 7.0],
        time: 0.7,
        within: 1e-9,
        ..Record::default()
    }
}

fn disagreement(record: &Record) -> String {
    match ball().verdict(record, PATIENCE) {
        Verdict::Disagrees { what, .. } => what,
        other => panic!("{other}"),
    }
}

#[test]
fn the_right_motion_agrees() {
    let verdict = ball().verdict(&bounced(5.0), PATIENCE);
    assert!(matches!(verdict, Verdict::Agrees { error } if error < 1e-14), "{verdict}");
}

/// More speed than restitution gives back, and more than there was.
#[test]
fn a_wrong_impact_does_not() {
    assert!(disagreement(&bounced(5.1)).contains("impact of P"), "{}", disagreement(&bounced(5.1)));
    assert!(disagreement(&bounced(10.1)).contains("energy is gained"), "{}", disagreement(&bounced(10.1)));
}

#[test]
fn a_missed_contact_does_not() {
    let mut record = bounced(5.0);
    record.events.clear();
    record.stretches.truncate(1);
    record.stretches[0].samples.push(falling(1.4));
    record.end = 1.4;
    assert!(disagreement(&record).contains("the gap of P"), "{}", disagreement(&record));
    // Not seen in states, if none of those told is under the floor, but in what the judge finds.
    record.stretches[0].samples.pop();
    assert!(disagreement(&record).contains("impact of P at t = 1 is missed"), "{}", disagreement(&record));
}

#[test]
fn a_jump_does_not() {
    let mut record = bounced(5.0);
    record.stretches[1].samples.iter_mut().for_each(|(_, state)| state[0] += 0.1);
    assert!(disagreement(&record).contains("jumps by"), "{}", disagreement(&record));
}

/// A contact said to be closed that would have to pull.
#[test]
fn a_contact_that_pulls_does_not() {
    let text = "#[gravity(0, g)] #[particle(P, mass = m)] #[support(P = floor)] #[figure(P = (0, 1))] \
        #[coordinate(x = x(P))] #[coordinate(y = y(P))] struct Lifted { m: f64, g: f64 }";
    let judge = Judge::of(text, &[2.0, G], &["x", "y"]).expect("a scene");
    let still = |t: f64| (t, vec![0.0; 4]);
    let samples = [0.0, 0.5, 1.0].map(still).to_vec();
    let record = Record {
        start: vec![0.0; 4],
        stretches: vec![Stretch { closed: vec!["P".to_owned()], samples }],
        end: 1.0,
        units: vec![1.0; 4],
        time: 0.3,
        within: 1e-9,
        ..Record::default()
    };
    let verdict = judge.verdict(&record, PATIENCE);
    assert!(matches!(&verdict, Verdict::Disagrees { what, .. } if what.contains("must open")), "{verdict}");
}

#[test]
fn what_is_not_understood_is_not_judged() {
    assert!(Judge::of("struct Nothing", &[], &[]).is_err());
    let verdict = ball().verdict(&Record::default(), PATIENCE);
    assert!(matches!(verdict, Verdict::NotJudged { .. }), "{verdict}");
}
