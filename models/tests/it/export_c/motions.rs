//! Motions by a Runge-Kutta method in C beside those of the program.

use super::library::{Answer, Library};
use crate::cases::model;
use crate::processes::folder;
use liftoff::{Segment, Trajectory};
use liftoff_core::model::Layout;
use liftoff_models::models;

/// Steps of the coarser motion, as many as its model needs.
const STEPS: [usize; 5] = [200, 800, 3_200, 12_800, 51_200];

/// The longest segment of a run.
fn longest(run: &Trajectory) -> Segment {
    let segments = run.segments().into_iter();
    segments.max_by(|a, b| (a.t1 - a.t0).total_cmp(&(b.t1 - b.t0))).expect("a segment")
}

/// The whole state in a segment, with the time and what acts.
fn whole(layout: &Layout, run: &Trajectory, segment: &Segment, t: f64) -> Vec<f64> {
    let mut state = layout.state_at(&run.state(t), t);
    for (i, switch) in (layout.switch(0)..layout.entries()).enumerate() {
        state[switch] = f64::from(u8::from(segment.acting.contains(&i)));
    }
    state
}

/// How far two states are apart, over the largest entry.
fn apart(a: &[f64], b: &[f64]) -> f64 {
    let largest = |x: &mut dyn Iterator<Item = f64>| x.fold(0.0, |most: f64, x| most.max(x.abs()));
    largest(&mut a.iter().zip(b).map(|(a, b)| a - b)) / largest(&mut b.iter().copied()).max(f64::MIN_POSITIVE)
}

/// States at the end with the fewest steps that have an error below 1e-8, and with twice as many.
fn converged(ask: &dyn Fn(usize) -> [Answer; 2]) -> [Answer; 2] {
    let is_fine =
        |[coarse, fine]: &[Answer; 2]| coarse.keys().all(|form| apart(&coarse[form], &fine[form]) < 15e-8);
    STEPS.into_iter().map(ask).find(is_fine).expect("the method converges")
}

/// The longest segment of each model's own run, or a second of it, with all coordinates and in
/// closed form where there is one. With half the step the error is a 16th, so that of the finer one
/// is a 15th of what the two differ by, to a factor of 2 where the next order is still seen. The
/// run's own tolerance is 1e-13 a step; chaos makes 1e-10 of what it sums up to.
#[test]
fn its_motions_are_those_of_the_program_to_the_error_of_the_method() {
    let folder = folder("motions");
    let models = models();
    let mut forms = [0, 0];
    for entry in models.iter() {
        let (name, layout) = (entry.name(), entry.layout());
        let run = entry.run(&entry.default_run()).expect("its own run");
        let segment = longest(&run);
        // Somewhere within, where no event is near.
        let length = (segment.t1 - segment.t0).min(1.0);
        let (from, to) = (segment.t0 + 0.01 * length, segment.t0 + 0.9 * length);
        let library = Library::build(&folder, name, layout);
        let state = whole(layout, &run, &segment, from);
        let asked = library.question("from", &model(name).parameters, segment.active_basis, &state);
        let question = |steps: usize| format!("{asked} {:e} {steps}", to - from);
        let ask = |steps: usize| {
            let answers = library.ask(&[question(steps), question(2 * steps)]);
            answers.try_into().expect("two answers")
        };
        let [coarse, fine] = converged(&ask);
        let expected = whole(layout, &run, &segment, to);
        for (form, count) in ["whole", "closed"].into_iter().zip(&mut forms) {
            let (Some(coarse), Some(fine)) = (coarse.get(form), fine.get(form)) else { continue };
            let (error, off) = (apart(coarse, fine) / 15.0, apart(fine, &expected));
            println!("{name}, {form}, {:.3} s: {error:.1e}, {off:.1e}", to - from);
            assert!(off <= 2.0 * error + 1e-10, "{name}, {form}: {off:e} by {error:e}");
            *count += 1;
        }
    }
    assert!(forms[0] >= 42 && forms[1] >= 30, "{forms:?}");
}
