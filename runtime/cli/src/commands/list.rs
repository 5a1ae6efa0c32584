//! `liftoff list`.

use crate::CommandError;
use crate::output::print::print;
use crate::output::style::{LABEL, NAME, styled};
use clap::Args;
use liftoff::model::Layout;
use liftoff_studio::registry::{Entry, Models};
use serde::Serialize;
use serde_json::{Map, Value};

#[derive(Args, Debug)]
pub struct List {
    /// Print JSON
    #[arg(long)]
    json: bool,
}

#[derive(Serialize)]
struct Listed<'a> {
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

fn described(model: &Entry) -> Listed<'_> {
    let Layout { coordinates, contacts, .. } = model.layout();
    Listed {
        name: model.name(),
        summary: model.summary(),
        parameters: model
            .default_run()
            .parameters
            .into_iter()
            .map(|(name, value)| (name, value.into()))
            .collect(),
        coordinates: coordinates.iter().map(|coordinate| coordinate.name).collect(),
        supports: contacts.iter().flat_map(|contact| contact.supports.iter().copied()).collect(),
    }
}

fn entry(model: &Entry) -> String {
    let layout = model.layout();
    let coordinates: Vec<_> = layout.coordinates.iter().map(|coordinate| coordinate.name).collect();
    let supports: Vec<_> = layout.contacts.iter().map(|contact| contact.label).collect();
    let parts = [
        ("parameters", parameters(model)),
        ("coordinates", coordinates.join(", ")),
        ("supports", supports.join(" | ")),
    ];
    let described = parts.iter().filter(|(_, names)| !names.is_empty());
    let described: Vec<_> =
        described.map(|(label, names)| format!("{} {names}", styled(LABEL, label))).collect();
    let name = styled(NAME, &format!("{:<18}", model.name()));
    format!("{name} {}\n{:18} {}\n", model.summary(), "", described.join("; "))
}

/// With their defaults, where the model has a default run.
fn parameters(model: &Entry) -> String {
    let defaults = model.default_run().parameters;
    let one = |name: &&str| match defaults.iter().find(|(known, _)| known == name).map(|(_, value)| value) {
        Some(value) => format!("{name} = {value}"),
        None => (*name).to_owned(),
    };
    model.layout().parameters.iter().map(one).collect::<Vec<_>>().join(", ")
}
