//! What a run decided beside the events of its motion.

use core::fmt;

use crate::event::ImpactOrder;
use crate::expression::Condition;
use crate::integration::method::Choice;

/// A decision of the simulation that is no event of the motion.
#[derive(Debug, Clone, PartialEq)]
pub struct LogEntry {
    /// Time, s.
    pub t: f64,
    /// What was decided.
    pub decision: LoggedDecision,
}

/// What a run may decide.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum LoggedDecision {
    /// The pose of the start penetrates contacts by this much, m, within ten times the tolerance:
    /// they count as closed, and the pose moves onto them, by the square root of that where a gap
    /// has a fold.
    StartPenetrates(f64),
    /// The start moves by this much, relative to its largest position or rate, onto contacts that
    /// are closed to within the tolerance: more than that, since it is near a pose in which its
    /// gaps hardly depend on it.
    StartMoves(f64),
    /// The start is an equilibrium.
    StartRests,
    /// A condition that is to end the run holds at its start: it is met where it comes to hold
    /// again.
    ConditionHolds(Condition),
    /// A condition that was to end the run is not met in it.
    ConditionNotMet(Condition),
    /// A pivot of the closed form is small: the phase is integrated with multipliers.
    SmallPivot,
    /// The contacts are closed on another branch than that of the closed form: the phase is
    /// integrated with multipliers.
    OtherBranch,
    /// A gap, a reaction or a condition turns too often to be followed, however short the step: it
    /// is taken for noise, and from here to the end of its phase may be met late.
    GuardUnresolved,
    /// A contact has opened and strikes, its gap between zero but for what is not resolved: it may
    /// have come and gone since the phase began.
    LandingUnresolved {
        /// Label of the contact.
        contact: &'static str,
        /// When the phase began.
        since: f64,
    },
    /// A load varies so fast that no step, however short, is proved to have seen all of it: what it
    /// does within 1e-7 of a step may be missing.
    LoadUnresolved,
    /// A condition has a pole, and beside it perhaps a root that is nearer to it than their times
    /// are told apart: whether it is met there is not decided. Or it is zero but for rounding, or
    /// turns so often that it is not followed any farther. The first such place of a phase.
    ConditionUndecided,
    /// Another method integrates from here on.
    Method(Choice),
    /// A closed loop passes a singular position; the motion is continued along its branch.
    SingularPosition,
    /// Redundant supports: of the possible reactions the least-norm ones are given.
    ReactionsNotUnique,
    /// Redundant supports: a contact that bore is relieved by others that depend on it, and stays
    /// closed.
    BearingChanged,
    /// Friction lets several motions follow from a state (Painlevé's paradox): which, and why one
    /// of them is taken.
    SeveralMotions {
        /// What the contacts do in each.
        motions: Vec<String>,
        /// The one that is taken.
        taken: usize,
        /// What the one has that is taken.
        why: &'static str,
    },
    /// Redundant contacts slide with different friction: how they share their load decides how the
    /// system moves, and nothing decides that. One of the possible motions is taken.
    MotionNotDetermined,
    /// So many contacts with friction touch that one motion was looked for: that the law allows
    /// others is not excluded.
    MotionsNotCounted,
    /// The law of impact with friction allows so many outcomes; the first is taken: contacts in
    /// their order, sticking before sliding before open.
    SeveralImpacts(usize),
    /// Of the possible impulses the least-norm ones are given.
    ImpulsesNotUnique,
    /// The last impacts of a sequence were taken for one, in which sliding contacts gain this
    /// energy, J: until the sequence ends friction takes it again, where it would not have acted
    /// during the flights.
    FrictionAhead(f64),
    /// Restitution was scaled by this factor < 1: with all of it the impact would have gained
    /// energy.
    RestitutionScaled(f64),
    /// The outcome of simultaneous impacts depends on their order.
    ImpactOrder(ImpactOrder),
}

impl fmt::Display for LoggedDecision {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::SmallPivot => "a pivot of the closed form is small: the phase is integrated with multipliers",
            Self::OtherBranch => {
                "the contacts are closed on another branch than the closed form: the phase is integrated with multipliers"
            }
            Self::StartPenetrates(depth) => {
                return write!(f, "the start penetrates contacts by {depth:.1e}, within ten times the tolerance: its pose is moved onto them");
            }
            Self::StartMoves(by) => {
                return write!(f, "the start moves by {by:.1e} of its size onto contacts whose gaps hardly depend on it");
            }
            Self::StartRests => "the start is an equilibrium: it stays there, unless it is unstable and roundoff grows",
            Self::ConditionNotMet(condition) => {
                return write!(f, "the run ends here, and `{condition}` was not met");
            }
            Self::ConditionHolds(condition) => {
                return write!(
                    f,
                    "`{condition}` holds at the start: it is met when it becomes true again, and never if it stays true"
                );
            }
            Self::GuardUnresolved => {
                "a guard oscillates too often to be followed: it is treated as noise"
            }
            Self::LandingUnresolved { contact, since } => {
                return write!(
                    f,
                    "the gap of {contact} has been zero within its error since t = {since:.4}: the time at which it closes is undecided; try a smaller tolerance"
                );
            }
            Self::LoadUnresolved => "a load varies so fast here that no step provably resolves it",
            Self::ConditionUndecided => "undecided: a condition may be met here, beside a pole or within its error bound",
            Self::Method(Choice { method, why }) => return write!(f, "{method} goes on: {why}"),
            Self::SingularPosition => "a loop passes a singular position: the motion is continued along its branch",
            Self::SeveralMotions { motions, taken, why } => {
                let (count, all) = (motions.len(), motions.join("; "));
                return write!(
                    f,
                    "{count} motions satisfy the law of friction ({all}); taken is {}: the one {why}",
                    motions[*taken]
                );
            }
            Self::MotionNotDetermined => {
                "redundant contacts slide with different friction: the motion depends on how they share their load; one of the motions is taken"
            }
            Self::MotionsNotCounted => {
                "many contacts with friction touch: the first motion found that satisfies the law is taken; others are not sought"
            }
            Self::SeveralImpacts(count) => {
                return write!(f, "{count} outcomes satisfy the law of impact with friction; the first is taken");
            }
            Self::ReactionsNotUnique => "the reactions are not unique; the least-norm ones are given",
            Self::BearingChanged => "a contact loses its load to redundant ones; it stays closed",
            Self::ImpulsesNotUnique => "the impulses are not unique; the least-norm ones are given",
            Self::FrictionAhead(energy) => {
                return write!(
                    f,
                    "the last impacts are treated as one, which gains {energy:.3e} J; friction would dissipate it before they end"
                );
            }
            Self::RestitutionScaled(factor) => {
                return write!(f, "restitution is scaled by {factor:.3e}: energy would have been gained");
            }
            Self::ImpactOrder(order) => return order.fmt(f),
        })
    }
}
