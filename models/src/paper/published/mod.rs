//! Fig. 1b as published: equal angles, and the total reaction watched.

pub mod figures;

use super::ReportError;
use super::quantity::Quantity;
use super::reading::{coordinate, evaluate_output, events_of, extrema, range};
use crate::models;
use liftoff::Extremum;
use liftoff::prelude::*;
use liftoff_studio::run_spec::{RunSpec, named};

pub(super) const MODEL: &str = "zigzag-published";
/// Weight over 2(m₁ + m₂)g: 1 at rest.
const REACTION: &str = "N(A, C, E) / (2 * (m1 + m2) * g)";

/// The mass ratio m₂/(m₁ + m₂) as the ids write it.
pub type Ratio = (&'static str, f64);

/// The ratios of Table 1.
const RATIOS: [Ratio; 5] = [("0.00", 0.0), ("0.25", 0.25), ("0.50", 0.5), ("0.75", 0.75), ("1.00", 1.0)];

/// A run with l = g = m₁ + m₂ = 1.
pub fn normalised(spec: RunSpec, ratio: f64) -> RunSpec {
    let parameters = [("m1", 1.0 - ratio), ("m2", ratio), ("l", 1.0), ("g", 1.0)];
    RunSpec { parameters: named(&parameters), ..spec }
}

/// The runs of one mass ratio.
pub struct PublishedRuns {
    ratio: Ratio,
    /// Until B and D reach the floor.
    flight: Trajectory,
    /// Supports held, past the zero of their reaction.
    held: Trajectory,
    /// Until all bars lie level.
    level: Trajectory,
}

impl PublishedRuns {
    /// The runs of every ratio in Table 1.
    pub fn all(tolerance: f64) -> Result<Vec<Self>, ReportError> {
        RATIOS.into_iter().map(|ratio| Self::new(ratio, tolerance)).collect()
    }

    /// The runs of this ratio.
    pub fn new(ratio: Ratio, tolerance: f64) -> Result<Self, ReportError> {
        let model = models().find(MODEL)?;
        let spec = normalised(model.default_run().tolerance(tolerance), ratio.1);
        let level = spec.clone().until("phi = 0");
        Ok(Self {
            ratio,
            flight: model.run(&spec)?,
            held: model.run(&level.clone().hold(&["A", "C", "E"]))?,
            level: model.run(&level)?,
        })
    }

    /// The mass ratio.
    pub fn ratio(&self) -> Ratio {
        self.ratio
    }

    /// The motion until B and D reach the floor.
    pub fn flight(&self) -> &Trajectory {
        &self.flight
    }

    /// The motion with the supports held, until all bars lie level.
    pub fn held(&self) -> &Trajectory {
        &self.held
    }

    /// The motion until all bars lie level.
    pub fn level(&self) -> &Trajectory {
        &self.level
    }

    /// Whether this is the ratio whose motion the paper shows.
    pub fn is_shown(&self) -> bool {
        self.ratio.0 == "0.50"
    }

    /// The angle where the total reaction vanishes or only touches zero.
    pub fn lift_off(&self) -> Option<f64> {
        self.angle(EventKind::Touch).or_else(|| self.angle(EventKind::Open))
    }

    /// The angle where contact is regained: B and D reach the floor, or the reaction only touched
    /// zero.
    pub fn touch_down(&self) -> Option<f64> {
        self.angle(EventKind::Touch).or_else(|| self.angle(EventKind::Close))
    }

    fn event(&self, kind: EventKind) -> Option<&Event> {
        events_of(&self.flight, kind).next()
    }

    fn angle(&self, kind: EventKind) -> Option<f64> {
        coordinate(&self.flight, &self.event(kind)?.state, "phi")
    }

    /// Times of lift-off and of B and D reaching the floor.
    pub fn interval(&self) -> Option<[f64; 2]> {
        Some([self.event(EventKind::Open)?.t, self.event(EventKind::Close)?.t])
    }

    /// Where the reaction turns on the way down.
    pub fn turning_points(&self) -> Result<Vec<Extremum>, ReportError> {
        Ok(extrema(&self.held, REACTION)?)
    }

    /// The least reaction before the bars lie level, with its time.
    fn least(&self) -> Result<Option<Extremum>, ReportError> {
        let minima = self.turning_points()?.into_iter().filter(|extremum| extremum.minimum);
        Ok(minima.min_by(|a, b| a.value.total_cmp(&b.value)))
    }

    /// The numbers of `references.json` for this ratio.
    pub fn quantities(&self) -> Result<Vec<Quantity>, ReportError> {
        let number = |id: &str, quantity, unit, value| {
            Quantity::number(format!("fig1b.{id}[{}]", self.ratio.0), MODEL, quantity, unit, value)
        };
        let least = self.least()?;
        let star = least.as_ref().map(|least| evaluate_output(&self.held, "phi", least.t)).transpose()?;
        let [lift_off, touch_down] = match self.event(EventKind::Touch) {
            Some(_) => ["angle where N touches zero", "the same: N only touches zero, no flight"],
            None => ["angle at lift-off", "angle as B and D reach the floor"],
        };
        let mut all = vec![
            number("phi_star", "angle of the least total reaction", "rad", star),
            number(
                "mu",
                "2 − N/((m1 + m2) g) at the least total reaction",
                "1",
                least.map(|e| 2.0 * (1.0 - e.value)),
            ),
            number("phi1", lift_off, "rad", self.lift_off()),
            number("phi2", touch_down, "rad", self.touch_down()),
        ];
        if self.is_shown() {
            all.extend(self.shown(number)?);
        }
        Ok(all)
    }

    fn shown(
        &self,
        number: impl Fn(&str, &'static str, &'static str, Option<f64>) -> Quantity,
    ) -> Result<Vec<Quantity>, ReportError> {
        let level = self.level.interval()[1];
        let over = |output| self.interval().map(|flight| range(&self.flight, output, flight)).transpose();
        let touch = |output| {
            self.interval().map(|flight| evaluate_output(&self.flight, output, flight[1])).transpose()
        };
        Ok(vec![
            number(
                "rise_flat",
                "rise of C as all bars lie level",
                "l",
                Some(evaluate_output(&self.level, "y(C)", level)?),
            ),
            number("rise_max", "greatest rise of C in flight", "l", over("y(C)")?.map(|[_, high]| high)),
            number(
                "omega_flat",
                "angular velocity as all bars lie level",
                "sqrt(g/l)",
                Some(evaluate_output(&self.level, "phi'", level)?),
            ),
            number(
                "alpha_min",
                "least angular acceleration in flight",
                "g/l",
                over("phi''")?.map(|[low, _]| low),
            ),
            number(
                "a_C_touch",
                "acceleration of C as B and D reach the floor",
                "g, downward",
                touch("ay(C)")?.map(|a| -a),
            ),
        ])
    }
}
