//! What there is to say of an event beside its kind, its supports and its state.

use core::fmt;

use crate::expression::Condition;

/// What there is to say of an event.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Note {
    /// The state is that before the impact of contacts that the start's rates close.
    BeforeImpact,
    /// It is a gap that touches zero, not a reaction.
    GapTouches,
    /// A gap that touches zero may as well have closed, for all that the tolerance tells.
    GapUndecided,
    /// A reaction that touches zero may as well have crossed it, for all that the tolerance tells.
    Undecided,
    /// The impacts have come to their end at a time known to within this, s.
    TimeWithin(f64),
    /// The condition that is met.
    Condition(Condition),
    /// The impulses that were applied, N s, each with its point.
    Impulses(Vec<(&'static str, [f64; 2])>),
    /// The outcome of the simultaneous impacts depends on their order.
    ImpactOrder(ImpactOrder),
    /// The law of impact has gained this energy, J: Newton's may where there is friction, Poisson's
    /// by that of a guide.
    EnergyGained(f64),
    /// No reaction obeys the law of friction (Painlevé's paradox): an impulse at these contacts,
    /// with ġ = 0, has ended the slip.
    WithoutCollision,
    /// The friction force of a contact that sticks touches its limit.
    LimitTouches,
    /// The slip velocity of a contact touches zero.
    SlipTouches,
    /// The forces of contacts with friction after the event, and the limits that decided it.
    Friction(Vec<FrictionState>),
}

/// The forces of a contact with friction.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct FrictionState {
    /// The contact's label.
    pub contact: &'static str,
    /// N, the reaction.
    pub normal: f64,
    /// R, the friction force along the tangent.
    pub force: f64,
    /// μₛ: |R|/N that it reached where it slides from here on, and that it stays below where it
    /// sticks.
    pub limit: f64,
    /// Whether it slides from here on.
    pub slides: bool,
    /// It sticks, and its force is at the limit but for the error of the motion: it might as well
    /// slide.
    pub undecided: bool,
}

/// Contacts of which simultaneous impacts end otherwise if they come one after the other.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct ImpactOrder {
    /// Pairs of contacts with the kinetic angle between them, rad.
    pub pairs: Vec<([&'static str; 2], f64)>,
}

impl ImpactOrder {
    /// Whether it is of the same contacts as another.
    pub(crate) fn is_same(&self, other: &Self) -> bool {
        let [own, others] = [self, other].map(|order| order.pairs.iter().map(|(contacts, _)| contacts));
        own.eq(others)
    }
}

impl fmt::Display for Note {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::BeforeImpact => f.write_str("before the impact"),
            Self::GapTouches => f.write_str("the gap touches zero"),
            Self::GapUndecided => f.write_str("the gap touches zero, undecided"),
            Self::Undecided => f.write_str("undecided"),
            Self::TimeWithin(error) => write!(f, "the time is known to {error:.0e}"),
            Self::Condition(condition) => condition.fmt(f),
            Self::Impulses(all) => {
                listed(f, all, |f, (point, [x, y])| write!(f, "({x}, {y}) N s at {point}"))
            }
            Self::ImpactOrder(order) => order.fmt(f),
            Self::EnergyGained(energy) => write!(f, "the law of impact gains {energy:.4e} J"),
            Self::WithoutCollision => {
                f.write_str("impact without collision: no reaction obeys the law of friction while it slides")
            }
            Self::LimitTouches => f.write_str("the friction force touches its limit"),
            Self::SlipTouches => f.write_str("the slip velocity touches zero"),
            Self::Friction(all) => listed(f, all, |f, state| state.fmt(f)),
        }
    }
}

impl fmt::Display for FrictionState {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { contact, normal, force, limit, slides, undecided } = *self;
        let ratio = if force == 0.0 { 0.0 } else { (force / normal).abs() };
        match slides {
            true => write!(f, "|R|/N reached {limit} at {contact}, now {ratio:.4}"),
            false if undecided => write!(f, "|R|/N = {limit} at {contact}, undecided"),
            false => write!(f, "|R|/N = {ratio:.4} of {limit} at {contact}"),
        }
    }
}

impl fmt::Display for ImpactOrder {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the order of the impacts matters: kinetic angle of ")?;
        listed(f, &self.pairs, |f, ([a, b], angle)| write!(f, "{a} and {b} at {:.4}°", angle.to_degrees()))
    }
}

/// Separated by commas.
fn listed<T>(
    f: &mut fmt::Formatter<'_>,
    all: &[T],
    one: impl Fn(&mut fmt::Formatter<'_>, &T) -> fmt::Result,
) -> fmt::Result {
    for (i, entry) in all.iter().enumerate() {
        if i > 0 {
            f.write_str(", ")?;
        }
        one(f, entry)?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Reports, pages and files have these words.
    #[test]
    fn notes_have_their_words() {
        let pairs = vec![(["A", "C"], core::f64::consts::FRAC_PI_3), (["A, E", "B"], core::f64::consts::PI)];
        let friction = |contact, [normal, force, limit]: [f64; 3], slides| FrictionState {
            contact,
            normal,
            force,
            limit,
            slides,
            undecided: false,
        };
        let (slides, bears_none) =
            (friction("P", [4.0, -1.0, 0.5], true), friction("Q", [0.0, 0.0, 0.5], false));
        for (note, words) in [
            (
                Note::Friction(vec![slides, bears_none]),
                "|R|/N reached 0.5 at P, now 0.2500, |R|/N = 0.0000 of 0.5 at Q",
            ),
            (
                Note::Friction(vec![FrictionState {
                    undecided: true,
                    ..friction("P", [4.0, 2.0, 0.5], false)
                }]),
                "|R|/N = 0.5 at P, undecided",
            ),
            (Note::BeforeImpact, "before the impact"),
            (Note::GapTouches, "the gap touches zero"),
            (Note::GapUndecided, "the gap touches zero, undecided"),
            (Note::Undecided, "undecided"),
            (Note::TimeWithin(0.00123), "the time is known to 1e-3"),
            (
                Note::Impulses(vec![("P", [1.5, -2.0]), ("Q", [0.0, 1.0])]),
                "(1.5, -2) N s at P, (0, 1) N s at Q",
            ),
            (
                Note::ImpactOrder(ImpactOrder { pairs }),
                "the order of the impacts matters: kinetic angle of A and C at 60.0000°, A, E and B at 180.0000°",
            ),
        ] {
            assert_eq!(note.to_string(), words);
        }
    }
}
