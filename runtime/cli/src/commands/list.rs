//! `liftoff list`.

use crate::CommandError;
use crate::options::defaults::{block, measured, parameters};
use crate::output::json::pretty;
use crate::output::print::print;
use crate::output::style::{LABEL, NAME, styled};
use clap::Args;
use liftoff_core::model::Layout;
use liftoff_studio::registry::{Entry, Models};
use liftoff_studio::run_spec::Values;
use serde::Serialize;
use serde_json::{Map, Value};

#[derive(Args, Debug)]
pub struct List {
    /// Names of models whose default runs are printed in full
    pub models: Vec<String>,
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
    points: Vec<&'static str>,
    default_run: Map<String, Value>,
}

impl List {
    /// Prints name, summary, coordinates, supports and parameters with their defaults of every model, or all defaults of those that
    /// are named.
    pub fn execute(&self, models: &Models) -> Result<(), CommandError> {
        let text = match self.json {
            true => json(&self.chosen(models)?)?,
            false if self.models.is_empty() => models.iter().map(entry).collect(),
            false => self.chosen(models)?.into_iter().map(in_full).collect::<Vec<_>>().join("\n"),
        };
        Ok(print(&text)?)
    }

    fn chosen<'a>(&self, models: &'a Models) -> Result<Vec<&'a Entry>, CommandError> {
        let named: Result<Vec<_>, _> = self.models.iter().map(|name| models.find(name)).collect();
        Ok(if self.models.is_empty() { models.iter().collect() } else { named? })
    }
}

fn json(models: &[&Entry]) -> Result<String, CommandError> {
    let entries: Vec<_> = models.iter().map(|model| described(model)).collect();
    pretty(&entries)
}

fn described(model: &Entry) -> Listed<'_> {
    let Layout { contacts, .. } = model.layout();
    Listed {
        name: model.name(),
        summary: model.summary(),
        parameters: model
            .default_run()
            .parameters
            .into_iter()
            .map(|(name, value)| (name, value.into()))
            .collect(),
        coordinates: model.layout().names_of_positions().collect(),
        supports: contacts.iter().flat_map(|contact| contact.supports.iter().copied()).collect(),
        points: model.layout().points.to_vec(),
        default_run: default_run(model),
    }
}

/// What a run takes where nothing is said, beside the parameters.
fn default_run(model: &Entry) -> Map<String, Value> {
    let spec = model.default_run();
    let limit = spec.limit.or_else(|| Some(model.simulation(&spec).ok()?.time_limit()));
    let named = |values: Values| -> Value {
        values.into_iter().map(|(name, value)| (name, value.into())).collect::<Map<_, _>>().into()
    };
    let entries = [
        ("start", named(spec.start)),
        ("energy_of", named(spec.energy_of)),
        ("until", spec.until.into()),
        ("limit", limit.into()),
        ("tolerance", spec.tolerance.into()),
    ];
    entries.into_iter().map(|(name, value)| (name.to_owned(), value)).collect()
}

/// Name, summary, names, default run.
fn in_full(model: &Entry) -> String {
    let layout = model.layout();
    let supports: Vec<_> = layout.contacts.iter().map(|contact| contact.label).collect();
    let names = [
        ("coordinates", measured(layout)),
        ("supports", supports.join(" | ")),
        ("points", layout.points.join(", ")),
    ];
    let names = names.iter().filter(|(_, names)| !names.is_empty());
    let names: String = names
        .map(|(label, names)| format!("  {} {names}\n", styled(LABEL, &format!("{label:<11}"))))
        .collect();
    format!("{} {}\n{names}The default run:\n{}", styled(NAME, model.name()), model.summary(), block(model))
}

fn entry(model: &Entry) -> String {
    let layout = model.layout();
    let coordinates: Vec<_> = layout.names_of_positions().collect();
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
