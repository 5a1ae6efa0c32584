//! Units as products of base units.

use super::{Attribute, Xml, element, parent};
use crate::interface::Interface;
use liftoff::__private::expression::si_unit::SiUnit;
use std::io::Result;

/// The name of a unit; none of plain numbers, which have none in FMI.
pub(super) fn name(unit: Option<SiUnit>) -> Option<String> {
    unit.map(SiUnit::symbol).filter(|symbol| !symbol.is_empty())
}

/// Those of the variables, each once, in their order. Units that differ in the radian alone may
/// have one symbol: the first stands.
pub(super) fn write(xml: &mut Xml, interface: &Interface) -> Result<()> {
    let mut known: Vec<(String, SiUnit)> = Vec::new();
    for unit in interface.variables.iter().filter_map(|variable| variable.unit) {
        if let Some(name) = name(Some(unit)).filter(|name| known.iter().all(|(known, _)| known != name)) {
            known.push((name, unit));
        }
    }
    parent(xml, "UnitDefinitions", &[], |xml| {
        known.iter().try_for_each(|(name, unit)| {
            parent(xml, "Unit", &[("name", Some(name.clone()))], |xml| {
                element(xml, "BaseUnit", &powers(*unit))
            })
        })
    })
}

fn powers(unit: SiUnit) -> [Attribute<'static>; 4] {
    [("kg", unit.kilogram), ("m", unit.metre), ("s", unit.second), ("rad", unit.radian)]
        .map(|(base, power)| (base, (power != 0).then(|| power.to_string())))
}
