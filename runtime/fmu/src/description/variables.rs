//! The variables.

use super::{Attribute, Xml, element, number, units};
use crate::interface::{Interface, Quantity, Variable};
use std::io::Result;

pub(super) fn write(xml: &mut Xml, interface: &Interface) -> Result<()> {
    interface.variables.iter().zip(0..).try_for_each(|(variable, reference)| {
        let [causality, variability] = kind(&variable.quantity);
        let mut attributes = vec![
            ("name", Some(variable.name.clone())),
            ("valueReference", Some(u32::to_string(&reference))),
            ("causality", Some(causality.to_owned())),
            ("variability", Some(variability.to_owned())),
        ];
        attributes.extend(initial(variable));
        attributes.push(("unit", units::name(variable.unit)));
        attributes.extend(of_states(interface, &variable.quantity));
        element(xml, tag(&mut attributes, &variable.quantity), &attributes)
    })
}

fn tag(attributes: &mut Vec<Attribute>, quantity: &Quantity) -> &'static str {
    match quantity {
        Quantity::Contact(_) => {
            attributes.push(("declaredType", Some("Contact".to_owned())));
            "Enumeration"
        }
        Quantity::Events => "Int32",
        _ => "Float64",
    }
}

fn kind(quantity: &Quantity) -> [&'static str; 2] {
    match quantity {
        Quantity::Time => ["independent", "continuous"],
        Quantity::Parameter(_) => ["parameter", "fixed"],
        Quantity::State { .. } | Quantity::Output => ["output", "continuous"],
        Quantity::Contact(_) | Quantity::Events => ["output", "discrete"],
        Quantity::Acceleration(_) | Quantity::Guard(_) => ["local", "continuous"],
    }
}

/// What is known before the initialisation.
fn initial(variable: &Variable) -> [Attribute<'static>; 2] {
    let initial = match variable.quantity {
        Quantity::Time => None,
        Quantity::Parameter(_) | Quantity::State { given: true, .. } => Some("exact"),
        Quantity::State { given: false, .. } => Some("approx"),
        _ => Some("calculated"),
    };
    [("initial", initial.map(str::to_owned)), ("start", variable.start.map(number))]
}

/// Whose derivative a variable is; that events set it anew.
fn of_states(interface: &Interface, quantity: &Quantity) -> [Attribute<'static>; 2] {
    let rates = interface.layout.coordinates.len();
    let of = match *quantity {
        Quantity::State { entry, .. } if entry >= rates => Some(entry - rates),
        Quantity::Acceleration(rate) => Some(rate),
        _ => None,
    };
    let is = |of: usize| {
        interface.references(|quantity| matches!(quantity, Quantity::State { entry, .. } if *entry == of))
    };
    let derivative = of.and_then(|of| is(of).first().map(u32::to_string));
    let reinit = matches!(quantity, Quantity::State { .. }).then(|| "true".to_owned());
    [("derivative", derivative), ("reinit", reinit)]
}
