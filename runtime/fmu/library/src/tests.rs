//! Instances, called as the exports call them.

use crate::experiment::Experiment;
use crate::instance::{Instance, Kind};
use liftoff_fmu::Resources;
use liftoff_studio::source;
use std::fs;
use std::path::PathBuf;

const FIG_1A: &str = include_str!("../../../web/gallery/fig_1a.rs");
const BALL: &str = include_str!("../../tests/models/bouncing_ball.rs");

const EVENTS: Kind = Kind::CoSimulation { event_mode: true, early_return: true };

/// A folder of resources, as unpacked.
struct Unit {
    folder: PathBuf,
    resources: Resources,
}

impl Unit {
    fn unpack(text: &str, name: &str) -> Self {
        let model = source::models(text).expect("a model").remove(0);
        let folder = std::env::temp_dir().join(format!("liftoff-library-{}-{name}", std::process::id()));
        fs::create_dir_all(&folder).expect("a folder");
        let resources = Resources::from_model(&model);
        fs::write(folder.join("model.rs"), &resources.declaration).expect("a file");
        fs::write(folder.join("run.toml"), toml::to_string(&resources.spec).expect("numbers"))
            .expect("a file");
        Self { folder, resources }
    }

    fn instance(&self, kind: Kind) -> Instance {
        let token = self.resources.token().expect("a token");
        Instance::new(kind, &self.folder, &token).expect("an instance")
    }

    fn begun(&self, kind: Kind) -> Instance {
        let mut instance = self.instance(kind);
        instance.enter_initialization(Experiment::default()).expect("a stage");
        instance.exit_initialization().expect("a start");
        instance
    }
}

impl Drop for Unit {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.folder);
    }
}

#[test]
fn steps_end_early_at_the_engines_events() {
    let unit = Unit::unpack(FIG_1A, "early");
    let run =
        unit.resources.model().expect("a model").run(&unit.resources.spec.clone().limit(2.0)).expect("a run");
    let opens = run.events()[1].t;
    let mut instance = unit.begun(EVENTS);
    instance.update().expect("nothing to do");
    instance.enter_step().expect("a stage");
    let step = instance.step(0.0, 2.0).expect("a step");
    assert_eq!((step.event, step.early, step.ended, step.t), (true, true, false, opens));
    assert!(instance.enter_event().is_ok() && instance.update().is_ok() && instance.enter_step().is_ok());
    let step = instance.step(opens, 2.0 - opens).expect("a step");
    assert_eq!((step.event, step.early, step.t), (false, false, 2.0));
}

#[test]
fn descriptions_of_others_are_refused() {
    let unit = Unit::unpack(FIG_1A, "token");
    let refused = Instance::new(EVENTS, &unit.folder, "another").map(drop).expect_err("another token");
    assert!(refused.starts_with("the instantiation token is another"), "{refused}");
    let nowhere =
        Instance::new(EVENTS, &unit.folder.join("nowhere"), "").map(drop).expect_err("no resources");
    assert!(nowhere.starts_with("cannot read the unit's resource"), "{nowhere}");
}

/// Explicit Euler steps, with an event wherever an indicator is no more positive: a ball from 1 m
/// meets the ground at √(2/g), with the velocity √(2 g), to the order of a step, and bounces with e =
/// 0.8 of it.
#[test]
fn an_importer_with_eulers_steps_bounces_a_ball() {
    let unit = Unit::unpack(BALL, "euler");
    let mut instance = unit.begun(Kind::Exchange);
    instance.update().expect("nothing to do");
    instance.enter_continuous().expect("a stage");
    let (mut t, h) = (0.0, 1e-4);
    while instance.event_indicators(1).expect("one")[0] > 0.0 {
        let (x, f) = (instance.states(4).expect("states"), instance.derivatives(4).expect("derivatives"));
        t += h;
        instance.set_time(t).expect("a time");
        instance.set_states(&x.iter().zip(&f).map(|(x, f)| x + h * f).collect::<Vec<_>>()).expect("states");
    }
    assert!((t - (2.0f64 / 9.81).sqrt()).abs() < 2.0 * h, "{t}");
    let before = instance.states(4).expect("states");
    instance.enter_event().expect("a stage");
    let update = instance.update().expect("an impact");
    assert!(update.moved && !update.ended);
    let after = instance.states(4).expect("states");
    assert!((before[3] + (2.0f64 * 9.81).sqrt()).abs() < 2.0 * h * 9.81);
    // Taken back by the part of a step that was too much; to the ground but for a rounding.
    assert!((after[3] + 0.8 * before[3]).abs() < 0.8 * h * 9.81, "{before:?} {after:?}");
    assert!(after[1].abs() <= f64::EPSILON);
}

#[test]
fn each_kind_refuses_the_calls_of_the_other() {
    let unit = Unit::unpack(BALL, "kinds");
    let mut exchange = unit.begun(Kind::Exchange);
    assert!(exchange.enter_step().is_err() && exchange.step(0.0, 1.0).is_err());
    assert!(exchange.states(3).is_err() && exchange.event_indicators(2).is_err());
    let mut motion = unit.begun(EVENTS);
    assert!(
        motion.enter_continuous().is_err() && motion.states(4).is_err() && motion.derivatives(4).is_err()
    );
    assert_eq!((motion.count_of_states(), motion.count_of_indicators()), (4, 1));
}

#[test]
fn a_start_below_the_ground_is_refused() {
    let unit = Unit::unpack(BALL, "fails");
    let mut instance = unit.instance(EVENTS);
    // y is the sixth variable: time, m, g, e, x, y.
    instance.set(&[5], &[-1.0]).expect("a value");
    instance.enter_initialization(Experiment::default()).expect("a stage");
    let error = instance.exit_initialization().expect_err("a penetrated support");
    assert_eq!(error, "support P is penetrated by 1.000e0");
}

/// A crank that is driven by √(1 − t), which is no number from t = 1 on.
const ENDING: &str = r##"
    #[derive(BarSystem)]
    #[bar(OA, mass = m, length = 1)]
    #[pin(O = (0, 0))]
    #[figure(A = (1, 0))]
    #[coordinate(phi = angle(OA))]
    #[drive(phi = sqrt(1 - t))]
    struct Ending {
        #[value(1)]
        m: f64,
    }
"##;

#[test]
fn a_run_that_fails_on_the_way_stays_failed() {
    let unit = Unit::unpack(ENDING, "ending");
    let mut instance = unit.begun(Kind::CoSimulation { event_mode: false, early_return: false });
    instance.step(0.0, 0.5).expect("a motion");
    for _ in 0..2 {
        let error = instance.step(0.5, 1.0).expect_err("no motion");
        let told = "the run of Ending stopped short: at t = 0.99999";
        assert!(error.starts_with(told) && error.contains("`sqrt((1 - t))` is not finite"), "{error}");
    }
}
