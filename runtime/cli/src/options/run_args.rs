//! The arguments of a run, which several commands share.

use crate::CommandError;
use crate::options::pose_args::PoseArgs;
use crate::options::values::{Assignment, Release, assignment, blow, cut, number, release, time};
use crate::output::notes::note;
use clap::Args;
use core::f64::consts::TAU;
use liftoff::{EventKind, Trajectory};
use liftoff_studio::registry::{Entry, Place};
use liftoff_studio::run_spec::{PointImpulse, RunSpec, Values, overridden};

#[derive(Args, Debug)]
pub struct RunArgs {
    #[command(flatten)]
    pose: PoseArgs,
    /// A coordinate of a pose: start with the energy of this pose at rest
    #[arg(long, value_name = "NAME=VALUE", value_parser = assignment)]
    energy_of: Vec<Assignment>,
    #[command(flatten)]
    events: EventArgs,
}

/// Planned events, and when a run ends.
#[derive(Args, Clone, Default, Debug)]
pub struct EventArgs {
    /// A support that never opens; replaces the default ones
    #[arg(long, value_name = "SUPPORT")]
    hold: Vec<String>,
    /// A support that is removed at a time, in a sweep an expression of the varied names; replaces
    /// the default ones
    #[arg(long, value_name = "SUPPORT@T", value_parser = release)]
    release: Vec<Release>,
    /// A thread that is cut when a condition becomes true, `BD=t = 0.5`; replaces the default ones
    #[arg(long, value_name = "THREAD=EXPR", value_parser = cut)]
    cut: Vec<(String, String)>,
    /// An impulse at a point and a time; replaces the default ones
    #[arg(long, value_name = "POINT=PX,PY@T", value_parser = blow)]
    impulse: Vec<PointImpulse>,
    /// End where a contact closes, before the impact
    #[arg(long)]
    stop_at_impacts: bool,
    /// A condition to stop at, `phi = pi/2`, in a sweep with varied names; replaces the default ones
    #[arg(long, value_name = "EXPR")]
    until: Vec<String>,
    /// Latest end time; `--until` may end the run sooner; by default 1000 natural times, √(length / gravity) or shorter
    /// where speeds or impulses are high, counted from the last `--impulse`, `--release` or `--cut` if that is later; and not before
    /// `--until 't = …'`
    #[arg(long, value_name = "T", value_parser = time, allow_negative_numbers = true)]
    limit: Option<f64>,
    /// Relative tolerance of the integration
    #[arg(long, value_name = "X", value_parser = number, allow_negative_numbers = true)]
    tol: Option<f64>,
}

impl RunArgs {
    /// Whether a start is given.
    pub fn has_start(&self) -> bool {
        !self.pose.start.is_empty()
    }

    /// Whether the start has this coordinate or rate.
    pub fn is_given(&self, name: &str) -> bool {
        self.pose.start.iter().any(|given| given.name == name)
    }

    /// The latest end time, where one is given.
    pub fn limit(&self) -> Option<f64> {
        self.events.limit
    }

    /// Whether a condition is given that ends the run.
    pub fn has_until(&self) -> bool {
        !self.events.until.is_empty()
    }

    /// Says that a default condition has ended a run for which another end was given.
    pub fn note_end(&self, record: &Trajectory) {
        let stop = record.events().last().filter(|event| event.kind == EventKind::Stop);
        if let (Some(event), Some(limit), true) = (stop, self.events.limit, self.events.until.is_empty()) {
            let condition = event.note.as_ref().map_or(String::new(), |note| format!(" `{note}`"));
            note(&format!(
                "the model's default condition{condition} has ended the run before t = {limit}; --until 't = {limit}' replaces it"
            ));
        }
    }

    /// The default run of a model, overridden by the arguments. A given start drops the default energy level too.
    pub fn spec(&self, model: &Entry) -> Result<RunSpec, CommandError> {
        let default = model.default_run();
        let own_start = !self.pose.start.is_empty() || !self.energy_of.is_empty();
        let [set, start, level] = [
            (Place::Parameter, &self.pose.set),
            (Place::Start, &self.pose.start),
            (Place::EnergyOf, &self.energy_of),
        ]
        .map(|(place, given)| checked(model, place, given));
        let (set, start, level) = (set?, start?, level?);
        let start = if self.pose.start.is_empty() { default.start.clone() } else { start };
        let level = if own_start { level } else { default.energy_of.clone() };
        self.pose
            .start
            .iter()
            .chain(&self.energy_of)
            .filter_map(|given| likely_degrees(model, given))
            .for_each(|text| note(&text));
        self.events.check()?;
        let parameters = overridden(default.parameters.clone(), &set);
        Ok(self.events.spec(RunSpec { parameters, start, energy_of: level, ..default }))
    }
}

impl EventArgs {
    /// The default run, overridden by the arguments.
    pub fn spec(&self, default: RunSpec) -> RunSpec {
        RunSpec {
            hold: given(&self.hold, default.hold),
            release: given(&self.timed(), default.release),
            cut: given(&self.cut, default.cut),
            impulses: given(&self.impulse, default.impulses),
            stop_at_impacts: self.stop_at_impacts || default.stop_at_impacts,
            until: given(&self.until, default.until),
            limit: self.limit.or(default.limit),
            tolerance: self.tol.unwrap_or(default.tolerance),
            ..default
        }
    }

    /// The supports that vanish at times that are known.
    fn timed(&self) -> Values {
        let timed = self
            .release
            .iter()
            .filter_map(|release| Some((release.support.clone(), release.at.clone().ok()?)));
        timed.collect()
    }

    /// Whether times that are known are given.
    pub fn releases_at_times(&self) -> bool {
        self.release.iter().any(|release| release.at.is_ok())
    }

    /// Supports that vanish at times that depend on what is varied: `support=formula`.
    pub fn released_later(&self) -> impl Iterator<Item = String> {
        let later = self.release.iter().filter(|release| release.at.is_err());
        later.map(|release| format!("{}={}", release.support, release.text))
    }

    /// Refuses times that depend on names.
    fn check(&self) -> Result<(), CommandError> {
        let refused = self.release.iter().find_map(|release| release.at.clone().err());
        refused.map_or(Ok(()), |error| Err(CommandError::Usage(format!("--release: {error}"))))
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

/// The values, each of a name of its own and in a unit of what it measures.
pub fn checked(model: &Entry, place: Place, given: &[Assignment]) -> Result<Values, CommandError> {
    let names: Vec<&str> = given.iter().map(|given| given.name.as_str()).collect();
    place.check_names(&names).map_err(CommandError::Usage)?;
    for Assignment { name, unit, .. } in given {
        place.check_unit(model.layout(), name, *unit).map_err(CommandError::Usage)?;
    }
    Ok(given.iter().map(|given| (given.name.clone(), given.value)).collect())
}

/// What to say of an angle without a unit that is more than a turn and a whole number of degrees.
pub fn likely_degrees(model: &Entry, given: &Assignment) -> Option<String> {
    let Assignment { name, value, unit } = given;
    let is_angle = model.layout().is_angle(name);
    let large = value.abs() > TAU && value.abs() <= 3600.0 && value.fract() == 0.0;
    let likely = is_angle && unit.is_none() && large;
    likely.then(|| format!("{name} = {value} is {value} rad; for degrees write {name}={value}deg"))
}

/// What is given, or else the default.
pub fn given<T: Clone>(values: &[T], default: Vec<T>) -> Vec<T> {
    if values.is_empty() { default } else { values.to_vec() }
}
