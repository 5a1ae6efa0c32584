//! Fig. 1a from its runs: the fall, and the same with the corners held past the zero of their
//! reaction.

pub mod asymmetry;
mod figures;
mod picture;
mod positions;

use super::ReportError;
use super::printed::GRAVITY;
use super::quantity::Quantity;
use super::reading::{evaluate_output, events_of, range};
use crate::models;
use liftoff::prelude::*;
use liftoff_studio::run_spec::{RunSpec, named};

pub(super) use positions::{BARS, ground};

pub(super) const MODEL: &str = "falling-pair";

/// The runs behind the numbers and figures of Fig. 1a: m = l = 1, the paper's g, on the energy
/// level of φ = 0.
pub struct FallingPairRuns {
    fall: Trajectory,
    held: Trajectory,
    l: f64,
    g: f64,
}

impl FallingPairRuns {
    /// Runs the model.
    pub fn new(tolerance: f64) -> Result<Self, ReportError> {
        let model = models().find(MODEL)?;
        let (l, g) = (1.0, GRAVITY);
        let spec = model.default_run().tolerance(tolerance);
        let fall = RunSpec { parameters: named(&[("m", 1.0), ("l", l), ("g", g)]), ..spec };
        let held = RunSpec { until: vec!["phi = pi/3".into()], ..fall.clone() }.hold(&["P", "Q"]);
        Ok(Self { fall: model.run(&fall)?, held: model.run(&held)?, l, g })
    }

    /// The motion until the bars meet.
    pub fn fall(&self) -> &Trajectory {
        &self.fall
    }

    /// The motion with the corners held past the zero of their reaction, until φ = π/3.
    pub fn held(&self) -> &Trajectory {
        &self.held
    }

    /// Time of lift-off.
    pub fn opening(&self) -> Option<f64> {
        events_of(&self.fall, EventKind::Open).next().map(|event| event.t)
    }

    /// The numbers of `references.json`.
    pub fn quantities(&self) -> Result<Vec<Quantity>, ReportError> {
        let fall = &self.fall;
        let open = self.opening();
        let [start, end] = fall.interval();
        let opened = |output| open.map(|t| evaluate_output(fall, output, t)).transpose();
        let ends = range(fall, "y(B)", [start, end])?;
        let degrees = fall.function("phi * 180 / pi")?;
        let in_flight = |open: f64| degrees(end) - degrees(open);
        let number = |id: &str, quantity, unit, value| {
            Quantity::number(format!("fig1a.{id}"), MODEL, quantity, unit, value)
        };
        Ok(vec![
            number("phi1", "angle at lift-off", "rad", opened("phi")?),
            number("phi1_degrees", "angle at lift-off", "deg", opened("phi * 180 / pi")?),
            number("step", "a tenth of the angle in flight", "deg", open.map(|t| in_flight(t) / 10.0)),
            number("omega1", "angular velocity at lift-off", "rad/s", opened("phi'")?),
            number("alpha1", "angular acceleration at lift-off", "rad/s^2", opened("phi''")?),
            number(
                "flight_time",
                "time from lift-off until the bars meet",
                "sqrt(l/g)",
                open.map(|t| (end - t) / (self.l / self.g).sqrt()),
            ),
            number(
                "omega_end",
                "angular velocity as the bars meet",
                "sqrt(g/l)",
                Some(evaluate_output(fall, "phi'", end)? / (self.g / self.l).sqrt()),
            ),
            number(
                "travel_D",
                "travel of the hinge until the bars meet",
                "l",
                Some(-evaluate_output(fall, "y(D)", end)? / self.l),
            ),
            number("height_ends", "height of the path of A and B", "l", Some((ends[1] - ends[0]) / self.l)),
        ])
    }
}
