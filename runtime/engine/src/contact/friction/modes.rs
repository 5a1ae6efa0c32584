//! The modes of a contact, what each asks for, and what of it a next order has to decide.
//!
//! A condition that order 0 meets with a margin stays met for some time; one that is met with zero is asked of the first order
//! that does not vanish. So at each order a contact has some modes, each with the conditions that are still open:
//!
//! ```text
//! Open       g̈_N ≥ 0
//! Stick      λ_N ≥ 0,    μ_s λ_N − R ≥ 0,    μ_s λ_N + R ≥ 0         with  g̈_N = 0, v̇ = 0
//! Slide(σ)   λ_N ≥ 0,    σ v̇ ≥ 0 from rest                         with  g̈_N = 0, R = −σ μ λ_N
//! ```
//!
//! A guide is never open; it sticks or slides on either side, with s λ_N for λ_N, s = ±1.

use smallvec::{SmallVec, smallvec};

use crate::model::Side;

/// The direction of a slip along the tangent.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) enum Sense {
    /// σ = 1.
    Forward,
    /// σ = −1.
    Backward,
}

impl Sense {
    /// σ.
    pub(crate) fn sign(self) -> f64 {
        match self {
            Self::Forward => 1.0,
            Self::Backward => -1.0,
        }
    }
}

/// What a contact does.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) enum Mode {
    /// Without force.
    Open,
    /// Closed without slip; a contact without friction that is closed has this mode too.
    Stick,
    /// Closed with a slip, or about to.
    Slide(Sense),
    /// A guide that presses to a side, without slip or with one.
    Guide {
        /// The side.
        side: Side,
        /// The sense of its slip, if it slips.
        sense: Option<Sense>,
    },
    /// Open with no more than the normal impulse that is given, which rubs: without slip, or with one. In impacts alone.
    Part(Option<Sense>),
}

/// What is known of a contact's slip velocity v.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Slip {
    /// v > 0.
    Forward,
    /// v < 0.
    Backward,
    /// v = 0.
    Rest,
    /// v = 0, and the force of sticking was located at its limit: it slides in this sense or opens, be its slip acceleration zero
    /// but for rounding.
    Leaves(Sense),
}

/// An inequality of a mode.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Condition {
    /// g̈_N ≥ 0.
    Opens,
    /// λ_N ≥ 0.
    Presses,
    /// μ_s λ_N − R ≥ 0.
    Below,
    /// μ_s λ_N + R ≥ 0.
    Above,
    /// σ v̇ ≥ 0.
    Slips,
    /// The same up to the error of a located event; no higher order asks for it again.
    Follows,
}

/// A mode with the conditions that the order at hand decides.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Choice {
    pub(crate) mode: Mode,
    pub(crate) conditions: SmallVec<[Condition; 3]>,
}

impl Mode {
    /// Whether the normal's row is closed.
    pub(super) fn is_closed(self) -> bool {
        matches!(self, Self::Stick | Self::Slide(_) | Self::Guide { .. })
    }

    /// Whether the tangent's row is.
    pub(in crate::contact) fn holds_tangent(self) -> bool {
        matches!(self, Self::Stick | Self::Guide { sense: None, .. } | Self::Part(None))
    }

    /// In words.
    pub(crate) fn describe(self) -> &'static str {
        match self {
            Self::Open => "open",
            Self::Stick => "sticking",
            Self::Slide(Sense::Forward) => "sliding forward",
            Self::Slide(Sense::Backward) => "sliding backward",
            Self::Guide { side: Side::Positive, sense: None } => "sticking with N > 0",
            Self::Guide { side: Side::Positive, sense: Some(Sense::Forward) } => "sliding forward with N > 0",
            Self::Guide { side: Side::Positive, sense: Some(Sense::Backward) } => {
                "sliding backward with N > 0"
            }
            Self::Guide { side: Side::Negative, sense: None } => "sticking with N < 0",
            Self::Guide { side: Side::Negative, sense: Some(Sense::Forward) } => "sliding forward with N < 0",
            Self::Guide { side: Side::Negative, sense: Some(Sense::Backward) } => {
                "sliding backward with N < 0"
            }
            Self::Part(_) => "parting",
        }
    }

    /// The same of a contact without friction.
    pub(crate) fn told_smooth(self) -> &'static str {
        if self.is_closed() { "closed" } else { "open" }
    }

    pub(super) fn sense(self) -> Option<Sense> {
        match self {
            Self::Slide(sense) | Self::Part(Some(sense)) => Some(sense),
            Self::Guide { sense, .. } => sense,
            Self::Open | Self::Stick | Self::Part(None) => None,
        }
    }

    /// s of the side that it presses to: s λ_N ≥ 0.
    pub(super) fn side(self) -> f64 {
        if let Self::Guide { side, .. } = self { f64::from(side.sign()) } else { 1.0 }
    }
}

