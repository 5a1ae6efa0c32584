//! Fig. 1a not quite symmetric: both bars fall in, or slide off to one side.

use crate::models;
use crate::paper::ReportError;
use crate::paper::border::find_border;
use crate::paper::quantity::Quantity;
use crate::paper::reading::{coordinate, events_of};
use liftoff::prelude::*;
use liftoff_studio::run_spec::{RunSpec, named};
use liftoff_studio::source::embedded;
use liftoff_studio::sweep::Sweep;

const MODEL: &str = "falling-pair-full";
/// The same with the ground beside the gap, on which the bars' ends land.
const SHOULDERS: &str = include_str!("../../../data/falling_pair_shoulders.rs");
/// How far D is down at the start, l.
pub(in crate::paper) const DROP: f64 = 0.005;
/// How far beside the middle: the first falls in, the second does not. Beyond the border, fine
/// strips of both kinds alternate.
const BESIDE: &str = "x=0.007:0.007069807:2";

/// Where the first strip of starts ends that fall in.
pub struct Asymmetry {
    /// How far D may be beside the middle, l.
    pub border: f64,
    /// The angle of the bar that turns up as D slides off from 0.01 l.
    pub slides_off: Option<f64>,
    /// Where D is, in l beside the middle, as both bars come to lie on the shoulders from 0.01 l.
    pub lies_flat: Option<f64>,
}

impl Asymmetry {
    /// From runs with l = g = m = 1 that start at rest.
    pub fn new(tolerance: f64) -> Result<Self, ReportError> {
        let sweep = Sweep::new(models().find(MODEL)?)
            .spec(spec(0.0, tolerance))
            .vary(BESIDE)?
            .observe("first slide-off")?;
        let border = find_border(&sweep, 100.0 * tolerance)?;
        let start = spec(0.01, tolerance);
        let far = models().find(MODEL)?.run(&start)?;
        let event = events_of(&far, EventKind::SlideOff).next();
        let slides_off = event.and_then(|event| coordinate(&far, &event.state, "phi_right"));
        let held = embedded("falling-pair-shoulders", SHOULDERS, RunSpec::default());
        let held = held.run(&start.until("t = 10"))?;
        let last = events_of(&held, EventKind::Settle).last();
        let lies_flat = last.and_then(|event| coordinate(&held, &event.state, "x"));
        Ok(Self { border, slides_off, lies_flat })
    }

    /// The number of `references.json`.
    pub fn quantity(&self) -> Quantity {
        let what = "how far beside the middle D falls in from 0.005 l down";
        Quantity::number("fig1a.border", MODEL, what, "l", Some(self.border))
    }
}

/// Until a bar hangs, or D has left the gap.
fn spec(beside: f64, tolerance: f64) -> RunSpec {
    RunSpec {
        parameters: named(&[("m", 1.0), ("l", 1.0), ("g", 1.0)]),
        ..RunSpec::default()
            .start(&[("x", beside), ("y", DROP)])
            .until("phi_left = pi/2")
            .tolerance(tolerance)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Bars that fall in never reach the shoulders: the same motion with and without. Else no end
    /// goes through them.
    #[test]
    fn no_end_goes_through_the_shoulders() {
        let held = embedded("falling-pair-shoulders", SHOULDERS, RunSpec::default());
        let times =
            |run: &Trajectory| events_of(run, EventKind::Open).map(|event| event.t).collect::<Vec<_>>();
        let spec_in = spec(0.001, 1e-10);
        let (with, without) =
            (held.run(&spec_in).unwrap(), models().find(MODEL).unwrap().run(&spec_in).unwrap());
        assert_eq!(times(&with).len(), 2);
        times(&with).iter().zip(times(&without)).for_each(|(a, b)| assert!((a - b).abs() < 1e-8, "{a} {b}"));
        for beside in [0.008, 0.01, 0.05] {
            let run = held.run(&spec(beside, 1e-10).until("t = 10")).unwrap();
            let end = |name: &str| run.value(&Output::parse(run.layout(), name).unwrap(), 10.0);
            let lies_flat = end("y").abs() < 1e-9 && end("phi_left").abs() < 1e-9;
            assert!(lies_flat || beside < 0.01, "{beside}: {}", end("y"));
            let lowest = ["y(A)", "y(B)"].map(|name| {
                let output = Output::parse(run.layout(), name).unwrap();
                (0..=1000).map(|k| run.value(&output, f64::from(k) * 0.01)).fold(f64::INFINITY, f64::min)
            });
            assert!(lowest.iter().all(|y| *y > -1e-9), "{beside}: {lowest:?}");
        }
    }
}
