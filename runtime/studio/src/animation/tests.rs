//! The page's motion against the record it was made from.

use super::About;
use super::geometry::Geometry;
use super::motion::{Motion, Phase};
use super::rounding::CLOSENESS;
use super::sampling::cubic;
use crate::registry::Models;
use crate::run_spec::RunSpec;
use liftoff::BarSystem;
use liftoff::Trajectory;

/// A bar dropped on a floor.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[support(A = floor, restitution = e)]
#[support(B = floor, restitution = e)]
#[figure(A = (-l / 2, l), B = (l / 2, l))]
#[coordinate(phi = angle(AB), from = horizontal)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
struct Dropped {
    m: f64,
    l: f64,
    e: f64,
    g: f64,
}

/// A double pendulum.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(OA, mass = m, length = l)]
#[bar(AB, mass = m, length = l)]
#[pin(O = (0, 0))]
#[figure(A = (0, -l), B = (0, -2 * l))]
#[coordinate(phi = angle(OA), from = down)]
#[coordinate(psi = angle(AB), from = down)]
struct Swinging {
    m: f64,
    l: f64,
    g: f64,
}

/// A frame on a rough floor.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AC, mass = m, length = l)]
#[bar(CB, mass = m, length = l)]
#[support(A = floor, rough)]
#[support(B = floor, rough)]
#[spring(AB, stiffness = k, length = l)]
#[figure(A = (-3 * l / 5, 0), B = (3 * l / 5, 0), C = (0, 4 * l / 5))]
#[coordinate(phi = angle(AC), from = horizontal)]
#[coordinate(y = y(C))]
#[mirror(x = 0)]
struct Frame {
    m: f64,
    l: f64,
    k: f64,
    g: f64,
}

fn models() -> Models {
    crate::models![Dropped, Swinging, Frame]
}

fn dropped() -> Trajectory {
    let spec = RunSpec::with(&[("m", 1.0), ("l", 1.0), ("e", 0.6), ("g", 9.81)]);
    let spec = spec.start(&[("phi", 0.5), ("y", 1.0), ("phi'", 1.0)]).until("t = 2");
    models().find("dropped").unwrap().run(&spec).unwrap()
}

fn swinging() -> Trajectory {
    let spec = RunSpec::with(&[("m", 1.0), ("l", 1.0), ("g", 9.81)]);
    let spec = spec.start(&[("phi", 2.0), ("psi", 1.0)]).until("t = 10");
    models().find("swinging").unwrap().run(&spec).unwrap()
}

/// What the page shows of a quantity in an interval of a phase.
fn shown(motion: &Motion, phase: &Phase, quantity: usize, interval: usize, theta: f64) -> f64 {
    let values = &phase.values[quantity];
    let at = |i: usize| values[if values.len() == 1 { 0 } else { i }];
    let nodes = [0, 1, 2, 3].map(|i| at(3 * interval + i).map_or(f64::NAN, |whole| whole as f64));
    cubic(nodes, theta) * motion.steps[quantity]
}

/// From the lowest to the highest value of a function over a run.
fn spread(record: &Trajectory, function: &dyn Fn(f64) -> f64) -> f64 {
    let [start, end] = record.interval();
    let values: Vec<f64> =
        (0..=1000).map(|i| function(start + (end - start) * f64::from(i) / 1000.0)).collect();
    values.iter().fold(f64::MIN, |a, b| a.max(*b)) - values.iter().fold(f64::MAX, |a, b| a.min(*b))
}

/// Cubics are asked to be within `CLOSENESS` where they were compared; where they were not, they
/// may be twice as far, and rounding adds a tenth.
fn agrees(record: &Trajectory) {
    let motion = Motion::from_run(record, &About::default()).unwrap();
    let functions: Vec<_> = motion.quantities.iter().map(|q| record.function(&q.name).unwrap()).collect();
    let spreads: Vec<f64> = functions.iter().map(|function| spread(record, function)).collect();
    let points = 2 * record.layout().points.len();
    let scene = spreads[..points].iter().fold(0.0_f64, |most, spread| most.max(*spread));
    for phase in &motion.phases {
        for (interval, times) in phase.times.windows(2).enumerate() {
            for theta in [0.02, 0.21, 0.44, 0.73, 0.97] {
                let t = times[0] + theta * (times[1] - times[0]);
                for (i, function) in functions.iter().enumerate() {
                    let size = if i < points { scene } else { spreads[i] };
                    let value = function(t);
                    // What is constant but for rounding is as large as it is.
                    let bound = 2.1 * CLOSENESS * size.max(1e-5 * value.abs()) + 1e-11;
                    let error = (shown(&motion, phase, i, interval, theta) - value).abs();
                    assert!(error <= bound, "{} at {t}: {error:e} > {bound:e}", motion.quantities[i].name);
                }
            }
        }
    }
}

#[test]
fn the_page_shows_the_motion_between_its_samples() {
    agrees(&dropped());
    agrees(&swinging());
}

