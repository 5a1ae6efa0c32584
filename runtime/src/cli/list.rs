//! `liftoff list`.

use super::CommandError;
use super::print::print;
use crate::catalog::{Model, Models};

/// Prints name, summary, coordinates, supports and parameters with their defaults of every model.
pub fn execute(models: &Models) -> Result<(), CommandError> {
    let entries: String = models.iter().map(entry).collect();
    Ok(print(&entries)?)
}

fn entry(model: &dyn Model) -> String {
    let layout = model.layout();
    let coordinates: Vec<_> = layout.coordinates.iter().map(|coordinate| coordinate.name).collect();
    let supports: Vec<_> = layout.contacts.iter().map(|contact| contact.label).collect();
    let setup = model.setup();
    let parameters: Vec<_> =
        setup.parameters.iter().map(|(name, value)| format!("{name} = {value}")).collect();
    let supports =
        if supports.is_empty() { String::new() } else { format!("; supports {}", supports.join(" | ")) };
    format!(
        "{:<18} {}\n{:18} {}; coordinates {}{supports}\n",
        model.name(),
        model.summary(),
        "",
        parameters.join(", "),
        coordinates.join(", "),
    )
}
