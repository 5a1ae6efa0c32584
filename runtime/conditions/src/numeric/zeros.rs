//! Where reactions vanish for given parameters on a given energy level, and which of them vanishes
//! first.

use liftoff_codegen::algebra::Symbol;
use num_traits::{ToPrimitive, Zero as _};

use crate::algebra::form::Form;
use crate::algebra::ring::Ring;
use crate::numeric::chart::{Charted, Place};
use crate::numeric::values::Values;
use crate::numeric::way::Way;

/// A zero of a reaction, reached by the motion or not.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Zero {
    /// The coordinate, rad (within (−π, π]) or length.
    pub at: f64,
    /// How often it is one: 2 where the reaction only touches zero.
    pub multiplicity: u32,
}

/// Where a reaction is stationary.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stationary {
    /// The coordinate.
    pub at: f64,
    /// The reaction there.
    pub reaction: f64,
}

/// The first event of the motion in one direction.
#[derive(Clone, Debug, PartialEq)]
pub enum First {
    /// These contacts open.
    Opens {
        /// Where.
        at: f64,
        /// Their labels.
        contacts: Vec<String>,
    },
    /// The motion comes to rest, and goes back if it can.
    Rests {
        /// Where.
        at: f64,
    },
    /// It goes round for ever.
    Never,
}

/// Numbers on an energy level.
#[derive(Clone, Debug, PartialEq)]
pub struct Numbers {
    /// The start.
    pub start: f64,
    /// The zeros of each reaction, by its label.
    pub zeros: Vec<(String, Vec<Zero>)>,
    /// Where each is stationary: least, greatest or level.
    pub stationary: Vec<(String, Vec<Stationary>)>,
    /// What comes first with the coordinate falling, then with it rising; none where the motion
    /// does not go.
    pub first: [Option<First>; 2],
}

/// A function of the coordinate alone.
pub(super) struct Function {
    pub above: Charted,
    pub below: Charted,
}

impl Function {
    pub fn signs_about(&self, place: &Place) -> [i32; 2] {
        let [above, below] = [&self.above, &self.below].map(|part| part.signs_about(place));
        [above[0] * below[0], above[1] * below[1]]
    }

    fn zeros(&self) -> Vec<Zero> {
        let zeros = self.above.zeros().into_iter();
        zeros.map(|(place, multiplicity)| Zero { at: place.value(), multiplicity }).collect()
    }
}

/// A reaction as a function of the coordinate, with its derivative.
pub(crate) struct Reaction<'a> {
    pub label: String,
    pub form: &'a Form,
    pub slope: Form,
}

/// What numbers are asked of.
pub(crate) struct OnLevel<'a> {
    pub ring: &'a Ring,
    pub values: &'a Values,
    pub coordinate: Symbol,
    pub start: &'a Place,
    pub rate_squared: &'a Form,
    pub reactions: Vec<Reaction<'a>>,
}

impl OnLevel<'_> {
    fn function(&self, form: &Form) -> Option<Function> {
        let [above, below] = form
            .expanded(self.ring)
            .map(|p| Charted::substitute(self.ring, self.values, self.coordinate, &p));
        Some(Function { above: above?, below: below? })
    }

    /// `None` where the coordinate stands beside its own sine or cosine.
    pub fn numbers(&self) -> Option<Numbers> {
        let rate = self.function(self.rate_squared)?;
        let functions = self.reactions.iter().map(|r| Some((r.label.clone(), self.function(r.form)?)));
        let functions = functions.collect::<Option<Vec<(String, Function)>>>()?;
        let turning = rate.above.without(self.start);
        let first = |rising| Way { start: self.start, rising }.first(&functions, &turning);
        let [falls, rises] = rate.signs_about(self.start).map(|sign| sign > 0);
        let zeros = functions.iter().map(|(label, of)| (label.clone(), of.zeros()));
        let stationary = self.reactions.iter().map(|r| Some((r.label.clone(), self.stationary(r)?)));
        Some(Numbers {
            start: self.start.value(),
            first: [falls.then(|| first(false)), rises.then(|| first(true))],
            zeros: zeros.collect(),
            stationary: stationary.collect::<Option<_>>()?,
        })
    }

    fn stationary(&self, reaction: &Reaction) -> Option<Vec<Stationary>> {
        let slope = self.function(&reaction.slope)?;
        let places = slope.above.zeros().into_iter().map(|(place, _)| place);
        let value = |place: &Place| {
            let values = self.values.with(self.coordinate, place);
            let [above, below] = reaction.form.expanded(self.ring).map(|p| values.value(self.ring, &p));
            if below.is_zero() { f64::NAN } else { (above / below).to_f64().unwrap_or(f64::NAN) }
        };
        let all = places.map(|place| Stationary { at: place.value(), reaction: value(&place) });
        Some(all.filter(|stationary| stationary.reaction.is_finite()).collect())
    }
}
