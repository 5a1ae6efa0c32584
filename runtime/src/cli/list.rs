//! `liftoff list`.

use super::CommandError;
use super::print::print;
use super::style::{LABEL, NAME, styled};
use crate::catalog::{Model, Models};
use crate::model::Layout;
use clap::Args;
use serde::Serialize;
use serde_json::{Map, Value};

#[derive(Args, Debug)]
pub struct List {
    /// Print JSON
    #[arg(long)]
    json: bool,
}

#[derive(Serialize)]
struct Entry<'a> {
    name: &'a str,
    summary: &'a str,
    /// With their defaults.
    parameters: Map<String, Value>,
    coordinates: Vec<&'static str>,
    supports: Vec<&'static str>,
}

impl List {
    /// Prints name, summary, coordinates, supports and parameters with their defaults of every model.
    pub fn execute(&self, models: &Models) -> Result<(), CommandError> {
        let text = match self.json {
            true => json(models)?,
            false => models.iter().map(entry).collect(),
        };
        Ok(print(&text)?)
    }
}

fn json(models: &Models) -> Result<String, CommandError> {
    let entries: Vec<_> = models.iter().map(described).collect();
    let text = serde_json::to_string_pretty(&entries);
    text.map(|text| text + "\n").map_err(|error| CommandError::Failed(error.to_string()))
}

fn described(model: &dyn Model) -> Entry<'_> {
    let Layout { coordinates, contacts, .. } = model.layout();
    Entry {
        name: model.name(),
        summary: model.summary(),
        parameters: model.setup().parameters.into_iter().map(|(name, value)| (name, value.into())).collect(),
        coordinates: coordinates.iter().map(|coordinate| coordinate.name).collect(),
        supports: contacts.iter().flat_map(|contact| contact.supports.iter().copied()).collect(),
    }
}

fn entry(model: &dyn Model) -> String {
    let layout = model.layout();
    let coordinates: Vec<_> = layout.coordinates.iter().map(|coordinate| coordinate.name).collect();
    let supports: Vec<_> = layout.contacts.iter().map(|contact| contact.label).collect();
    let parts = [
        ("parameters", parameters(model)),
        ("coordinates", coordinates.join(", ")),
        ("supports", supports.join(" | ")),
    ];
    let told = parts.iter().filter(|(_, names)| !names.is_empty());
    let told: Vec<_> = told.map(|(label, names)| format!("{} {names}", styled(LABEL, label))).collect();
    let name = styled(NAME, &format!("{:<18}", model.name()));
    format!("{name} {}\n{:18} {}\n", model.summary(), "", told.join("; "))
}

/// With their defaults, where the model has a run worth seeing.
fn parameters(model: &dyn Model) -> String {
    let defaults = model.setup().parameters;
    let one = |name: &&str| match defaults.iter().find(|(known, _)| known == name).map(|(_, value)| value) {
        Some(value) => format!("{name} = {value}"),
        None => (*name).to_owned(),
    };
    model.layout().parameters.iter().map(one).collect::<Vec<_>>().join(", ")
}
