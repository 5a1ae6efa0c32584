//! `liftoff run --csv`.

use crate::CommandError;
use crate::options::sampling::Sampling;
use crate::output::file::unwritable;
use liftoff_studio::file::replace;
use std::path::Path;

/// Equally spaced times beside those of the events.
const INTERVALS: u32 = 1000;

/// Writes time, state, reactions, gaps, energies and the outputs asked for: at the events, and at the times asked for or at
/// equal intervals.
pub fn write(record: &Trajectory, sampling: &Sampling, path: &Path) -> Result<(), CommandError> {
    let mut columns = columns(record);
    columns.extend_from_slice(sampling.outputs());
    let outputs: Result<Vec<_>, _> = columns.iter().map(|column| record.function(column)).collect();
    let outputs = outputs?;
    let times = times(record, sampling)?;
    let written = replace(path, |out| {
        let mut table = csv::Writer::from_writer(out);
        table.write_record(&columns)?;
        for t in times {
            table.write_record(outputs.iter().map(|output| output(t).to_string()))?;
        }
        table.flush()
    });
    written.map_err(|error| unwritable(path, &error))
}

/// Every column is an output that `--until` understands too.
fn columns(record: &Trajectory) -> Vec<String> {
    let layout = record.layout();
    let names = layout.coordinates.iter().map(|coordinate| coordinate.name);
    let mut columns = vec!["t".to_owned()];
    columns.extend(names.clone().map(str::to_owned));
    columns.extend(names.map(|name| format!("{name}'")));
    for contact in layout.contacts {
        match contact.shared {
            true => columns.extend(contact.supports.iter().map(|support| format!("N({support})"))),
            false => columns.push(format!("N({})", contact.label)),
        }
    }
    let gaps = layout.contacts.iter().filter_map(|contact| contact.supports.first());
    columns.extend(gaps.map(|support| format!("gap({support})")));
    columns.extend(["T", "V", "E"].map(str::to_owned));
    columns
}

fn times(record: &Trajectory, sampling: &Sampling) -> Result<Vec<f64>, CommandError> {
    let [start, end] = record.interval();
    let even = (0..=INTERVALS).map(|i| start + (end - start) * f64::from(i) / f64::from(INTERVALS));
    let mut times = match sampling.is_of_events() {
        true => even.collect(),
        false => sampling.times([start, end])?,
    };
    times.extend(record.events().iter().map(|event| event.t));
    times.sort_by(f64::total_cmp);
    times.dedup();
    Ok(times)
}
use liftoff::Trajectory;
