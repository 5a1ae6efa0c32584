//! A phase at one time.

use crate::friction::slips;
use crate::kinematic::Kinematic;
use crate::model::{ReplayModel, ReplayPhase};
use crate::{Number, arithmetic};
use liftoff::__private::event::{FrictionGuard, Guard};
use liftoff::__private::expression::{Environment, Function, Operator, Variable};
use liftoff::{Condition, Output};
use liftoff_core::model::{Side, SlipState};

/// What cannot be evaluated on these numbers.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct Unsupported(pub(crate) &'static str);

/// A state of a phase at a time.
pub(crate) struct Instant<'a, S: Number> {
    model: &'a ReplayModel<S>,
    phase: &'a ReplayPhase<S>,
    t: S,
    reduced: &'a [S],
    /// The full state.
    state: Vec<S>,
}

impl<'a, S: Number> Instant<'a, S> {
    pub(crate) fn new(model: &'a ReplayModel<S>, phase: &'a ReplayPhase<S>, t: S, reduced: &'a [S]) -> Self {
        Self { model, phase, t, reduced, state: phase.embed(reduced) }
    }

    /// The value of a guard.
    pub(crate) fn guard(&self, guard: Guard, conditions: &[Condition]) -> Result<S, Unsupported> {
        Ok(match guard {
            Guard::Reaction(i) => self.phase.reactions(self.reduced)[i],
            Guard::Side(i, side) => signed::<S>(side) * self.phase.reactions(self.reduced)[i],
            Guard::Gap(i) => self.kinematic().gap(i),
            Guard::RedundantGap(i) => -self.kinematic().gap(i),
            Guard::Foot { entry, .. } => self.foot(entry),
            Guard::Limit(rub) => {
                let reactions = self.phase.reactions(self.reduced);
                let force = reactions[self.model.layout().contacts.len() + rub.friction];
                self.slip(rub).limit * signed::<S>(rub.side) * reactions[rub.contact] + sign::<S>(rub) * force
            }
            Guard::SharedFriction => {
                return Err(Unsupported("the limit load of contacts that share their load"));
            }
            Guard::Slip(rub) => sign::<S>(rub) * self.slip(rub).velocity,
            Guard::Condition(k) => {
                let [left, right] = conditions[k].values(self)?;
                left - right
            }
        })
    }

    /// The value of an output.
    pub(crate) fn output(&self, output: &Output) -> Result<S, Unsupported> {
        output.value_in(self)
    }

    /// What the state alone tells.
    fn kinematic(&self) -> Kinematic<'_, S> {
        Kinematic { model: &self.model.on, state: &self.state }
    }

    fn slip(&self, rub: FrictionGuard) -> SlipState<S> {
        slips(self.model, &self.state)[rub.friction]
    }

    /// That of a contact with friction, or of a rough one: the sum over its tangential rows.
    fn friction(&self, contact: usize) -> S {
        let layout = self.model.layout();
        if let Some(entry) = layout.contacts[contact].friction {
            return self.phase.reactions(self.reduced)[layout.contacts.len() + entry];
        }
        let multipliers = self.model.solve(self.phase.set(), &self.state).1;
        let first = layout.contacts.len() + layout.joints.len();
        let rows = layout.tangents.iter().zip(&multipliers[first..]).filter(|(of, _)| **of == contact);
        rows.fold(S::ZERO, |sum, (_, &multiplier)| sum + multiplier)
    }

    fn foot(&self, entry: usize) -> S {
        let mut feet = vec![S::ZERO; 2 * self.model.layout().feet()];
        self.model.on.system.feet(&self.state, &mut feet);
        feet[entry]
    }

    fn quantity(&self, entry: usize) -> S {
        let (accelerations, multipliers) = self.model.solve(self.phase.set(), &self.state);
        self.model.on.system.quantity(entry, &self.state, &accelerations, &multipliers)
    }
}

fn signed<S: Number>(side: Side) -> S {
    S::ratio(side.sign().into(), 1)
}

fn sign<S: Number>(rub: FrictionGuard) -> S {
    S::ratio(rub.slip.sign().into(), 1)
}

impl<S: Number> Environment for Instant<'_, S> {
    type Value = S;
    type Error = Unsupported;

    fn number(&self, x: f64) -> S {
        arithmetic::number(x)
    }

    fn get_value(&self, variable: Variable) -> Result<S, Unsupported> {
        Ok(match variable {
            Variable::Time => self.t,
            Variable::Coordinate { index, order: 2 } => {
                self.model.solve(self.phase.set(), &self.state).0[index]
            }
            Variable::Reaction(contact) => self.phase.reactions(self.reduced)[contact],
            Variable::Friction(contact) => self.friction(contact),
            Variable::Slip(entry) => slips(self.model, &self.state)[entry].velocity,
            Variable::Coefficient(_) => return Err(Unsupported("coefficients of friction")),
            Variable::Dissipated => return Err(Unsupported("the energy lost before")),
            Variable::Quantity(entry) => self.quantity(entry),
            Variable::Kinetic => self.phase.energy(self.reduced).kinetic,
            Variable::Potential => self.phase.energy(self.reduced).potential,
            Variable::Parameter(_)
            | Variable::Coordinate { .. }
            | Variable::Gap(_)
            | Variable::Point { .. } => {
                let value = self.kinematic().value(variable);
                return value.ok_or(Unsupported("velocities of points"));
            }
        })
    }

    fn apply(&self, function: Function, x: S) -> Result<S, Unsupported> {
        Ok(arithmetic::apply(function, x))
    }

    fn join(&self, operator: Operator, a: S, b: S) -> Result<S, Unsupported> {
        arithmetic::join(operator, a, b).ok_or(Unsupported("powers that are not whole"))
    }
}
