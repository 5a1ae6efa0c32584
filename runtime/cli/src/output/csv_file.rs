//! `liftoff run --csv`.

use crate::CommandError;
use crate::commands::run::Ran;
use crate::options::clock::{Clock, Even};
use crate::options::samples::{Row, Samples};
use crate::options::sampling::Sampling;
use crate::output::file::unwritable;
use liftoff::model::Layout;
use liftoff::{Observer, Output};
use liftoff_studio::file::replace;
use std::io;
use std::path::Path;

/// What looks at the motion that a file is to have.
fn samples(
    sampling: &Sampling,
    columns: &[String],
    layout: &'static Layout,
) -> Result<Samples<'static>, CommandError> {
    let outputs: Result<Vec<_>, _> = columns.iter().map(|column| Output::parse(layout, column)).collect();
    let clock = if sampling.is_of_events() { Clock::Even(Even::default()) } else { sampling.clock() };
    Ok(Samples::new(outputs?, clock))
}

/// Writes time, state, reactions, gaps, energies and the outputs asked for while `run` goes on: at the events, and at the times
/// asked for or at equal intervals, as far as it came. The run with what kept the file from being written.
pub fn write(
    (sampling, layout): (&Sampling, &'static Layout),
    path: &Path,
    run: impl FnOnce(&mut dyn Observer) -> Result<Ran, CommandError>,
) -> Result<(Ran, Result<(), CommandError>), CommandError> {
    let columns = [columns(layout), sampling.outputs().to_vec()].concat();
    let samples = samples(sampling, &columns, layout)?;
    let mut ran = None;
    let written = replace(path, |out| {
        let mut table = csv::Writer::from_writer(out);
        table.write_record(&columns)?;
        let mut failure = Ok(());
        let mut write = |row: &Row| {
            if failure.is_ok() {
                failure = table.write_record(row.values.iter().map(f64::to_string));
            }
        };
        let watch = |mut samples: Samples<'_>| {
            let done = ran.insert(run(&mut samples));
            done.as_ref().map_or(Vec::new(), |ran| samples.finish(&ran.record))
        };
        let rows = match sampling.is_of_events() {
            true => watch(samples),
            false => watch(samples.into_sink(&mut write)),
        };
        rows.iter().for_each(&mut write);
        failure?;
        match ran.as_ref().is_some_and(Result::is_ok) {
            true => table.flush(),
            false => Err(io::Error::other("the run did not begin")),
        }
    });
    match (ran, written) {
        (Some(Ok(ran)), written) => Ok((ran, written.map_err(|error| unwritable(path, &error)))),
        (Some(Err(error)), _) => Err(error),
        (None, Err(error)) => Err(unwritable(path, &error)),
        (None, Ok(())) => Err(unwritable(path, &"nothing was run")),
    }
}

/// Every column is an output that `--until` understands too.
fn columns(layout: &Layout) -> Vec<String> {
    let names = layout.coordinates.iter().map(|coordinate| coordinate.name);
    let mut columns = vec!["t".to_owned()];
    columns.extend(names.clone().map(str::to_owned));
    columns.extend(names.map(|name| format!("{name}'")));
    for contact in layout.contacts {
        let functions = if contact.has_friction_force() { &["N", "R"][..] } else { &["N"] };
        for function in functions {
            match contact.shared {
                true => {
                    columns.extend(contact.supports.iter().map(|support| format!("{function}({support})")))
                }
                false => columns.push(format!("{function}({})", contact.label)),
            }
        }
        columns.extend(contact.friction.map(|_| format!("v({})", contact.supports[0])));
    }
    let gaps = layout.contacts.iter().filter_map(|contact| contact.supports.first());
    columns.extend(gaps.map(|support| format!("gap({support})")));
    columns.extend(["T", "V", "E"].map(str::to_owned));
    columns
}
