//! What an observer sees against the motion that is kept.

use liftoff::prelude::*;
use liftoff::{Observer, Step};
use liftoff_fixtures::{BouncingBar, PairOnCorners, Particle};

/// Outputs at the middle of each step and at each event, as they are told.
struct Looks {
    outputs: Vec<Output>,
    awaited: Vec<f64>,
    seen: Vec<(f64, Vec<f64>)>,
}

impl Observer for Looks {
    fn event(&mut self, t: f64) {
        self.awaited.push(t);
    }

    fn step(&mut self, step: &dyn Step) {
        let [t0, t1] = step.times();
        let middle = 0.5 * (t0 + t1);
        let (now, later): (Vec<f64>, Vec<f64>) = self.awaited.iter().copied().partition(|t| *t < t1);
        assert!(now.iter().all(|t| *t >= t0), "{now:?} before {t0}");
        self.awaited = later;
        for t in now.into_iter().chain((t1 > t0).then_some(middle)) {
            self.seen.push((t, step.values(&self.outputs, t)));
        }
    }
}

fn agree(simulation: &Simulation, outputs: &[&str]) {
    let parsed = || outputs.iter().map(|text| Output::parse(simulation.layout(), text).unwrap());
    let mut looks = Looks { outputs: parsed().collect(), awaited: Vec::new(), seen: Vec::new() };
    let observed = simulation.observe(&mut looks).unwrap();
    let kept = simulation.run().unwrap();
    for (t, values) in &looks.seen {
        let expected: Vec<f64> = parsed().map(|output| kept.value(&output, *t)).collect();
        assert_eq!(*values, expected, "t = {t}");
    }
    let end = kept.end_time();
    assert!(looks.awaited.iter().all(|t| *t == end), "{:?}", looks.awaited);
    for output in parsed() {
        assert_eq!(observed.value(&output, end), kept.value(&output, end), "{output}");
        assert!(observed.value(&output, 0.5 * end).is_nan());
    }
    // All events but those of the end have been seen, with the motion after them.
    let told = |t: f64| looks.seen.iter().any(|(seen, _)| *seen == t) || t == end;
    assert!(kept.events().iter().all(|event| told(event.t)));
    assert!(looks.seen.len() > kept.events().len());
}

#[test]
fn an_observer_sees_what_is_kept() {
    let ball = Simulation::new(&Particle { m: 1.0, g: 1.0, e: 0.5 }).unwrap().limit(8.0);
    agree(&ball, &["y", "y'", "N(P)", "E"]);
    let pair = Simulation::new(&PairOnCorners { m: 1.0, l: 1.0, g: 9.81 }).unwrap();
    let pair = pair.start(Pose::new("phi", 0.1)).unwrap().until("phi = pi/2").unwrap();
    agree(&pair, &["phi", "N(P)", "gap(P)"]);
    agree(&pair.form(Form::Multipliers), &["phi", "N(P)", "gap(P)"]);
    let bar = Simulation::new(&BouncingBar { m: 1.0, l: 1.0, g: 9.81, e: 0.5 }).unwrap();
    agree(&bar.start(Pose::new("y", 0.5).with("phi", 0.4)).unwrap().limit(1.0), &["phi", "x(B)", "N(A)"]);
}

/// What of a run an observer was told, and whether it takes it.
#[derive(Default)]
struct Told {
    events: Vec<(EventKind, f64)>,
    takes: bool,
}

impl Observer for Told {
    fn step(&mut self, _: &dyn Step) {}

    fn happened(&mut self, event: &Event) -> bool {
        self.events.push((event.kind, event.t));
        self.takes
    }
}

/// The n-th impact of a ball that falls from 1 m and loses nothing is at (2n − 1) √(2/g); the time
/// of the clock has rounding enough by then that a step which ends at it would end below the
/// ground.
#[test]
fn a_ball_bounces_on_when_the_time_is_long() {
    let ball = Particle { m: 1.0, g: 9.81, e: 1.0 };
    for tolerance in [1e-9, 1e-14] {
        let simulation = Simulation::new(&ball).unwrap().tolerance(tolerance).limit(11_000.0);
        let simulation = simulation.start(Pose::new("y", 1.0)).unwrap();
        let mut told = Told { takes: true, ..Told::default() };
        let run = simulation.observe(&mut told).unwrap();
        let impacts: Vec<f64> =
            told.events.iter().filter(|(kind, _)| *kind == EventKind::Impact).map(|(_, t)| *t).collect();
        let fall = (2.0_f64 / 9.81).sqrt();
        assert_eq!(impacts.len(), ((11_000.0 / fall + 1.0) / 2.0) as usize);
        for (n, t) in impacts.iter().enumerate() {
            let expected = (2 * n + 1) as f64 * fall;
            assert!((t - expected).abs() < 1e-12 * expected, "{n}: {t} {expected}");
        }
        let kept: Vec<EventKind> = run.events().iter().map(|event| event.kind).collect();
        assert_eq!(kept, [EventKind::Start, EventKind::End]);
    }
}

/// What the observer is shown is what is kept, in this order, whether it takes it or not; what the
/// run waits for stays.
#[test]
fn an_observer_is_shown_each_event_once() {
    let ball = Particle { m: 1.0, g: 1.0, e: 0.5 };
    let simulation = Simulation::new(&ball).unwrap().limit(8.0);
    let kept: Vec<(EventKind, f64)> =
        simulation.run().unwrap().events().iter().map(|event| (event.kind, event.t)).collect();
    for takes in [false, true] {
        let mut told = Told { takes, ..Told::default() };
        let run = simulation.observe(&mut told).unwrap();
        assert_eq!(told.events, kept);
        assert_eq!(run.events().len(), if takes { 2 } else { kept.len() });
    }
    let awaits = simulation.until_event(EventKind::Impact, "P").unwrap();
    let run = awaits.observe(&mut Told { takes: true, ..Told::default() }).unwrap();
    assert_eq!(run.events().last().map(|event| event.kind), Some(EventKind::Impact));
}
