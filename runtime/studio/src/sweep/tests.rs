//! Sweeps of small models against single runs and closed forms.

use super::{Cell, Sample, Sweep, Table};
use crate::registry::{Models, RunOptions};
use crate::run_spec::{DefaultRun, RunSpec, named};
use liftoff::prelude::*;

mod fig_1b;
mod journal;

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

fn models() -> Models {
    crate::models![Ladder, Ball, Pendulum]
}

/// A sweep of a model, given in words: `vary x=0:1:3`.
fn sweep<'a>(models: &'a Models, name: &str, words: &[&str]) -> Result<Sweep<'a>, super::SweepError> {
    let mut sweep = Sweep::of(models.find(name).expect("a model"));
    for text in words {
        let (word, text) = text.split_once(' ').expect("two words");
        sweep = match word {
            "vary" => sweep.vary(text),
            "set" => sweep.set(text),
            "start" => sweep.start(text),
            "observe" => sweep.observe(text),
            word => panic!("{word}"),
        }?;
    }
    Ok(sweep)
}

fn run(name: &str, words: &[&str]) -> Table {
    sweep(&models(), name, words).and_then(|sweep| sweep.run()).expect("a sweep")
}

fn refused(name: &str, words: &[&str]) -> String {
    let models = models();
    let sweep = sweep(&models, name, words).and_then(|sweep| sweep.run());
    sweep.err().expect("a mistake").to_string()
}

fn numbers(table: &Table, observation: usize) -> Vec<f64> {
    table.cells(observation).filter_map(|(_, cell)| cell.number()).collect()
}

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
        let alone = Simulation::new(&ladder).unwrap().start(Pose::at("phi", 1.5 * s)).unwrap();
        let alone = alone.until("phi = 0").unwrap().run().unwrap();
        let open = alone.events().iter().find(|event| event.kind == EventKind::Open).unwrap();
        let energy = Output::parse(Ladder::LAYOUT, "E").unwrap();
        let expected = [open.state[0], open.t, alone.value(&energy, alone.end_time())].map(Cell::Number);
        assert_eq!(row.outcome.as_deref(), Ok(&expected[..]));
    }
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

/// A member that may end with its first event has the same values there as one that runs to its end.
#[test]
fn what_ends_early_is_seen_alike() {
    let early = ["vary e=0:0.9:4", "observe first impact y'", "observe first impact"];
    let late = [early[0], early[1], early[2], "observe end"];
    let (early, late) = (run("ball", &early), run("ball", &late));
    assert_eq!(numbers(&early, 0), numbers(&late, 0));
    // From h = 1 with g = 2 at the speed 2, back with e times it; the value is that after the impact.
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
}

