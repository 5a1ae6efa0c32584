//! Values of guards within a step.

use std::sync::Arc;

use super::{Guard, Rub};
use crate::contact::friction::LastMargin;
use crate::context::{Numbers, RunContext, Slips};
use crate::expression::{Condition, Enclosure, Interval, Known, Sides, Variable};
use crate::integrate::Guards;
use crate::integration::phase_point::PhasePoint;
use crate::model::{ContactSet, Form, Layout, Side, SlipState};
use crate::numerics::root_isolation::{GuardError, Smooth, TERMS};
use crate::system::{DenseOutput, Phase};
use smallvec::smallvec;

/// What a condition reads, over a step.
pub(super) type Leaves = Vec<(Variable, Smooth)>;

/// Which guards are asked for.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(crate) struct Kinds {
    pub(super) reactions: bool,
    pub(super) gaps: bool,
    pub(super) feet: bool,
    pub(super) slips: bool,
    pub(super) grip: bool,
}

impl Kinds {
    pub(super) fn of(guards: impl IntoIterator<Item = Guard>) -> Self {
        guards.into_iter().fold(Self::default(), |kinds, guard| match guard {
            Guard::Reaction(_) | Guard::Side(..) => Self { reactions: true, ..kinds },
            Guard::Gap(_) | Guard::Parting(_) => Self { gaps: true, ..kinds },
            Guard::Foot { .. } => Self { feet: true, ..kinds },
            Guard::Limit(_) => Self { reactions: true, slips: true, ..kinds },
            Guard::Grip => Self { reactions: true, grip: true, ..kinds },
            Guard::Slip(_) => Self { slips: true, ..kinds },
            Guard::Condition(_) => kinds,
        })
    }

    pub(super) fn any(self) -> bool {
        self.reactions || self.gaps || self.feet || self.slips || self.grip
    }
}

/// Values of all guards of a model at one time; those not asked for are left as they were.
#[derive(Default)]
pub(crate) struct Values {
    pub(super) reactions: Numbers,
    gaps: Numbers,
    feet: Numbers,
    pub(super) slips: Slips,
    grip: f64,
    last_grip: LastMargin,
    reduced: Numbers,
    pub(super) state: Numbers,
    /// A point of the phase, made when a condition is first evaluated.
    point: Option<PhasePoint>,
}

impl Values {
    pub(super) fn of(layout: &Layout) -> Self {
        let contacts = layout.contacts.len();
        Self {
            reactions: smallvec![0.0; layout.reactions()],
            gaps: smallvec![0.0; contacts],
            feet: smallvec![0.0; 2 * layout.feet()],
            slips: Slips::from_elem(
                SlipState { velocity: 0.0, kinetic: 0.0, limit: 0.0 },
                layout.frictions.len(),
            ),
            state: smallvec![0.0; layout.entries()],
            ..Self::default()
        }
    }

    /// NaN for a condition.
    pub(super) fn get(&self, guard: Guard) -> f64 {
        match guard {
            Guard::Reaction(i) => self.reactions[i],
            Guard::Gap(i) => self.gaps[i],
            Guard::Parting(i) => -self.gaps[i],
            Guard::Foot { entry, .. } => self.feet[entry],
            Guard::Side(i, side) => f64::from(side.sign()) * self.reactions[i],
            Guard::Limit(Rub { contact, friction, slip, side }) => {
                let force = self.reactions[self.gaps.len() + friction];
                let normal = f64::from(side.sign()) * self.reactions[contact];
                self.slips[friction].limit * normal + f64::from(slip.sign()) * force
            }
            Guard::Grip => self.grip,
            Guard::Slip(Rub { friction, slip, .. }) => f64::from(slip.sign()) * self.slips[friction].velocity,
            Guard::Condition(_) => f64::NAN,
        }
    }

    /// Distances of foot `k` from both ends of its bar.
    pub(super) fn margins(&self, k: usize) -> [f64; 2] {
        [self.feet[2 * k], self.feet[2 * k + 1]]
    }
}

/// A step of a phase, as the guards see it.
pub(crate) struct StepView<'a> {
    pub(super) phase: &'a Arc<dyn Phase>,
    /// The closed contacts: those of the phase, and those that depend on them.
    pub(super) closed: ContactSet,
    pub(super) context: &'a RunContext,
    pub(super) dense: &'a DenseOutput,
    /// The series of the guards: the method's own, or what the dense output makes of them.
    pub(super) guards: Option<Guards<'a>>,
    /// Whether they are the dense output's: what is known to vanish at the start does so only to within its error.
    is_fitted: bool,
    /// The entries of the full state that the dense output is a polynomial of; none where it is no step.
    kept: &'a [usize],
    /// Whether it is a step across a singular position.
    is_bridge: bool,
}