#[test]
fn both_sides_of_an_impact_are_kept() {
    let record = dropped();
    let motion = Motion::from_run(&record, &About::default()).unwrap();
    let rate = motion.quantities.iter().position(|quantity| quantity.name == "y'").unwrap();
    let y = record.function("y'").unwrap();
    let mut jumps = 0;
    for pair in motion.phases.windows(2) {
        let t = pair[1].times[0];
        assert_eq!(pair[0].times.last(), Some(&t));
        let last = pair[0].times.len() - 2;
        let [before, after] =
            [shown(&motion, &pair[0], rate, last, 1.0), shown(&motion, &pair[1], rate, 0, 0.0)];
        let step = motion.steps[rate];
        assert!((after - y(t)).abs() <= step && (before - y(t.next_down())).abs() <= step);
        jumps += usize::from((after - before).abs() > 0.1);
    }
    assert!(jumps >= 5, "{jumps}");
}

#[test]
fn phases_cover_the_run_and_begin_at_its_events() {
    let record = dropped();
    let motion = Motion::from_run(&record, &About::default()).unwrap();
    let [start, end] = record.interval();
    assert_eq!((motion.phases[0].times[0], motion.phases.last().unwrap().times.last()), (start, Some(&end)));
    for phase in &motion.phases[1..] {
        assert!(record.events().iter().any(|event| event.t == phase.times[0]));
    }
}

#[test]
fn ten_seconds_of_a_double_pendulum_are_short() {
    let length = Motion::from_run(&swinging(), &About::default()).unwrap().json().len();
    assert!(length < 100_000, "{length}");
}

#[test]
fn mirror_images_slip_against_each_other() {
    let spec = RunSpec::with(&[("m", 1.0), ("l", 1.0), ("k", 1.0), ("g", 9.81)]);
    let geometry = Geometry::new(&models().find("frame").unwrap().configuration(&spec).unwrap());
    let slips: Vec<i8> = geometry.contacts[0].pushes.iter().map(|push| push.slip).collect();
    assert_eq!(slips, [-1, 1]);
    assert_eq!((geometry.bodies.len(), geometry.springs.len()), (2, 1));
}

/// A point that is pulled until the spring is let go.
#[derive(BarSystem)]
#[particle(P, mass = m)]
#[ground(O = (0, 0))]
#[spring(OP, stiffness = k, while("t < s"))]
#[figure(P = (1, 0))]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
struct LetGo {
    m: f64,
    k: f64,
    s: f64,
}

/// The page and the moving picture show a spring while it acts.
#[test]
fn springs_that_are_off_are_not_drawn() {
    let models = crate::models![LetGo];
    let run = |s: f64| {
        let spec = RunSpec::with(&[("m", 1.0), ("k", 1.0), ("s", s)]).start(&[("x", 1.0), ("y", 0.0)]);
        models.find("let-go").unwrap().run(&spec.until("t = 1")).unwrap()
    };
    let off = |s: f64| -> Vec<Vec<usize>> {
        let motion = Motion::from_run(&run(s), &About::default()).unwrap();
        motion.phases.iter().map(|phase| phase.off.clone()).collect()
    };
    assert_eq!(off(0.4), [vec![], vec![0]]);
    assert_eq!((off(2.0), off(-1.0)), (vec![vec![]], vec![vec![0]]));
    let picture = |s: f64| super::moving_picture(&run(s), &About::default(), None).unwrap();
    let fades = "attributeName=\"opacity\" calcMode=\"discrete\" values=\"1;0\"";
    assert_eq!([0.4, 2.0].map(|s| picture(s).contains(fades)), [true, false]);
    let [acts, rests] = [2.0, -1.0].map(|s| picture(s).matches("<path").count());
    assert_eq!(acts, rests + 1);
}

#[test]
fn a_run_that_stopped_short_says_why() {
    let about = About { stopped: Some("accelerations are <undetermined>"), ..About::default() };
    let page = super::page(&dropped(), &about).unwrap();
    assert!(page.contains("stopped short: accelerations are &lt;undetermined&gt;"));
    assert!(!super::page(&dropped(), &About::default()).unwrap().contains("stopped short"));
}

#[test]
fn code_in_a_summary_is_set_as_code() {
    assert_eq!(super::prose("of `l` & `<m>`"), "of <code>l</code> &amp; <code>&lt;m&gt;</code>");
}

#[test]
fn nothing_of_the_data_ends_its_script() {
    let outputs = ["0 * phi".to_owned()];
    let about = About { title: "</script><b>", outputs: &outputs, ..About::default() };
    let page = super::page(&swinging(), &about).unwrap();
    assert_eq!(page.matches("</script>").count(), 2);
    assert!(!page.contains("<b>"));
}

/// As books write them; a page without would leave `phi` and a bare number.
#[test]
fn quantities_have_letters_and_units() {
    let parameters = [("g".to_owned(), 9.81)];
    let html = super::page(&dropped(), &About { parameters: &parameters, ..About::default() }).unwrap();
    for expected in
        ["g = 9.81 m/s²", "\"label\":\"φ\",\"unit\":\"rad\"", "\"name\":\"y\",\"label\":\"y\",\"unit\":\"m\""]
    {
        assert!(html.contains(expected), "{expected}");
    }
}
