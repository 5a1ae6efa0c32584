//! The arguments of a run, which several commands share.

use crate::options::values::{assignment, blow, cut, number, overridden, release};
use clap::Args;
use liftoff_studio::run_spec::{PointImpulse, RunSpec};

#[derive(Args, Debug)]
pub struct RunArgs {
    /// A parameter
    #[arg(long, value_name = "NAME=VALUE", value_parser = assignment)]
    set: Vec<(String, f64)>,
    /// A coordinate or rate (`phi'`) at the start; replaces the default start
    #[arg(long, value_name = "NAME=VALUE", value_parser = assignment)]
    start: Vec<(String, f64)>,
    /// A coordinate of a pose: start with the energy of this pose at rest
    #[arg(long, value_name = "NAME=VALUE", value_parser = assignment)]
    energy_of: Vec<(String, f64)>,
    #[command(flatten)]
    events: EventArgs,
}

/// Planned events, and when a run ends.
#[derive(Args, Clone, Default, Debug)]
pub struct EventArgs {
    /// A support that never opens
    #[arg(long, value_name = "SUPPORT")]
    hold: Vec<String>,
    /// A support that vanishes at a time; replaces the default ones
    #[arg(long, value_name = "SUPPORT@T", value_parser = release)]
    release: Vec<(String, f64)>,
    /// A thread that is cut when a condition becomes true, `BD=t = 0.5`; replaces the default ones
    #[arg(long, value_name = "THREAD=EXPR", value_parser = cut)]
    cut: Vec<(String, String)>,
    /// An impulse at a point and a time; replaces the default ones
    #[arg(long, value_name = "POINT=PX,PY@T", value_parser = blow)]
    impulse: Vec<PointImpulse>,
    /// End where a contact closes, before the impact
    #[arg(long)]
    stop_at_impacts: bool,
    /// A condition to stop at, `phi = pi/2`; replaces the default ones
    #[arg(long, value_name = "EXPR")]
    until: Vec<String>,
    /// Latest end time; `--until` may end the run sooner; by default 1000 √(length / gravity)
    #[arg(long, value_name = "T", value_parser = number, allow_negative_numbers = true)]
    limit: Option<f64>,
    /// Relative tolerance of the integration
    #[arg(long, value_name = "X", value_parser = number, allow_negative_numbers = true)]
    tol: Option<f64>,
}

impl RunArgs {
    /// Whether a start is given.
    pub fn has_start(&self) -> bool {
        !self.start.is_empty()
    }

    /// The default run, overridden by the arguments. A given start drops the default energy level too.
    pub fn spec(&self, default: RunSpec) -> RunSpec {
        let own_start = !self.start.is_empty() || !self.energy_of.is_empty();
        let start = if self.start.is_empty() { default.start.clone() } else { self.start.clone() };
        let level = if own_start { self.energy_of.clone() } else { default.energy_of.clone() };
        let parameters = overridden(default.parameters.clone(), &self.set);
        self.events.spec(RunSpec { parameters, start, energy_of: level, ..default })
    }
}

impl EventArgs {
    /// The default run, overridden by the arguments.
    pub fn spec(&self, default: RunSpec) -> RunSpec {
        RunSpec {
            hold: self.hold.clone(),
            release: given(&self.release, default.release),
            cut: given(&self.cut, default.cut),
            impulses: given(&self.impulse, default.impulses),
            stop_at_impacts: self.stop_at_impacts || default.stop_at_impacts,
            until: given(&self.until, default.until),
            limit: self.limit.or(default.limit),
            tolerance: self.tol.unwrap_or(default.tolerance),
            ..default
        }
    }

    /// These, and where none is given those of a file.
    pub fn over(self, file: Self) -> Self {
        Self {
            hold: given(&self.hold, file.hold),
            release: given(&self.release, file.release),
            cut: given(&self.cut, file.cut),
            impulse: given(&self.impulse, file.impulse),
            stop_at_impacts: self.stop_at_impacts || file.stop_at_impacts,
            until: given(&self.until, file.until),
            limit: self.limit.or(file.limit),
            tol: self.tol.or(file.tol),
        }
    }
}

/// What is given, or else the default.
pub fn given<T: Clone>(values: &[T], default: Vec<T>) -> Vec<T> {
    if values.is_empty() { default } else { values.to_vec() }
}
