//! Where the equations of a model hold: a distance that is driven is above zero, f(t) > 0, and a
//! coefficient of friction is not negative, μ(v) ≥ 0.

use crate::context::{RunContext, reduce};
use crate::error::ModelError;
use crate::expression::Condition;
use crate::expression::resolve::contact_of;
use crate::integration::phase_point::PhasePoint;
use crate::model::{ContactSet, Form, Layout, QuantityKind};

/// What has a bound.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum BoundedQuantity {
    /// A driven distance, by its entry among the quantities; of a drive on a condition with its
    /// contact.
    Distance(usize, Option<usize>),
    /// The friction of a contact, by its entry in [`Layout::frictions`].
    Friction(usize),
}

/// A bound of the equations, with the condition that they have left it.
#[derive(Debug, Clone)]
pub(crate) struct Domain {
    pub(crate) of: BoundedQuantity,
    pub(crate) left: Condition,
}

impl Domain {
    /// All of a model.
    pub(crate) fn all(layout: &'static Layout) -> Vec<Self> {
        let quantities = layout.quantities.iter().enumerate();
        let distances = quantities.filter(|(_, quantity)| quantity.kind == QuantityKind::DrivenDistance);
        let distances = distances.filter_map(|(entry, quantity)| {
            let contact = contact_of(layout, &format!("drive {}", driven(quantity.name)));
            let of = BoundedQuantity::Distance(entry, contact.map(|(contact, _)| contact));
            Some(Self { of, left: Condition::parse(layout, &format!("{} < 0", quantity.name)).ok()? })
        });
        let frictions = layout.frictions.iter().enumerate().filter(|(_, friction)| friction.follows_slip);
        let frictions = frictions.filter_map(|(entry, friction)| {
            let support = layout.contacts[friction.contact].supports.first()?;
            let left = Condition::parse(layout, &format!("mu({support}) < 0")).ok()?;
            Some(Self { of: BoundedQuantity::Friction(entry), left })
        });
        distances.chain(frictions).collect()
    }

    /// Refuses a distance that is driven throughout and not above zero at t = 0.
    pub(crate) fn check(&self, context: &RunContext) -> Result<(), ModelError> {
        let BoundedQuantity::Distance(entry, None) = self.of else { return Ok(()) };
        let (layout, nominal) = (context.layout(), &context.model.nominal);
        let at_rest: Vec<f64> = nominal.iter().copied().chain(nominal.iter().map(|_| 0.0)).collect();
        let phase = context.phase(ContactSet::EMPTY, Form::Multipliers);
        let reduced = reduce(&*phase, &layout.state_at(&at_rest, 0.0));
        let point = PhasePoint::new(phase, ContactSet::EMPTY, 0.0, reduced);
        match self.left.difference(context, &point).0 {
            value if value > 0.0 => Ok(()),
            value => Err(ModelError::DrivenDistance {
                drive: driven(layout.quantities[entry].name).to_owned(),
                value,
            }),
        }
    }
}

/// `distance(A, B)` of `target(distance(A, B))`.
pub(crate) fn driven(target: &'static str) -> &'static str {
    target.split_once('(').and_then(|(_, rest)| rest.strip_suffix(')')).unwrap_or(target)
}