impl Choice {
    /// The same of a guide that presses to a side; none of an open contact.
    fn on(self, side: Side) -> Option<Self> {
        let sense = self.mode.sense();
        (self.mode != Mode::Open).then_some(Self { mode: Mode::Guide { side, sense }, ..self })
    }

    pub(super) fn asks(&self, condition: Condition) -> bool {
        self.conditions.contains(&condition)
    }
}

/// The most that friction bears, `slope λ_N + offset`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Bound {
    pub(crate) slope: f64,
    pub(crate) offset: f64,
}

/// Bounds of friction while an impulse is given: `−forward ≤ R ≤ backward`, the first one reached where the contact slips
/// forward.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Given {
    pub(crate) forward: Bound,
    pub(crate) backward: Bound,
}

/// A contact with friction: a normal row with a tangent row.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Frictional {
    /// The row of the normal.
    pub(crate) normal: usize,
    /// The row of the tangent.
    pub(crate) tangent: usize,
    /// μ while it slides.
    pub(crate) mu: f64,
    /// μ_s ≥ μ while it sticks.
    pub(crate) limit: f64,
    /// Bounds instead of these, in impacts.
    pub(crate) given: Option<Given>,
    /// The modes it may have.
    pub(crate) choices: Vec<Choice>,
}

impl Frictional {
    /// A contact that touches, with g = ġ = 0 and of its slip what is known.
    pub(crate) fn touching((normal, tangent): (usize, usize), (mu, limit): (f64, f64), slip: Slip) -> Self {
        Self { normal, tangent, mu, limit, given: None, choices: slip.choices() }
    }

    /// A guide, of its slip what is known.
    pub(crate) fn guide((normal, tangent): (usize, usize), (mu, limit): (f64, f64), slip: Slip) -> Self {
        let sides = [Side::Positive, Side::Negative].into_iter();
        let choices = sides.flat_map(|side| slip.choices().into_iter().filter_map(move |it| it.on(side)));
        Self { normal, tangent, mu, limit, given: None, choices: choices.collect() }
    }

    /// A contact whose mode is decided.
    pub(crate) fn decided((normal, tangent): (usize, usize), (mu, limit): (f64, f64), mode: Mode) -> Self {
        let choices = vec![Choice { mode, conditions: SmallVec::new() }];
        Self { normal, tangent, mu, limit, given: None, choices }
    }

    /// A contact with a normal impulse that it is given, which rubs within some bounds.
    pub(crate) fn given((normal, tangent): (usize, usize), given: Given) -> Self {
        let part = |sense: Option<Sense>| Choice {
            mode: Mode::Part(sense),
            conditions: match sense {
                None => smallvec![Condition::Opens, Condition::Below, Condition::Above],
                Some(_) => smallvec![Condition::Opens, Condition::Slips],
            },
        };
        let mut choices = Slip::Rest.choices();
        choices.retain(|choice| choice.mode != Mode::Open);
        choices.extend([None, Some(Sense::Forward), Some(Sense::Backward)].map(part));
        let [mu, limit] = [given.backward.slope; 2];
        Self { normal, tangent, mu, limit, given: Some(given), choices }
    }

    /// Whether there is nothing left to be decided.
    pub(crate) fn is_decided(&self) -> bool {
        self.choices.len() == 1 && self.choices[0].conditions.is_empty()
    }
}

impl Slip {
    /// The modes that are possible, larger ones first.
    fn choices(self) -> Vec<Choice> {
        let open = Choice { mode: Mode::Open, conditions: smallvec![Condition::Opens] };
        let moving = |sense| Choice { mode: Mode::Slide(sense), conditions: smallvec![Condition::Presses] };
        let starting = |sense| Choice {
            mode: Mode::Slide(sense),
            conditions: smallvec![Condition::Presses, Condition::Slips],
        };
        let leaving = |sense| Choice {
            mode: Mode::Slide(sense),
            conditions: smallvec![Condition::Presses, Condition::Follows],
        };
        let stick = Choice {
            mode: Mode::Stick,
            conditions: smallvec![Condition::Presses, Condition::Below, Condition::Above],
        };
        match self {
            Self::Forward => vec![moving(Sense::Forward), open],
            Self::Backward => vec![moving(Sense::Backward), open],
            Self::Leaves(sense) => vec![leaving(sense), open],
            Self::Rest => vec![stick, starting(Sense::Forward), starting(Sense::Backward), open],
        }
    }
}

/// The modes of a contact without friction, or of a rough one.
pub(super) fn smooth_choices() -> Vec<Choice> {
    vec![
        Choice { mode: Mode::Stick, conditions: smallvec![Condition::Presses] },
        Choice { mode: Mode::Open, conditions: smallvec![Condition::Opens] },
    ]
}
