//! What to simulate: parameters, start and stop; a model with a default run.

use liftoff_core::model::Layout;
use serde::{Deserialize, Serialize};

/// The name of the time, among the values at the start.
pub(super) const TIME: &str = "t";

/// Named values in the order given.
pub type Values = Vec<(String, f64)>;

/// Everything that a run needs beside the model's equations.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
pub struct RunSpec {
    /// Values of the parameters.
    pub parameters: Values,
    /// Coordinates and rates (`phi'`) given at the start; the others follow. `t` is the time of the
    /// start, zero where it is not given.
    pub start: Values,
    /// The pose at rest on whose energy level the motion starts; empty: the start's rates hold.
    pub energy_of: Values,
    /// Supports that never open.
    pub hold: Vec<String>,
    /// Supports that vanish, with the time.
    pub release: Values,
    /// Threads that are cut, with the condition.
    pub cut: Vec<(String, String)>,
    /// Impulses at points.
    pub impulses: Vec<PointImpulse>,
    /// Whether the run ends where a contact closes.
    pub stop_at_impacts: bool,
    /// Conditions to stop at, whichever comes first.
    pub until: Vec<String>,
    /// Latest end time; `until` may end the run sooner; none: that of `Simulation::limit`.
    pub limit: Option<f64>,
    /// Relative tolerance of the integration.
    pub tolerance: f64,
}

/// An impulse.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
pub struct PointImpulse {
    /// Name of the point that it acts at.
    pub point: String,
    /// Horizontal and vertical component, N s.
    pub impulse: [f64; 2],
    /// When.
    pub at: f64,
}

impl RunSpec {
    /// A run of a model with these parameters, from its nominal figure.
    pub fn with(parameters: &[(&str, f64)]) -> Self {
        Self {
            parameters: named(parameters),
            start: Vec::new(),
            energy_of: Vec::new(),
            hold: Vec::new(),
            release: Vec::new(),
            cut: Vec::new(),
            impulses: Vec::new(),
            stop_at_impacts: false,
            until: Vec::new(),
            limit: None,
            tolerance: 1e-12,
        }
    }

    /// The run that a model's declaration gives; without the values that it leaves open.
    pub fn declared(layout: &Layout) -> Self {
        let defaults = layout.defaults;
        let values = layout.parameters.iter().zip(defaults.values);
        let parameters: Vec<(&str, f64)> =
            values.filter_map(|(name, value)| Some((*name, (*value)?))).collect();
        Self {
            until: defaults.until.iter().map(ToString::to_string).collect(),
            limit: defaults.limit,
            ..Self::with(&parameters).start(defaults.start)
        }
    }

    /// The time of the start.
    pub fn begin(&self) -> f64 {
        self.start.iter().rev().find(|(name, _)| name == TIME).map_or(0.0, |(_, t)| *t)
    }

    /// The same, started here.
    #[must_use]
    pub fn start(self, values: &[(&str, f64)]) -> Self {
        Self { start: named(values), ..self }
    }

    /// The same, on the energy level of this pose at rest.
    #[must_use]
    pub fn energy_of(self, values: &[(&str, f64)]) -> Self {
        Self { energy_of: named(values), ..self }
    }

    /// The same with these supports held.
    #[must_use]
    pub fn hold(self, supports: &[&str]) -> Self {
        Self { hold: supports.iter().map(ToString::to_string).collect(), ..self }
    }

    /// The same with this support taken away at a time.
    #[must_use]
    pub fn release(mut self, support: &str, at: f64) -> Self {
        self.release.push((support.into(), at));
        self
    }

    /// The same with this thread cut when a condition becomes true.
    #[must_use]
    pub fn cut(mut self, thread: &str, condition: &str) -> Self {
        self.cut.push((thread.into(), condition.into()));
        self
    }

    /// The same with an impulse at a point and a time.
    #[must_use]
    pub fn impulse(mut self, point: &str, impulse: [f64; 2], at: f64) -> Self {
        self.impulses.push(PointImpulse { point: point.into(), impulse, at });
        self
    }

    /// The same, stopped here too.
    #[must_use]
    pub fn until(mut self, condition: &str) -> Self {
        self.until.push(condition.into());
        self
    }

    /// The same with this latest end time.
    #[must_use]
    pub fn limit(self, limit: f64) -> Self {
        Self { limit: Some(limit), ..self }
    }

    /// The same at this tolerance.
    #[must_use]
    pub fn tolerance(self, tolerance: f64) -> Self {
        Self { tolerance, ..self }
    }
}

/// `values` with their names owned.
pub fn named(values: &[(&str, f64)]) -> Values {
    values.iter().map(|&(name, value)| (name.into(), value)).collect()
}

/// `values` with those `given` put in place of their namesakes, or at the end.
pub fn overridden(mut values: Values, given: &[(String, f64)]) -> Values {
    for (name, value) in given {
        match values.iter_mut().find(|(known, _)| known == name) {
            Some(entry) => entry.1 = *value,
            None => values.push((name.clone(), *value)),
        }
    }
    values
}

impl Default for RunSpec {
    /// No parameters, from the nominal figure.
    fn default() -> Self {
        Self::with(&[])
    }
}

/// A bar system with a default run.
///
/// It is known by the struct's name (`StepLadder` as `step-ladder`) and by the first paragraph of
/// its documentation.
pub trait DefaultRun {
    /// The default run; it gives all parameters.
    fn default_run() -> RunSpec;
}