impl<'a> StepView<'a> {
    /// A step known by its dense output only.
    pub(crate) fn new(phase: &'a Arc<dyn Phase>, context: &'a RunContext, dense: &'a DenseOutput) -> Self {
        let closed = phase.info().set;
        Self { phase, closed, context, dense, guards: None, is_fitted: false, kept: &[], is_bridge: false }
    }

    /// The same with the contacts closed that depend on those of the phase.
    pub(crate) fn with_closed(self, closed: ContactSet) -> Self {
        Self { closed, ..self }
    }

    /// The same with series of the guards, if there are any.
    pub(crate) fn with_series(self, guards: Option<Guards<'a>>) -> Self {
        Self { guards, kept: self.phase.kept(), ..self }
    }

    /// The same where these are polynomials of the dense output, not the method's own series.
    pub(crate) fn with_fitted(self, is_fitted: bool) -> Self {
        Self { is_fitted, ..self }
    }

    pub(super) fn form(&self) -> Form {
        self.phase.info().form
    }

    pub(super) fn is_fitted(&self) -> bool {
        self.is_fitted
    }

    /// The same across a singular position: it cannot be made shorter, and reactions are not determined within.
    pub(crate) fn across(self) -> Self {
        Self { is_bridge: true, ..self }
    }

    pub(super) fn is_bridge(&self) -> bool {
        self.is_bridge
    }

    /// The reduced state at θ.
    pub(super) fn reduced(&self, theta: f64, reduced: &mut Vec<f64>) {
        reduced.resize(self.dense.entries(), 0.0);
        self.dense.at(theta, reduced);
    }

    /// Values of the guards of these kinds at θ.
    pub(super) fn sample(&self, theta: f64, kinds: Kinds, values: &mut Values) {
        let Values { reactions, gaps, feet, slips, grip, last_grip, reduced, state, .. } = values;
        reduced.resize(self.dense.entries(), 0.0);
        self.dense.at(theta, reduced);
        if kinds.reactions {
            self.phase.reactions(reduced, reactions);
        }
        if kinds.gaps || kinds.feet || kinds.slips || kinds.grip {
            self.phase.embed(reduced, state);
        }
        if kinds.gaps {
            self.phase.system().gaps(state, gaps);
        }
        if kinds.feet {
            self.phase.system().feet(state, feet);
        }
        if kinds.slips {
            self.phase.system().slips(state, slips);
        }
        if kinds.grip {
            *grip = last_grip.value(self.context.system(), state, &self.closed, reactions);
        }
    }

    /// What rounding makes of each gap at the end, if a coordinate of the phase has become so large that it may be more than `bound`.
    pub(super) fn roundings(&self, bound: f64, values: &mut Values) -> Option<Numbers> {
        let coordinates =
            self.phase.kept().iter().copied().zip(self.dense.end()).take(self.phase.info().coordinates);
        if !self.context.is_far(coordinates, bound) {
            return None;
        }
        self.phase.embed(self.dense.end(), &mut values.state);
        Some(self.context.roundings(&values.state, bound))
    }

    /// The size of the terms at the end that a gap is the sum of.
    pub(super) fn terms(&self, contact: usize, values: &mut Values) -> f64 {
        self.phase.embed(self.dense.end(), &mut values.state);
        let positions = &values.state[..self.context.layout().coordinates.len()];
        self.context.system().equations(&values.state).terms(contact, positions)
    }

    /// The difference of a condition's sides at θ, and the larger of them.
    pub(super) fn difference(&self, theta: f64, condition: &Condition, values: &mut Values) -> (f64, f64) {
        condition.difference(self.context, self.point(theta, values))
    }

    /// What rounding may make of the difference of a condition's sides at θ where they are equal; zero where that is no
    /// number.
    pub(super) fn rounding(&self, theta: f64, condition: &Condition, values: &mut Values) -> f64 {
        let rounding = condition.rounding(self.context, self.point(theta, values));
        if rounding.is_finite() { rounding } else { 0.0 }
    }

