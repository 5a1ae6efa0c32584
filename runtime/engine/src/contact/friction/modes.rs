//! The modes of a contact, what each asks for, and what of it a next order has to decide.
//!
//! A condition that order 0 meets with a margin stays met for some time; one that is met with zero
//! is asked of the first order that does not vanish. So at each order a contact has some modes,
//! each with the conditions that are still open:
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
pub(crate) enum SlipDirection {
    /// σ = 1.
    Forward,
    /// σ = −1.
    Backward,
}

impl SlipDirection {
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
pub(crate) enum ContactMode {
    /// Without force.
    Open,
    /// Closed without slip; a contact without friction that is closed has this mode too.
    Stick,
    /// Closed with a slip, or about to.
    Slide(SlipDirection),
    /// A guide that presses to a side, without slip or with one.
    Guide {
        /// The side.
        side: Side,
        /// The sense of its slip, if it slips.
        sense: Option<SlipDirection>,
    },
    /// Open with no more than the normal impulse that is given, which rubs: without slip, or with
    /// one. In impacts alone.
    Part(Option<SlipDirection>),
}

/// What is known of a contact's slip velocity v.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum SlipVelocity {
    /// v > 0.
    Forward,
    /// v < 0.
    Backward,
    /// v = 0.
    Rest,
    /// v = 0, and the force of sticking was located at its limit: it slides in this sense or opens,
    /// be its slip acceleration zero but for rounding.
    Leaves(SlipDirection),
}

/// An inequality of a mode.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum ModeCondition {
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
pub(crate) struct ModeChoice {
    pub(crate) mode: ContactMode,
    pub(crate) conditions: SmallVec<[ModeCondition; 3]>,
}

impl ContactMode {
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
            Self::Slide(SlipDirection::Forward) => "sliding forward",
            Self::Slide(SlipDirection::Backward) => "sliding backward",
            Self::Guide { side: Side::Positive, sense: None } => "sticking with N > 0",
            Self::Guide { side: Side::Positive, sense: Some(SlipDirection::Forward) } => {
                "sliding forward with N > 0"
            }
            Self::Guide { side: Side::Positive, sense: Some(SlipDirection::Backward) } => {
                "sliding backward with N > 0"
            }
            Self::Guide { side: Side::Negative, sense: None } => "sticking with N < 0",
            Self::Guide { side: Side::Negative, sense: Some(SlipDirection::Forward) } => {
                "sliding forward with N < 0"
            }
            Self::Guide { side: Side::Negative, sense: Some(SlipDirection::Backward) } => {
                "sliding backward with N < 0"
            }
            Self::Part(_) => "parting",
        }
    }

    /// The same of a contact without friction.
    pub(crate) fn describe_smooth(self) -> &'static str {
        if self.is_closed() { "closed" } else { "open" }
    }

    pub(super) fn sense(self) -> Option<SlipDirection> {
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

impl ModeChoice {
    /// The same of a guide that presses to a side; none of an open contact.
    fn on(self, side: Side) -> Option<Self> {
        let sense = self.mode.sense();
        (self.mode != ContactMode::Open).then_some(Self { mode: ContactMode::Guide { side, sense }, ..self })
    }

    pub(super) fn asks(&self, condition: ModeCondition) -> bool {
        self.conditions.contains(&condition)
    }
}

/// The most that friction bears, `slope λ_N + offset`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Bound {
    pub(crate) slope: f64,
    pub(crate) offset: f64,
}

/// Bounds of friction while an impulse is given: `−forward ≤ R ≤ backward`, the first one reached
/// where the contact slips forward.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ImpulseBounds {
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
    pub(crate) given: Option<ImpulseBounds>,
    /// The modes it may have.
    pub(crate) choices: Vec<ModeChoice>,
}

impl Frictional {
    /// A contact that touches, with g = ġ = 0 and of its slip what is known.
    pub(crate) fn touching(
        (normal, tangent): (usize, usize),
        (mu, limit): (f64, f64),
        slip: SlipVelocity,
    ) -> Self {
        Self { normal, tangent, mu, limit, given: None, choices: slip.choices() }
    }

    /// A guide, of its slip what is known.
    pub(crate) fn guide(
        (normal, tangent): (usize, usize),
        (mu, limit): (f64, f64),
        slip: SlipVelocity,
    ) -> Self {
        let sides = [Side::Positive, Side::Negative].into_iter();
        let choices = sides.flat_map(|side| slip.choices().into_iter().filter_map(move |it| it.on(side)));
        Self { normal, tangent, mu, limit, given: None, choices: choices.collect() }
    }

    /// A contact whose mode is decided.
    pub(crate) fn decided(
        (normal, tangent): (usize, usize),
        (mu, limit): (f64, f64),
        mode: ContactMode,
    ) -> Self {
        let choices = vec![ModeChoice { mode, conditions: SmallVec::new() }];
        Self { normal, tangent, mu, limit, given: None, choices }
    }

    /// A contact with a normal impulse that it is given, which rubs within some bounds.
    pub(crate) fn given((normal, tangent): (usize, usize), given: ImpulseBounds) -> Self {
        let part = |sense: Option<SlipDirection>| ModeChoice {
            mode: ContactMode::Part(sense),
            conditions: match sense {
                None => smallvec![ModeCondition::Opens, ModeCondition::Below, ModeCondition::Above],
                Some(_) => smallvec![ModeCondition::Opens, ModeCondition::Slips],
            },
        };
        let mut choices = SlipVelocity::Rest.choices();
        choices.retain(|choice| choice.mode != ContactMode::Open);
        choices.extend([None, Some(SlipDirection::Forward), Some(SlipDirection::Backward)].map(part));
        let [mu, limit] = [given.backward.slope; 2];
        Self { normal, tangent, mu, limit, given: Some(given), choices }
    }

    /// Whether there is nothing left to be decided.
    pub(crate) fn is_decided(&self) -> bool {
        self.choices.len() == 1 && self.choices[0].conditions.is_empty()
    }
}

impl SlipVelocity {
    /// The modes that are possible, larger ones first.
    fn choices(self) -> Vec<ModeChoice> {
        let open = ModeChoice { mode: ContactMode::Open, conditions: smallvec![ModeCondition::Opens] };
        let moving = |sense| ModeChoice {
            mode: ContactMode::Slide(sense),
            conditions: smallvec![ModeCondition::Presses],
        };
        let starting = |sense| ModeChoice {
            mode: ContactMode::Slide(sense),
            conditions: smallvec![ModeCondition::Presses, ModeCondition::Slips],
        };
        let leaving = |sense| ModeChoice {
            mode: ContactMode::Slide(sense),
            conditions: smallvec![ModeCondition::Presses, ModeCondition::Follows],
        };
        let stick = ModeChoice {
            mode: ContactMode::Stick,
            conditions: smallvec![ModeCondition::Presses, ModeCondition::Below, ModeCondition::Above],
        };
        match self {
            Self::Forward => vec![moving(SlipDirection::Forward), open],
            Self::Backward => vec![moving(SlipDirection::Backward), open],
            Self::Leaves(sense) => vec![leaving(sense), open],
            Self::Rest => {
                vec![stick, starting(SlipDirection::Forward), starting(SlipDirection::Backward), open]
            }
        }
    }
}

/// The modes of a contact without friction, or of a rough one.
pub(super) fn smooth_choices() -> Vec<ModeChoice> {
    vec![
        ModeChoice { mode: ContactMode::Stick, conditions: smallvec![ModeCondition::Presses] },
        ModeChoice { mode: ContactMode::Open, conditions: smallvec![ModeCondition::Opens] },
    ]
}
