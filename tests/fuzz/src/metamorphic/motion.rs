//! A run as rows of outputs: what `liftoff run FILE.rs --json` prints of it.

use std::collections::BTreeMap;
use std::f64::consts::FRAC_PI_2;
use std::fmt;

use liftoff::{Event, EventKind, Instant, LoggedDecision, Output, RunCause, Trajectory};
use liftoff_studio::{RunSpec, source};

use super::form::Form;
use super::print::name_target;
use super::scene::{Reference, Scene, Vector, unwind};

pub const TOLERANCE: f64 = 1e-10;

const BUDGET: liftoff::Budget = liftoff::Budget {
    steps: 20_000,
    events: 300,
    impacts: 1000,
    trials: 10_000,
    memory: 1 << 28,
    time: None,
};

/// Why there is no motion.
#[derive(Debug)]
pub enum Refusal {
    /// The declaration is a mistake.
    Declaration(String),
    /// The start is refused.
    Start(String),
    /// The run stopped short, at this time; whether the motion was undecided before.
    Stopped { text: String, t: f64, is_undecided: bool },
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Declaration(text) => write!(f, "declaration: {text}"),
            Self::Start(text) => write!(f, "start: {text}"),
            Self::Stopped { text, t, .. } => write!(f, "stopped at {t}: {text}"),
        }
    }
}

/// A run of a form.
pub struct Motion {
    pub run: Trajectory,
    points: BTreeMap<String, [Output; 6]>,
    contacts: Vec<Contact>,
    drives: Vec<Output>,
    sliders: Vec<Output>,
    energies: [Output; 3],
}

/// Outputs of a support or thread.
struct Contact {
    name: String,
    normal: Output,
    gap: Output,
    friction: Option<[Output; 2]>,
}

/// One row.
#[derive(Clone, Debug, Default)]
pub struct Row {
    pub t: f64,
    /// Position, velocity and acceleration of each point.
    pub points: BTreeMap<String, [Vector; 3]>,
    /// Of each support and thread.
    pub contacts: Vec<ContactRow>,
    pub drives: Vec<f64>,
    pub sliders: Vec<f64>,
    /// By how much each body has turned since the start, counted through; of bodies whose angles
    /// are coordinates.
    pub turns: BTreeMap<usize, f64>,
    /// Kinetic, potential, and what was lost.
    pub energies: [f64; 3],
}

#[derive(Clone, Debug, Default)]
pub struct ContactRow {
    pub name: String,
    pub normal: f64,
    pub gap: f64,
    /// Friction force and slip velocity.
    pub friction: Option<[f64; 2]>,
}

/// The start of a form as coordinates and rates of its model; none where it is refused.
pub fn start_form(form: &Form) -> Vec<(String, f64)> {
    let models = source::models(&form.declare()).unwrap_or_default();
    models.first().map_or_else(Vec::new, |model| list_start(&form.scene, model.layout().coordinates))
}

/// The start of a scene as coordinates and rates of its model.
fn list_start(scene: &Scene, coordinates: &[liftoff_core::model::Coordinate]) -> Vec<(String, f64)> {
    let mut start = Vec::new();
    for name in coordinates.iter().map(|coordinate| coordinate.name) {
        let value = match name.split_at(1) {
            ("q", index) => index.parse::<usize>().ok().map(|k| {
                let body = &scene.bodies[k];
                match body.reference {
                    Reference::Quarters(quarters) => {
                        [unwind(body.angle - f64::from(quarters) * FRAC_PI_2), body.rate]
                    }
                    Reference::Body(other) => {
                        let other = &scene.bodies[other];
                        [unwind(body.angle - other.angle), body.rate - other.rate]
                    }
                }
            }),
            (axis, point) => scene.points.get(point.trim_start_matches('_')).map(|place| {
                let k = usize::from(axis == "y");
                [place.position[k], place.velocity[k]]
            }),
        };
        if let Some([value, rate]) = value {
            start.extend([(name.to_owned(), value), (format!("{name}'"), rate)]);
        }
    }
    start
}

