//! Fig. 1a not quite symmetric: both bars fall in, or slide off to one side.

use crate::models;
use crate::paper::ReportError;
use crate::paper::border::find_border;
use crate::paper::quantity::Quantity;
use crate::paper::reading::{coordinate, events_of};
use liftoff::prelude::*;
use liftoff_studio::run_spec::{RunSpec, named};
use liftoff_studio::sweep::Sweep;

const MODEL: &str = "falling-pair-full";
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
}

impl Asymmetry {
    /// From runs with l = g = m = 1 that start at rest.
    pub fn new(tolerance: f64) -> Result<Self, ReportError> {
        let sweep = Sweep::of(models().find(MODEL)?)
            .spec(spec(0.0, tolerance))
            .vary(BESIDE)?
            .observe("first slide-off")?;
        let border = find_border(&sweep, 100.0 * tolerance)?;
        let far = models().find(MODEL)?.run(&spec(0.01, tolerance))?;
        let event = events_of(&far, EventKind::SlideOff).next();
        let slides_off = event.and_then(|event| coordinate(&far, &event.state, "phi_right"));
        Ok(Self { border, slides_off })
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