    fn point<'v>(&self, theta: f64, values: &'v mut Values) -> &'v PhasePoint {
        let t = self.dense.t0 + theta * self.dense.h;
        let reduced = || smallvec![0.0; self.dense.entries()];
        let begun = || PhasePoint::new(Arc::clone(self.phase), self.closed, t, reduced());
        let point = values.point.get_or_insert_with(begun);
        point.move_to(t, |reduced| self.dense.at(theta, reduced));
        point
    }

    /// g̈ of a contact at θ.
    pub(super) fn gap_acceleration(&self, theta: f64, contact: usize, values: &mut Values) -> f64 {
        let point = self.point(theta, values);
        let equations = self.phase.system().equations(point.state());
        equations.gap_acceleration(contact, point.accelerations())
    }

    /// The length of the step in time, and the natural acceleration.
    pub(super) fn scales(&self) -> (f64, f64) {
        (self.dense.h, self.context.scales.acceleration())
    }

    /// What a condition reads, at θ.
    pub(super) fn read(&self, theta: f64, variable: Variable, values: &mut Values) -> f64 {
        variable.value(self.context, self.point(theta, values))
    }

    /// Bounds of the difference of a condition's sides over a piece, from those of what it reads.
    pub(super) fn enclosure(
        &self,
        condition: &Condition,
        leaves: &Leaves,
        piece: [f64; 2],
    ) -> Option<Enclosure> {
        let leaf = |variable: Variable| {
            let (_, smooth) = leaves.iter().find(|(known, _)| *known == variable)?;
            let [value, slope] = [smooth.value(piece), smooth.slope(piece)];
            let around = |(middle, reach)| Interval::around(middle, reach);
            Some(Enclosure { value: around(value), slope: around(slope) })
        };
        condition.enclosure(&self.context.model.parameters, &leaf)
    }

    /// The series of a guard other than a condition, Σ cₖ θᵏ, if the method has it.
    pub(super) fn series(&self, guard: Guard) -> Option<&[f64]> {
        let guards = self.guards?;
        Some(match guard {
            Guard::Reaction(i) => guards.reaction(i),
            Guard::Gap(i) => guards.gap(i),
            Guard::Foot { entry, .. } => guards.foot(entry / 2, entry % 2),
            Guard::Side(i, Side::Positive) => guards.reaction(i),
            Guard::Side(_, Side::Negative)
            | Guard::Parting(_)
            | Guard::Limit(_)
            | Guard::Grip
            | Guard::Slip(_)
            | Guard::Condition(_) => return None,
        })
    }

    /// Where the reduced state has a coordinate or its rate, if it has it.
    fn place(&self, index: usize, order: usize) -> Option<usize> {
        let entry = index + order * self.context.layout().coordinates.len();
        self.kept.iter().position(|kept| *kept == entry)
    }

    /// What is a polynomial of the step itself; none for what has to be fitted.
    pub(super) fn polynomial(&self, variable: Variable) -> Option<Result<Smooth, GuardError>> {
        let mut terms = [0.0; TERMS];
        match variable {
            Variable::Time => (terms[0], terms[1]) = (self.dense.t0, self.dense.h),
            Variable::Coordinate { index, order } => {
                self.dense.polynomial(self.place(index, order)?, &mut terms)?;
            }
            _ => return None,
        }
        let degree = self.dense.degree().max(1);
        let at = |theta: f64| terms[..=degree].iter().rev().fold(0.0, |sum, c| sum * theta + c);
        // Of the sum, whose terms may be larger than it is.
        let rounding = 4.0 * f64::EPSILON * terms.iter().map(|c| c.abs()).sum::<f64>();
        Some(Smooth::polynomial(&mut |theta| at(theta), degree, rounding))
    }

    /// The series of a condition's sides, if they follow from those of what the method has: the motion itself is a polynomial.
    pub(super) fn sides(&self, condition: &Condition) -> Option<Sides> {
        condition.sides(&self.context.model.parameters, &|known, terms| match known {
            Known::Coordinate { index, order } => self.dense.polynomial(self.place(index, order)?, terms),
            // Where more contacts are closed than the phase needs, they share its reactions.
            Known::Reaction(_) if self.closed != self.phase.info().set => None,
            Known::Reaction(contact) => copy(self.guards?.reaction(contact), terms),
            Known::Gap(contact) => copy(self.guards?.gap(contact), terms),
            Known::Time => {
                (terms[0], terms[1]) = (self.dense.t0, self.dense.h);
                Some(())
            }
        })
    }
}

fn copy(series: &[f64], terms: &mut [f64]) -> Option<()> {
    series.iter().zip(terms).for_each(|(c, term)| *term = *c);
    Some(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::Slip;

    /// μₛ |N| + σ R of each of two contacts with friction, whose R stand behind the reactions of all contacts.
    #[test]
    fn limits_of_friction_are_those_of_their_contact() {
        let slips = [0.25, 0.5].map(|limit| SlipState { velocity: 0.0, kinetic: 0.0, limit });
        let values = Values {
            reactions: smallvec![-5.0, 7.0, 1.0, -3.0],
            gaps: smallvec![0.0; 2],
            slips: Slips::from_slice(&slips),
            ..Values::default()
        };
        let limit =
            |contact, slip, side| values.get(Guard::Limit(Rub { contact, friction: contact, slip, side }));
        assert_eq!(limit(0, Slip::Forward, Side::Negative), 0.25 * 5.0 + 1.0);
        assert_eq!(limit(0, Slip::Backward, Side::Negative), 0.25 * 5.0 - 1.0);
        assert_eq!(limit(1, Slip::Forward, Side::Positive), 0.5 * 7.0 - 3.0);
        assert_eq!(limit(1, Slip::Backward, Side::Positive), 0.5 * 7.0 + 3.0);
    }
}
