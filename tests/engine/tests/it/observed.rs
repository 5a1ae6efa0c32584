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
    let pair = pair.start(Pose::at("phi", 0.1)).unwrap().until("phi = pi/2").unwrap();
    agree(&pair, &["phi", "N(P)", "gap(P)"]);
    agree(&pair.form(Form::Projected), &["phi", "N(P)", "gap(P)"]);
    let bar = Simulation::new(&BouncingBar { m: 1.0, l: 1.0, g: 9.81, e: 0.5 }).unwrap();
    agree(&bar.start(Pose::at("y", 0.5).with("phi", 0.4)).unwrap().limit(1.0), &["phi", "x(B)", "N(A)"]);
}
