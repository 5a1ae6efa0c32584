//! A contact set of one degree of freedom on an energy level: with `T = ½ M̂(q) q̇²` and the start
//! q₀, q̇₀
//!
//! ```text
//! ½ M̂(q) q̇² + V(q) = ½ M̂(q₀) q̇₀² + V(q₀)
//! q̇² = (2 (V(q₀) − V(q)) + M̂(q₀) q̇₀²)/M̂(q),   q̈ = (Q̂ − ĥ)/M̂,   ĥ = ½ M̂′ q̇²
//! ```
//!
//! A reaction is linear in q̈ and q̇², hence a function of q and of the start.

use liftoff_codegen::Analysis;
use liftoff_codegen::algebra::{Angle, Quotient, Rational, Series, Symbol, work};
use liftoff_codegen::phases::Phase;

use crate::error::ConditionError;
use crate::phase::Named;

/// Term operations for the energy level of a contact set.
const WORK: u64 = 20_000_000;

/// Longer formulas are read by nobody, and their common divisors take long.
const TERMS: usize = 400;

/// Where the motion begins.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Start {
    /// Anywhere, at rest.
    Rest,
    /// Anywhere, with any rate.
    Moving,
    /// At rest at so many quarter turns.
    Quarters(i64),
}

/// The motion on an energy level.
#[derive(Clone, Debug)]
pub(crate) struct Level {
    /// q.
    pub coordinate: Symbol,
    /// q₀, where it has no number.
    pub start: Symbol,
    /// q̇².
    pub rate_squared: Quotient,
    /// q̈.
    pub acceleration: Quotient,
    /// The reactions of one-sided contacts, by their rows.
    pub reactions: Vec<(usize, Quotient)>,
}

impl Level {
    /// # Errors
    /// More or less than one degree of freedom; an energy that is not conserved; roots.
    pub fn derive(analysis: &Analysis, phase: &Phase, start: Start) -> Result<Self, ConditionError> {
        let named = Named::new(analysis, phase);
        let coordinate = named.single_coordinate()?;
        named.conserves_energy()?;
        let level = work::limited(WORK, || level(analysis, phase, coordinate, start));
        let parts = [&level.rate_squared, &level.acceleration];
        let all = parts.into_iter().chain(level.reactions.iter().map(|(_, reaction)| reaction));
        let too_long = |quotient: &Quotient| quotient.is_overflow() || quotient.numerator().len() > TERMS;
        if all.into_iter().any(too_long) {
            return Err(ConditionError::Overflow { phase: named.title() });
        }
        if level.reactions.is_empty() {
            return Err(ConditionError::NoReaction { phase: named.title() });
        }
        Ok(level)
    }
}

/// The symbol of the start of a coordinate.
pub(crate) fn start_of(analysis: &Analysis, coordinate: usize, order: u8) -> Symbol {
    Symbol::Coordinate { index: (analysis.motion.n + coordinate) as u16, order }
}

fn level(analysis: &Analysis, phase: &Phase, index: usize, start: Start) -> Level {
    let coordinate = Symbol::coordinate(index);
    let [at, rate] = [0, 1].map(|order| start_of(analysis, index, order));
    let angle = match start {
        Start::Quarters(turns) => Angle::quarters(turns),
        Start::Rest | Start::Moving => Angle::from_symbol(at),
    };
    let mass = &phase.mass[0][0];
    let at_start = |quotient: &Quotient| quotient.substitute_angle(coordinate, &angle);
    let twice = Quotient::from(Series::integer(2));
    let fall = &(&at_start(&phase.potential) - &phase.potential) * &twice;
    let energy = match start {
        Start::Moving => &fall + &(&at_start(mass) * &Quotient::from(Series::symbol(rate).pow(2))),
        Start::Rest | Start::Quarters(_) => fall,
    };
    let rate_squared = &energy / mass;
    let on_level = |quotient: &Quotient| with_rate_squared(quotient, Symbol::rate(index), &rate_squared);
    let acceleration = &(&phase.forces[0] - &on_level(&phase.velocity_terms[0])) / mass;
    let one_sided = |row: usize| analysis.motion.contacts.get(row).is_some_and(|c| !c.two_sided && !c.driven);
    let reactions = phase.reactions.iter().filter(|(row, _)| one_sided(*row)).map(|(row, reaction)| {
        let reaction = reaction.substitute_quotient(Symbol::acceleration(index), &acceleration);
        (*row, on_level(&reaction))
    });
    Level {
        coordinate,
        start: at,
        reactions: reactions.collect(),
        rate_squared: rate_squared.clone(),
        acceleration,
    }
}

/// A value in place of the square of a rate; overflow where an odd power stands.
fn with_rate_squared(quotient: &Quotient, rate: Symbol, value: &Quotient) -> Quotient {
    let numerator = quotient.numerator();
    let below = quotient.factors().iter();
    let denominator = below.fold(Series::one(), |product, (factor, k)| product * factor.pow(*k));
    let (mut sum, mut power) = (Quotient::from(Series::zero()), Quotient::from(Series::one()));
    for k in 0..=numerator.degree(rate) {
        let coefficient = numerator.coefficient(rate, k);
        if k % 2 == 1 && !coefficient.is_zero() {
            return Quotient::from(Series::constant(Rational::OVERFLOW));
        }
        if k % 2 == 0 {
            sum += &Quotient::new(coefficient, denominator.clone()) * &power;
            power = &power * value;
        }
    }
    sum
}
