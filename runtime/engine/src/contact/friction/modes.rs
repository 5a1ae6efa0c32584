//! The modes of a contact, what each asks for, and what of it a next order has to decide.
//!
//! A condition that order 0 meets with a margin stays met for some time; one that is met with zero is asked of the first order
//! that does not vanish. So at each order a contact has some modes, each with the conditions that are still open:
//!
//! ```text
//! Open       g̈_N ≥ 0
//! Stick      λ_N ≥ 0,    μ_s λ_N − R ≥ 0,    μ_s λ_N + R ≥ 0         with  g̈_N = 0, v̇ = 0
//! Slide(σ)   λ_N ≥ 0,    σ v̇ ≥ 0 from rest                           with  g̈_N = 0, R = −σ μ λ_N
//! ```

use smallvec::{SmallVec, smallvec};

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

impl Choice {
    pub(super) fn asks(&self, condition: Condition) -> bool {
        self.conditions.contains(&condition)
    }
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
    /// The modes it may have.
    pub(crate) choices: Vec<Choice>,
}

impl Frictional {
    /// A contact that touches, with g = ġ = 0 and of its slip what is known.
    pub(crate) fn touching((normal, tangent): (usize, usize), (mu, limit): (f64, f64), slip: Slip) -> Self {
        Self { normal, tangent, mu, limit, choices: slip.choices() }
    }

    /// A contact whose mode is decided.
    pub(crate) fn decided((normal, tangent): (usize, usize), (mu, limit): (f64, f64), mode: Mode) -> Self {
        let choices = vec![Choice { mode, conditions: SmallVec::new() }];
        Self { normal, tangent, mu, limit, choices }
    }

    /// Whether there is nothing left to be decided.
    pub(crate) fn is_decided(&self) -> bool {
        self.choices.len() == 1 && self.choices[0].conditions.is_empty()
    }

    /// The same with only some of its modes.
    pub(crate) fn without(mut self, mode: Mode) -> Self {
        self.choices.retain(|choice| choice.mode != mode);
        self
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
