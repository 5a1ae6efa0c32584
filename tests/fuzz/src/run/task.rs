//! One run to be made.

use std::fmt;

use liftoff::{Budget, Simulation, Trajectory};
use liftoff_core::model::Form;
use liftoff_studio::RunSpec;
use liftoff_studio::registry::{Entry, MethodId, MotionError};

use super::Relation;

/// Some seconds of the slowest method; what comes near it ends by a budget.
const BUDGET: Budget =
    Budget { steps: 10_000, events: 1000, impacts: 1000, trials: 10_000, memory: 1 << 28, time: None };

/// A run of a model, and what it is compared with.
#[derive(Clone)]
pub struct Task {
    /// The model.
    pub model: &'static Entry,
    /// What is run.
    pub spec: RunSpec,
    /// By which method.
    pub method: MethodId,
    /// In which form, where a phase has both.
    pub form: Form,
    /// What must agree with it.
    pub relation: Relation,
}

impl Task {
    /// The simulation, with a budget.
    ///
    /// # Errors
    /// The start or a parameter is refused.
    pub fn simulation(&self) -> Result<Simulation, MotionError> {
        let simulation = self.model.simulation(&self.spec)?;
        Ok(simulation.method(self.method).form(self.form).budget(BUDGET))
    }

    /// Whether a parameter is so far from its usual value that squares and quotients of quantities
    /// lose their digits, or from another one of its dimension that sums lose the lesser: then a
    /// run may stop short, but may not be wrong without a word.
    pub fn is_wild(&self) -> bool {
        let usual = self.model.default_run().parameters;
        let usual =
            |name: &str| usual.iter().find(|(known, _)| known == name).map_or(1.0, |(_, value)| *value);
        let dimensions = self.model.layout().dimensions;
        let known = self.spec.parameters.iter().map(|(name, value)| (name, (value / usual(name)).abs()));
        let ratios: Vec<(usize, f64)> = known
            .filter(|(_, ratio)| *ratio != 0.0)
            .filter_map(|(name, ratio)| {
                Some((self.model.layout().parameters.iter().position(|p| p == name)?, ratio))
            })
            .collect();
        let lost = |(i, a): &(usize, f64), (k, b): &(usize, f64)| {
            dimensions[*i].is_some() && dimensions[*i] == dimensions[*k] && a / b < f64::EPSILON
        };
        ratios
            .iter()
            .any(|one| !(1e-20..1e20).contains(&one.1) || ratios.iter().any(|other| lost(one, other)))
    }

    /// The whole motion, if there is one.
    pub fn run(&self) -> Option<Trajectory> {
        self.simulation().ok()?.run().ok()
    }

    /// The same at another tolerance.
    pub fn with_tolerance(&self, tolerance: f64) -> Self {
        Self { spec: self.spec.clone().tolerance(tolerance), ..self.clone() }
    }

    /// The same with parameters that are some roundings larger or smaller, each by as many of its
    /// own.
    pub fn rounded(&self, sign: f64) -> Self {
        let mut task = self.clone();
        for (k, (_, value)) in task.spec.parameters.iter_mut().enumerate() {
            *value *= 1.0 + sign * (k % 4 + 1) as f64 * 2.0 * f64::EPSILON;
        }
        task
    }

    /// Another run by the same options.
    pub fn with_spec(&self, spec: RunSpec) -> Self {
        Self { spec, ..self.clone() }
    }
}

/// As options of `liftoff run`, but for what that has no word for.
impl fmt::Display for Task {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Self { model, spec, method, form, relation } = self;
        write!(f, "liftoff run {}", model.name())?;
        for (option, values) in
            [("set", &spec.parameters), ("start", &spec.start), ("energy-of", &spec.energy_of)]
        {
            for (name, value) in values {
                write!(f, " --{option} \"{name}={value:?}\"")?;
            }
        }
        spec.hold.iter().try_for_each(|support| write!(f, " --hold {support}"))?;
        spec.release.iter().try_for_each(|(support, at)| write!(f, " --release {support}@{at:?}"))?;
        spec.cut.iter().try_for_each(|(thread, when)| write!(f, " --cut '{thread}={when}'"))?;
        for blow in &spec.impulses {
            let [x, y] = blow.impulse;
            write!(f, " --impulse '{}={x:?},{y:?}@{:?}'", blow.point, blow.at)?;
        }
        spec.until.iter().try_for_each(|condition| write!(f, " --until '{condition}'"))?;
        if let Some(limit) = spec.limit {
            write!(f, " --limit {limit:?}")?;
        }
        write!(f, " --tol {:?} --method {}", spec.tolerance, method.name())?;
        if *form == Form::Multipliers {
            write!(f, " # projected form")?;
        }
        write!(f, " # {relation:?}")
    }
}
