//! How far a parameter, a load say, may grow until an equilibrium is lost: it is followed from
//! value to value by steps that are halved where it is not found, until they are nothing: Newton's
//! method finds what is near only, and one step that fails is no end. At the end some contact bears
//! nothing more, or its friction is at its limit, or a mode begins to grow, or what held the system
//! has a fold.

use core::fmt;

use liftoff_core::model::ContactSet;
use liftoff_core::scalar::{DoubleDouble, Real};

use super::newton::equilibrium;
use super::search::{described, is_possible};
use super::{Equilibrium, Stability};
use crate::{AnalysisError, Subject};

/// The first step, in parts of the parameter or of 1 where it is 0.
const FIRST: f64 = 0.01;
const GROWTH: f64 = 1.25;
/// So many times its first size a parameter is let grow.
const MOST: f64 = 1e6;
/// The last step, in parts of the parameter, or of what is as small beside its first size.
const WIDTH: f64 = 1e-13;
const MOST_STEPS: usize = 2000;
/// A reaction below this part of the largest is lost at the limit, and a friction force nearer to
/// its limit slides.
const LOST: f64 = 1e-5;

/// The end of an equilibrium.
#[derive(Debug, Clone)]
pub struct LoadLimit {
    /// The largest value of the parameter, or the least where it falls.
    pub value: f64,
    /// The equilibrium there.
    pub rest: Equilibrium,
    /// What ends it.
    pub end: LimitEnd,
}

/// What ends an equilibrium.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum LimitEnd {
    /// These contacts bear nothing more, and open.
    Opens(Vec<&'static str>),
    /// The friction of these contacts is at its limit.
    Slides(Vec<&'static str>),
    /// A mode begins to grow.
    Unstable,
    /// There is none any more nearby: a fold.
    Fold,
    /// Nothing that is known: it has not been followed any farther.
    Unfollowed,
}

impl fmt::Display for LimitEnd {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Opens(contacts) => write!(f, "{} opens", contacts.join(", ")),
            Self::Slides(contacts) => write!(f, "{} slides", contacts.join(", ")),
            Self::Unstable => f.write_str("a mode begins to grow"),
            Self::Fold => f.write_str("there is no equilibrium any more"),
            Self::Unfollowed => f.write_str("it is not followed any farther"),
        }
    }
}

/// How far the equilibrium of a subject remains, by `subject` the subject with another value of the
/// parameter, from the value `from` on in the direction of `to`; none if it remains as far as that.
///
/// # Errors
/// There is no equilibrium to begin with; another value makes no model.
pub fn load_limit(
    subject: &dyn Fn(f64) -> Result<Subject, AnalysisError>,
    rest: &Equilibrium,
    [from, to]: [f64; 2],
) -> Result<Option<LoadLimit>, AnalysisError> {
    let first = subject(from)?;
    let supports: Vec<&str> = rest.closed.clone();
    let set = liftoff::contact_set(first.layout(), &supports)?;
    let set = first.sticking(set.union(first.layout().guides()));
    let mut state = first.state.clone();
    state.iter_mut().zip(&rest.positions).for_each(|(q, at)| *q = DoubleDouble::from_f64(*at));
    let begun = Begun { set, stable: !matches!(rest.stability(), Stability::Unstable(_)) };
    let unit = if from == 0.0 { 1.0 } else { from.abs() };
    let (mut value, mut step) = (from, FIRST * unit * (to - from).signum());
    let mut last = begun.follow(&first, &state)?.map_err(|_| AnalysisError::NotFound { tried: 1 })?;
    let mut lost: Option<Lost> = None;
    let mut has_failed = false;
    for _ in 0..MOST_STEPS {
        let next = if step.abs() >= (to - value).abs() { to } else { value + step };
        step = next - value;
        let is_last = step.abs() <= WIDTH * value.abs().max(WIDTH * unit);
        match begun.follow(&subject(next)?, &last.0)? {
            Ok(_) if next == to => return Ok(None),
            Ok(found) => {
                (value, last) = (next, found);
                step *= if has_failed { 0.5 } else { GROWTH };
                has_failed = false;
            }
            Err(by) => {
                (lost, has_failed) = (Some(by), true);
                step *= 0.5;
            }
        }
        match &lost {
            Some(lost) if is_last || value + step == value => {
                let end = match lost {
                    Some(LimitEnd::Fold) => LimitEnd::Fold,
                    otherwise => at_limit(&subject(value)?, &last, &supports)
                        .or_else(|| otherwise.clone())
                        .unwrap_or(LimitEnd::Fold),
                };
                return Ok(Some(LoadLimit { value, rest: last.1, end }));
            }
            _ if (value - from).abs() > MOST * unit => return Ok(None),
            _ => {}
        }
    }
    Ok(Some(LoadLimit { value, rest: last.1, end: LimitEnd::Unfollowed }))
}

/// What the equilibrium was to begin with.
struct Begun {
    set: ContactSet,
    stable: bool,
}

type Followed = (Vec<DoubleDouble>, Equilibrium);
/// What an equilibrium is lost by, if none of its contacts is at its limit; none where these cannot
/// hold it.
type Lost = Option<LimitEnd>;

impl Begun {
    /// The equilibrium of the same contacts near a state, or what it is lost by.
    fn follow(
        &self,
        subject: &Subject,
        state: &[DoubleDouble],
    ) -> Result<Result<Followed, Lost>, AnalysisError> {
        let found = equilibrium(subject, self.set, state, reach(subject, state))
            .filter(|state| is_possible(subject, state));
        let Some(state) = found else { return Ok(Err(Some(LimitEnd::Fold))) };
        let Some(rest) = described(subject, &state)? else { return Ok(Err(None)) };
        if self.stable && matches!(rest.stability(), Stability::Unstable(_)) {
            return Ok(Err(Some(LimitEnd::Unstable)));
        }
        Ok(Ok((state, rest)))
    }
}

/// How far Newton's method may go in a step, in its own: farther where the system has grown beyond
/// its natural length.
fn reach(subject: &Subject, state: &[DoubleDouble]) -> f64 {
    let lengths =
        subject.layout().coordinates.iter().zip(state).filter(|(coordinate, _)| !coordinate.is_angle);
    lengths.fold(1.0, |most: f64, (_, q)| most.max(q.hi().abs() / subject.scales.length))
}

/// Which of these contacts bear nothing, or else which are about to slide, if any are.
fn at_limit(subject: &Subject, (state, rest): &Followed, supports: &[&str]) -> Option<LimitEnd> {
    let largest = rest.loads.iter().fold(0.0, |most: f64, load| most.max(load.normal[1].abs()));
    let loads = || rest.loads.iter().filter(|load| supports.contains(&load.contact));
    let empty: Vec<&str> =
        loads().filter(|load| load.normal[1] <= LOST * largest).map(|load| load.contact).collect();
    if !empty.is_empty() {
        return Some(LimitEnd::Opens(empty));
    }
    let slides = loads().filter(|load| {
        let limit = subject.static_friction(load.contact, state);
        let Some((friction, limit)) = load.friction.zip(limit) else { return false };
        let force = friction[0].abs().min(friction[1].abs());
        force >= (1.0 - LOST) * limit * load.normal[0]
    });
    let slides: Vec<&str> = slides.map(|load| load.contact).collect();
    (!slides.is_empty()).then_some(LimitEnd::Slides(slides))
}