impl Motion {
    /// The run of a form from its start.
    pub fn run_form(form: &Form) -> Result<Self, Refusal> {
        Self::run_from(form, TOLERANCE, None)
    }

    /// By another tolerance, or from another start.
    pub fn run_from(form: &Form, tolerance: f64, from: Option<Vec<(String, f64)>>) -> Result<Self, Refusal> {
        let text = form.declare();
        let models = source::models(&text).map_err(|mistakes| {
            Refusal::Declaration(
                mistakes.iter().map(|mistake| mistake.text.clone()).collect::<Vec<_>>().join("; "),
            )
        })?;
        let model = &models[0];
        let scene = &form.scene;
        let start = from.unwrap_or_else(|| list_start(scene, model.layout().coordinates));
        let spec = RunSpec { start, limit: Some(scene.limit), ..model.default_run() }.tolerance(tolerance);
        let simulation = model.simulation(&spec).map_err(|error| Refusal::Start(error.to_string()))?;
        let run = simulation.budget(BUDGET).run().map_err(|error| match error.cause() {
            RunCause::Start(cause) => Refusal::Start(cause.to_string()),
            cause => {
                let (text, t) = (cause.to_string(), error.trajectory().end_time());
                Refusal::Stopped { text, t, is_undecided: undecided_from(error.trajectory()) <= t }
            }
        })?;
        Self::with_outputs(scene, run).map_err(|text| Refusal::Declaration(format!("output: {text}")))
    }

    fn with_outputs(scene: &Scene, run: Trajectory) -> Result<Self, String> {
        let parse = |text: String| run.output(&text).map_err(|error| error.to_string());
        let mut points = BTreeMap::new();
        for name in
            scene.points.keys().filter(|name| !scene.grounds.contains(name) && !scene.corners.contains(name))
        {
            let [x, y, vx, vy, ax, ay] =
                ["x", "y", "vx", "vy", "ax", "ay"].map(|f| parse(format!("{f}({name})")));
            points.insert(name.clone(), [x?, y?, vx?, vy?, ax?, ay?]);
        }
        let mut contacts = Vec::new();
        let names =
            scene.supports.iter().map(|support| (support, support.friction.is_some() || support.is_rough));
        let names = names.map(|(support, rubs)| (&support.point, [rubs, support.friction.is_some()]));
        for (name, rubs) in names.chain(scene.threads.iter().map(|thread| (&thread.name, [false; 2]))) {
            let friction = match rubs {
                // The slip of a rough contact is no output.
                [true, slips] => {
                    Some([format!("R({name})"), if slips { format!("v({name})") } else { "0".to_owned() }])
                }
                _ => None,
            };
            let friction = match friction {
                Some([force, slip]) => Some([parse(force)?, parse(slip)?]),
                None => None,
            };
            let [normal, gap] = ["N", "gap"].map(|f| parse(format!("{f}({name})")));
            contacts.push(Contact { name: name.clone(), normal: normal?, gap: gap?, friction });
        }
        let drives =
            scene.drives.iter().map(|drive| parse(format!("drive({})", name_target(scene, &drive.target))));
        let sliders = scene.sliders.iter().map(|slider| parse(format!("slider({})", slider.point)));
        let (drives, sliders) = (drives.collect::<Result<_, _>>()?, sliders.collect::<Result<_, _>>()?);
        let [t, v, d] = ["T", "V", "D"].map(|f| parse(f.to_owned()));
        let energies = [t?, v?, d?];
        Ok(Self { points, contacts, drives, sliders, energies, run })
    }

    /// All outputs at a time; at events after them, or before where that is asked for.
    pub fn row(&self, t: f64, is_before: bool) -> Row {
        let value = |output: &Output| self.run.value_at(output, Instant { t, is_before });
        let points = self.points.iter().map(|(name, outputs)| {
            let [x, y, vx, vy, ax, ay] = outputs.each_ref().map(value);
            (name.clone(), [[x, y], [vx, vy], [ax, ay]])
        });
        let contacts = self.contacts.iter().map(|contact| ContactRow {
            name: contact.name.clone(),
            normal: value(&contact.normal),
            gap: value(&contact.gap),
            friction: contact.friction.as_ref().map(|pair| pair.each_ref().map(value)),
        });
        Row {
            t,
            points: points.collect(),
            contacts: contacts.collect(),
            drives: self.drives.iter().map(value).collect(),
            sliders: self.sliders.iter().map(value).collect(),
            turns: self.turns(t),
            energies: self.energies.each_ref().map(value),
        }
    }

