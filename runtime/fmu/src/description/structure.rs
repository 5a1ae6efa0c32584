//! Which variables are outputs, derivatives of states, computed at the initialisation, event
//! indicators. Nothing is said about what depends on what: everything may depend on everything.

use super::{Xml, element};
use crate::interface::{Interface, Quantity};
use std::io::Result;

pub(super) fn write(xml: &mut Xml, interface: &Interface) -> Result<()> {
    let is_unknown = |quantity: &Quantity| match quantity {
        Quantity::State { given, .. } => !given,
        quantity => quantity.is_output() || matches!(quantity, Quantity::Acceleration(_)),
    };
    list(xml, "Output", &interface.references(Quantity::is_output))?;
    list(xml, "ContinuousStateDerivative", &interface.derivatives())?;
    list(xml, "InitialUnknown", &interface.references(is_unknown))?;
    list(xml, "EventIndicator", &interface.references(|quantity| matches!(quantity, Quantity::Guard(_))))
}

fn list(xml: &mut Xml, name: &str, references: &[u32]) -> Result<()> {
    references
        .iter()
        .try_for_each(|reference| element(xml, name, &[("valueReference", Some(reference.to_string()))]))
}
