//! Sweeps of small models against single runs and closed forms.

use super::{Sample, Sweep, Table};
use crate::registry::{Models, RunOptions};
use crate::run_spec::{DefaultRun, RunSpec, named};
use liftoff::prelude::*;

mod fig_1b;
mod journal;
mod mistakes;
mod observations;
mod team;

/// A ladder between a smooth floor and a smooth wall.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[support(A = floor)]
#[support(B = wall(0), facing = right)]
#[figure(A = (3 * l / 5, 0), B = (0, 4 * l / 5))]
#[coordinate(phi = angle(AB), from = horizontal)]
struct Ladder {
    m: f64,
    l: f64,
    g: f64,
}

impl DefaultRun for Ladder {
    fn default_run() -> RunSpec {
        RunSpec::with(&[("m", 1.0), ("l", 2.0), ("g", 9.81)]).start(&[("phi", 1.2)]).until("phi = 0")
    }
}

/// A bouncing particle.
#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[support(P = floor, restitution = e)]
#[figure(P = (0, h))]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
struct Ball {
    m: f64,
    h: f64,
    e: f64,
    g: f64,
}

impl DefaultRun for Ball {
    fn default_run() -> RunSpec {
        RunSpec { limit: Some(4.0), ..RunSpec::with(&[("m", 1.0), ("h", 1.0), ("e", 0.5), ("g", 2.0)]) }
    }
}

/// A pendulum: smooth, so that its members run in lanes.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(OA, mass = m, length = l)]
#[pin(O = (0, 0))]
#[figure(A = (0, -l))]
#[coordinate(phi = angle(OA), from = down)]
struct Pendulum {
    m: f64,
    l: f64,
    g: f64,
}

impl DefaultRun for Pendulum {
    fn default_run() -> RunSpec {
        RunSpec { limit: Some(1.0), ..RunSpec::with(&[("m", 1.0), ("l", 1.0), ("g", 9.81)]) }
    }
}

pub(super) fn models() -> Models {
    crate::models![Ladder, Ball, Pendulum]
}

/// A sweep of a model, given in words: `vary x=0:1:3`.
pub(super) fn sweep<'a>(
    models: &'a Models,
    name: &str,
    words: &[&str],
) -> Result<Sweep<'a>, super::SweepError> {
    let mut sweep = Sweep::new(models.find(name).expect("a model"));
    for text in words {
        let (word, text) = text.split_once(' ').expect("two words");
        sweep = match word {
            "vary" => sweep.vary(text),
            "set" => sweep.set(text),
            "start" => sweep.start(text),
            "release" => sweep.release(text),
            "until" => {
                sweep.spec.until = vec![text.to_owned()];
                Ok(sweep)
            }
            "observe" => sweep.observe(text),
            word => panic!("{word}"),
        }?;
    }
    Ok(sweep)
}

fn run(name: &str, words: &[&str]) -> Table {
    sweep(&models(), name, words).and_then(|sweep| sweep.run()).expect("a sweep")
}

fn numbers(table: &Table, observation: usize) -> Vec<f64> {
    table.cells(observation).filter_map(|(_, cell)| cell.number()).collect()
}

/// Bit for bit, whether the motion is kept or not.
#[test]
fn events_alone_are_those_of_the_motion() {
    for model in models().iter() {
        // The pendulum would hang at rest.
        let start: &[_] = if model.name() == "pendulum" { &[("phi", 1.0)] } else { &[] };
        let spec = RunSpec { start: named(start), ..model.default_run() };
        let whole = model.run(&spec).expect("a run");
        let events = model.observe_by(RunOptions::default(), &spec, &mut ()).expect("a run");
        assert_eq!(format!("{:?}", events.events()), format!("{:?}", whole.events()));
        assert_eq!(events.final_state(), whole.final_state(), "{}", model.name());
        assert!(events.segments().is_empty() && !whole.segments().is_empty(), "{}", model.name());
    }
}

#[test]
fn any_number_of_threads_gives_the_same() {
    let models = models();
    let words =
        ["vary e=0:0.99", "vary h=0.5:2", "observe count impact", "observe max y'", "observe last impact t"];
    let csv = |threads| {
        let sweep = sweep(&models, "ball", &words).unwrap().sample(Sample::Random { count: 60, seed: 5 });
        sweep.threads(threads).run().unwrap().csv()
    };
    assert_eq!(csv(1), csv(3));
}

/// The ball is back on the floor at 1 + 2e s: whether it is by then tells e = ½ from 2 s on.
#[test]
fn thresholds_of_categories_and_numbers_are_narrowed_down() {
    let models = models();
    let by = |words: &[&str]| sweep(&models, "ball", words).unwrap().thresholds(1e-10).unwrap();
    let found = by(&["vary h=0.1:10", "observe first impact"]);
    // The fall from h takes √h s, of 4 s: the impact at the very end of the run counts.
    let found_none = found.is_empty();
    assert!(found_none, "{found:?}");
    let found = by(&["vary h=1:100:log", "observe first impact"]);
    let [change] = &found[..] else { panic!("{found:?}") };
    assert_eq!((change.before.as_str(), change.after.as_str()), ("P", "none"));
    assert!(change.above - change.below <= 1e-10 && (change.above - 16.0).abs() < 1e-9, "{change:?}");
    // The speed of the rebound, 2 e √h, is 1 at h = 1 for e = ½.
    let [change] = &by(&["vary h=0.5:3", "observe first impact y' = 1"])[..] else { panic!("one change") };
    assert_eq!((change.before.as_str(), change.after.as_str()), ("< 1", "> 1"));
    assert!((change.below - 1.0).abs() < 1e-10 && (change.above - 1.0).abs() < 1e-10, "{change:?}");
}

#[test]
fn drawings_have_curves_bands_and_maps() {
    let one =
        run("ball", &["vary h=1:40:30", "observe first impact", "observe first impact t", "observe end"]);
    let svg = one.svg().unwrap();
    assert!(svg.contains("first impact t") && svg.contains(">none<") && svg.contains(">P<"), "{svg}");
    let two = run("ball", &["vary h=1:40:9", "vary e=0.1:0.9:5", "observe count impact"]);
    assert!(two.svg().unwrap().contains("count impact"));
    let three = run("ball", &["vary h=1,2", "vary e=0.1,0.2", "vary g=1,2", "observe end"]);
    let error = three.svg().expect_err("three names").to_string();
    assert!(error.contains("one varied name or two, not 3"), "{error}");
}
