//! Records written by hand: right ones agree, wrong ones do not.

use liftoff_core::scalar::Scalar;
use liftoff_judge::{Change, Judge, MotionSegment, Record, RecordedEvent, Task, Verdict};

const MOST_WORK: u64 = Task::WORK;
const G: f64 = 10.0;
const E: f64 = 0.5;

/// A ball over a floor, from the height 5: it strikes after 1 at 10 and rebounds at 5.
fn ball() -> Judge {
    let text = "#[gravity(g)] #[particle(P, mass = m)] #[support(P = floor, restitution = e)] \
        #[figure(P = (0, 1))] #[coordinate(x = x(P))] #[coordinate(y = y(P))] \
        struct Ball { m: f64, g: f64, e: f64 }";
    Judge::new(text, &[2.0, G, E], &["x", "y"]).expect("a scene")
}

fn falling(t: f64) -> (f64, Vec<f64>) {
    (t, vec![t, 5.0 - G * t * t / 2.0, 1.0, -G * t])
}

fn rising(t: f64, u: f64) -> (f64, Vec<f64>) {
    (t, vec![t, u * (t - 1.0) - G * (t - 1.0).powi(2) / 2.0, 1.0, u - G * (t - 1.0)])
}

fn bounced(u: f64) -> Record {
    let free = |samples| MotionSegment { closed: Vec::new(), samples };
    Record {
        t: 0.0,
        start: falling(0.0).1,
        events: vec![RecordedEvent {
            t: 1.0,
            change: Change::Impact,
            contacts: vec!["P".to_owned()],
            state: rising(1.0, u).1,
        }],
        segments: vec![
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
    match ball().verdict(record, MOST_WORK) {
        Verdict::Disagrees { what, .. } => what,
        other => panic!("{other}"),
    }
}

#[test]
fn the_right_motion_agrees() {
    let verdict = ball().verdict(&bounced(5.0), MOST_WORK);
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
    record.segments.truncate(1);
    record.segments[0].samples.push(falling(1.4));
    record.end = 1.4;
    assert!(disagreement(&record).contains("the gap of P"), "{}", disagreement(&record));
    // Not seen in states, if none of those told is under the floor, but in what the judge finds.
    record.segments[0].samples.pop();
    assert!(disagreement(&record).contains("impact of P at t = 1 is missed"), "{}", disagreement(&record));
}

#[test]
fn a_jump_does_not() {
    let mut record = bounced(5.0);
    record.segments[1].samples.iter_mut().for_each(|(_, state)| state[0] += 0.1);
    assert!(disagreement(&record).contains("jumps by"), "{}", disagreement(&record));
}

/// A contact said to be closed that would have to pull.
#[test]
fn a_contact_that_pulls_does_not() {
    let text = "#[gravity(0, g)] #[particle(P, mass = m)] #[support(P = floor)] #[figure(P = (0, 1))] \
        #[coordinate(x = x(P))] #[coordinate(y = y(P))] struct Lifted { m: f64, g: f64 }";
    let judge = Judge::new(text, &[2.0, G], &["x", "y"]).expect("a scene");
    let still = |t: f64| (t, vec![0.0; 4]);
    let samples = [0.0, 0.5, 1.0].map(still).to_vec();
    let record = Record {
        start: vec![0.0; 4],
        segments: vec![MotionSegment { closed: vec!["P".to_owned()], samples }],
        end: 1.0,
        units: vec![1.0; 4],
        time: 0.3,
        within: 1e-9,
        ..Record::default()
    };
    let verdict = judge.verdict(&record, MOST_WORK);
    assert!(matches!(&verdict, Verdict::Disagrees { what, .. } if what.contains("must open")), "{verdict}");
}

/// Beside an equilibrium an error of 1e-12 at the start changes the lift-off after 3e4 s by some 15
/// s.
#[test]
fn a_lateness_that_errors_at_the_start_make_is_none() {
    let text = "#[gravity(g)] #[bar(AD, mass = m, length = l)] #[bar(DB, mass = m, length = l)] \
        #[support(P = corner(-l / 2, 0), under = AD)] #[support(Q = corner(l / 2, 0), under = DB)] \
        #[figure(D = (0, 0), A = (-l, 0), B = (l, 0))] #[coordinate(phi = angle(DB), from = horizontal)] \
        #[coordinate(y = -y(D))] #[mirror(x = 0)] struct Pair { m: f64, l: f64, g: f64 }";
    let judge = Judge::new(text, &[1.0, 1.0, 1.0], &["phi", "y"]).expect("a scene");
    let start = vec![1e-9, 0.5e-9, 0.0, 0.0];
    let motion = judge.follow(&Task::new(&start, 31_354.0));
    let open = &motion.events[0];
    let state: Vec<f64> = open.state.iter().map(|x| x.to_f64()).collect();
    let late = |by: f64| {
        let t = open.t.to_f64() + by;
        let contacts = vec!["P".to_owned(), "Q".to_owned()];
        let event =
            RecordedEvent { t, change: Change::Open, contacts: contacts.clone(), state: state.clone() };
        let record = Record {
            start: start.clone(),
            events: vec![event],
            segments: vec![MotionSegment { closed: contacts, samples: vec![(0.0, start.clone())] }],
            end: t,
            units: vec![1.0; 4],
            time: 1.0,
            tolerance: 1e-12,
            within: 1e-6,
            ..Record::default()
        };
        judge.verdict(&record, MOST_WORK)
    };
    assert!(matches!(late(0.1), Verdict::Agrees { .. }), "{}", late(0.1));
    assert!(matches!(late(1000.0), Verdict::Disagrees { .. }), "{}", late(1000.0));
}

#[test]
fn unsupported_declarations_are_not_judged() {
    assert!(Judge::new("struct Nothing", &[], &[]).is_err());
    let verdict = ball().verdict(&Record::default(), MOST_WORK);
    assert!(matches!(verdict, Verdict::NotJudged { .. }), "{verdict}");
}