#[test]
fn what_does_not_happen_is_missing() {
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

/// At e > 1 there is no impact law; at h = 0 the ball lies still.
#[test]
fn members_that_fail_are_kept() {
    let table = run("ball", &["vary h=0,1", "vary e=0.5,1.5", "observe count impact"]);
    assert!(table.is_whole());
    let failed: Vec<_> = table.failed().map(|(row, _)| row.member).collect();
    assert_eq!(failed, [0, 1, 3]);
    let csv = table.csv();
    assert!(csv.lines().nth(2).is_some_and(|line| line.starts_with("1,0,1.5,,") && line.len() > 10), "{csv}");
    let summary = table.summary();
    assert!(summary.contains("4 members of ball: 4 computed, 3 failed"), "{summary}");
    assert!(summary.contains("3  h = 1, e = 1.5: "), "{summary}");
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

#[test]
fn mistakes_are_told_before_anything_runs() {
    let observe = "observe end";
    let cases: [(&[&str], &str); 21] = [
        (&["vary q=0:1:3", observe], "nothing depends on what is varied: no parameter or coordinate `q`"),
        (&["vary hh=0:1:3", observe], "did you mean `h`?"),
        (&["vary q=0:1:3", "set hh=q", observe], "no parameter `hh`; did you mean `h`?"),
        (&["vary q=0:1:3", "set h=p", observe], "`h=p`: no name `p`"),
        (&["vary q=0:1:3", "start yy=q", observe], "no coordinate `yy`; did you mean `y`?"),
        (&["vary h=0:1:3", "vary h=0:2:3", observe], "`h` is varied twice"),
        (&[observe], "nothing is varied"),
        (&["vary h=0:1:3"], "nothing is observed"),
        (&["vary h=0:1:3", "observe frist open"], "no observation `frist`; did you mean `first`?"),
        (&["vary h=0:1:3", "observe first opne"], "no event `opne`; did you mean `open`?"),
        (&["vary h=0:1:3", "observe end yy"], "`end yy`: no name `yy`; did you mean `y`?"),
        (&["vary h=0:1:3", "observe first impact Q"], "no name `Q`"),
        (&["vary h=0:1", observe], "`h` has no count"),
        (&["vary h=0:1:3", "set m=1", "set m=2", observe], "--set: `m` is given twice"),
        (&["vary h=0:1:3", "start x=1", "start x=2", observe], "--start: `x` is given twice"),
        (&["vary h=0:1:3", "set h=1", observe], "nothing depends on what is varied"),
        (&["vary h=0kg:1kg:3", observe], "--set h: measured in m, not in kg"),
        (&["vary h=0:1:3", "set g=9.81 m/s", observe], "--set g: measured in m/s², not in m/s"),
        (&["vary h=0:1:3", "start y'=3deg", observe], "--start y': measured in m/s, not in rad"),
        (&["vary h=1:2:3000", "vary e=0:1:3000", observe], "a grid of 9000000 points: 4000000 are the most"),
        (&["vary h=0:1:3", "observe end y = 2"], "for thresholds"),
    ];
    for (words, expected) in cases {
        let error = refused("ball", words);
        assert!(error.contains(expected) && !error.contains('\n'), "{words:?}: {error}");
    }
}

/// Words of sweeps in any order, and any characters: understood or refused in a line, at once.
#[test]
fn whatever_is_written_is_understood_or_refused() {
    const WORDS: [&str; 40] = [
        "h",
        "e",
        "x",
        "y'",
        "q",
        "=",
        ":",
        ",",
        "0",
        "1",
        "2",
        "1e308",
        "-",
        "4000001",
        "18446744073709551615",
        "log",
        "1e-320",
        "pi",
        "mm",
        "deg",
        "kg",
        " ",
        "first",
        "last",
        "count",
        "end",
        "max",
        "impact",
        "open",
        "P",
        " of ",
        "t",
        "(",
        ")",
        "N(P)",
        "/0",
        "\n",
        "\0",
        "é",
        "'",
    ];
    let models = models();
    let ball = models.find("ball").expect("a model");
    let mut state = 11u64;
    let mut draw = |below: usize| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as usize % below
    };
    let mut planned = 0;
    for round in 0..20_000 {
        let mut text = |from: &[&str]| {
            let more: String = (0..draw(9)).map(|_| WORDS[draw(WORDS.len())]).collect();
            from[draw(from.len())].to_owned() + &more
        };
        let all = [
            text(&["h=", "h=1:2:3", "e=0", "q", ""]),
            text(&["m=", "h=q", ""]),
            text(&["end ", "first impact", ""]),
        ];
        let made = Sweep::of(ball).vary(&all[0]).and_then(|sweep| sweep.observe(&all[2]));
        let made = if round % 2 == 0 { made } else { made.and_then(|sweep| sweep.set(&all[1])) };
        let made = made.and_then(|sweep| {
            super::plan::Plan::of(&sweep)?;
            Sample::Grid.points(&sweep.varied).map(|points| points.at(points.len() - 1))
        });
        match made {
            Ok(point) => planned += point.len(),
            Err(error) => assert!(!error.to_string().is_empty(), "{all:?}"),
        }
    }
    assert!(planned > 50, "{planned}");
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