    fn turns(&self, t: f64) -> BTreeMap<usize, f64> {
        let [start, now] = [0.0, t].map(|t| self.run.state(t));
        let coordinates = self.run.layout().coordinates.iter().enumerate();
        let turned = coordinates.filter_map(|(k, coordinate)| {
            let body = coordinate.name.strip_prefix('q')?.parse().ok()?;
            Some((body, now[k] - start[k]))
        });
        turned.collect()
    }

    /// Whether all rates are zero to within the tolerance.
    pub fn is_at_rest(&self, t: f64) -> bool {
        let row = self.row(t, false);
        let speeds = row.points.values().map(|point| point[1][0].hypot(point[1][1]));
        speeds.fold(0.0, f64::max) < 1e-6
    }

    /// Its state at a time as values of a start.
    pub fn state(&self, t: f64) -> Vec<(String, f64)> {
        let layout = self.run.layout();
        layout
            .names_of_state()
            .zip(self.run.state(t))
            .map(|(name, value)| (name.to_string(), value))
            .collect()
    }

    /// Events, each with one contact; what slips and sticks only where reactions decide it.
    pub fn events(&self, is_decided: bool) -> Vec<(f64, EventKind, String)> {
        let counts = |kind: EventKind| match kind {
            EventKind::Start | EventKind::End | EventKind::Touch | EventKind::Settle => false,
            EventKind::Slip | EventKind::Stick | EventKind::Reverse => is_decided,
            _ => true,
        };
        let each = |event: &Event| {
            let (t, kind) = (event.t, event.kind);
            event.supports.iter().map(move |support| (t, kind, (*support).to_owned())).collect::<Vec<_>>()
        };
        self.run.events().iter().filter(|event| counts(event.kind)).flat_map(each).collect()
    }

    pub fn stays_at_rest(&self) -> bool {
        (0..=8).all(|k| self.is_at_rest(self.run.end_time() * f64::from(k) / 8.0))
    }

    /// From when on the run itself says that the motion might be another.
    pub fn undecided_from(&self) -> f64 {
        undecided_from(&self.run)
    }

    /// Whether reactions or impulses are said not to be unique.
    pub fn has_unique_reactions(&self) -> bool {
        use LoggedDecision::{BearingChanged, ImpulsesNotUnique, MotionNotDetermined, ReactionsNotUnique};
        !self.run.log().iter().any(|entry| {
            matches!(
                entry.decision,
                ReactionsNotUnique | ImpulsesNotUnique | MotionNotDetermined | BearingChanged
            )
        })
    }
}

fn undecided_from(run: &Trajectory) -> f64 {
    let doubtful = run.log().iter().filter(|entry| is_doubtful(&entry.decision)).map(|entry| entry.t);
    let events = run.events().iter().filter(|event| event.is_undecided() || event.kind == EventKind::Settle);
    doubtful.chain(events.map(|event| event.t)).fold(f64::INFINITY, f64::min)
}

fn is_doubtful(decision: &LoggedDecision) -> bool {
    use LoggedDecision::{
        ConditionUndecided, FrictionAhead, GuardUnresolved, ImpactOrder, ImpulsesNotUnique,
        LandingUnresolved, LoadUnresolved, MotionNotDetermined, MotionsNotCounted, RestitutionScaled,
        SeveralImpacts, SeveralMotions,
    };
    matches!(
        decision,
        ConditionUndecided
            | FrictionAhead(_)
            | GuardUnresolved
            | ImpactOrder(_)
            | ImpulsesNotUnique
            | LandingUnresolved { .. }
            | LoadUnresolved
            | MotionNotDetermined
            | MotionsNotCounted
            | RestitutionScaled(_)
            | SeveralImpacts(_)
            | SeveralMotions { .. }
    )
}
