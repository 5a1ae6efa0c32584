//! Closed forms of derived models where their pivots become small.

use liftoff::prelude::*;

/// Fig. 1a with a gap of width w much narrower than the bars, so that they turn nearly upright on
/// the corners: y = (w/2) tan φ has the pivot cos φ.
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[bar(AD, mass = m, length = l)]
#[bar(DB, mass = m, length = l)]
#[support(P = corner(-w / 2, 0), under = AD)]
#[support(Q = corner(w / 2, 0), under = DB)]
#[figure(D = (0, 0), A = (-l, 0), B = (l, 0))]
#[coordinate(phi = angle(DB), from = horizontal)]
#[coordinate(y = -y(D))]
#[mirror(x = 0)]
struct NarrowGap {
    m: f64,
    l: f64,
    w: f64,
    g: f64,
}

/// The same without symmetry: x and y are eliminated with a pivot that vanishes with φ.
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[bar(AD, mass = m, length = l)]
#[bar(DB, mass = m, length = l)]
#[support(P = corner(-l / 2, 0), under = AD)]
#[support(Q = corner(l / 2, 0), under = DB)]
#[figure(D = (0, 0), A = (-l, 0), B = (l, 0))]
#[coordinate(left = -angle(AD), from = right)]
#[coordinate(right = angle(DB), from = right)]
#[coordinate(x = x(D))]
#[coordinate(y = -y(D))]
struct WholePair {
    m: f64,
    l: f64,
    g: f64,
}

#[test]
fn a_small_pivot_goes_over_to_multipliers_in_mid_run() {
    let model = NarrowGap { m: 1.0, l: 1.0, w: 0.02, g: 1.0 };
    let run = |form| {
        let start = Pose::new("phi", 0.5).with("phi'", 3.0);
        let simulation = Simulation::new(&model).unwrap().form(form).start(start).unwrap();
        simulation.hold("P").unwrap().limit(1.0).run().unwrap()
    };
    let (run, reference) = (run(Form::Reduced), run(Form::Multipliers));
    let forms: Vec<_> = run.segments().iter().map(|segment| segment.form).collect();
    assert_eq!(forms[..2], [Form::Reduced, Form::Multipliers]);
    assert_eq!(run.log().len(), 1);
    // The corner is at the bars' ends where cos φ = w / 2l.
    let [last, expected] = [&run, &reference].map(|run| &run.events()[1]);
    assert_eq!(last.kind, EventKind::SlideOff);
    assert!((last.state[0].cos() - 0.01).abs() < 1e-12, "{last}");
    assert!((last.t - expected.t).abs() < 1e-10, "{last} {expected}");
    let energy = Output::parse(NarrowGap::LAYOUT, "E").unwrap();
    assert!((run.value(&energy, run.end_time()) - run.value(&energy, 0.0)).abs() < 1e-10);
}

/// From φ = 0.1 the pivot sin 2φ is small at once; in either form the motion is the mirrored one.
#[test]
fn a_pivot_may_be_small_from_the_start() {
    let model = WholePair { m: 1.0, l: 1.0, g: 1.0 };
    let pose = Pose::new("left", 0.1).with("right", 0.1);
    let run =
        Simulation::new(&model).unwrap().start(pose).unwrap().until("left = pi/2").unwrap().run().unwrap();
    let open = &run.events()[1];
    assert_eq!((open.kind, &open.supports[..]), (EventKind::Open, &["P", "Q"][..]));
    assert!((open.state[0] - 0.815453099591302).abs() < 1e-11, "{open}");
    assert!((open.t - 2.5976375675578).abs() < 1e-10, "{open}");
    assert!((open.state[0] - open.state[1]).abs() < 1e-12, "{open}");
}

/// At φ = 0 the elimination is singular and the pair in equilibrium.
#[test]
fn a_vanishing_pivot_is_no_singularity_of_the_motion() {
    let run = Simulation::new(&WholePair { m: 1.0, l: 1.0, g: 1.0 }).unwrap().run();
    assert_eq!(*run.unwrap_err().cause(), liftoff::RunCause::Start(liftoff::StartError::Equilibrium));
    let sliding = Simulation::new(&WholePair { m: 1.0, l: 1.0, g: 1.0 }).unwrap();
    let run = sliding.start(Pose::new("x'", 0.1)).unwrap().limit(0.5).run().unwrap();
    assert_eq!(run.segments()[0].form, Form::Multipliers);
    let value = |text: &str, t: f64| run.value(&Output::parse(WholePair::LAYOUT, text).unwrap(), t);
    assert!((value("E", 0.5) - value("E", 0.0)).abs() < 1e-12);
    assert!(value("gap(P)", 0.5).abs() + value("gap(Q)", 0.5).abs() < 1e-15);
    assert!(value("left", 0.5) != 0.0);
}
