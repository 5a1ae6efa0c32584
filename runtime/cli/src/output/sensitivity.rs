//! What `sensitivity` prints.

use crate::CommandError;
use crate::output::json::pretty;
use liftoff::__private::expression::significant;
use liftoff_analysis::Variable;
use liftoff_studio::analyses::DifferentiatedRun;
use liftoff_studio::sweep::aligned;
use serde_json::{Map, Value};

/// Digits of what is printed.
const DIGITS: usize = 7;
/// The column of what is differentiated.
const NAME: usize = 0;
/// What a variable of its own size changes by less than this is rounding.
const ROUNDED: f64 = 1e-11;

/// A row for the time of each event and for each entry of the final state, a column for each variable.
pub fn text(DifferentiatedRun { run, variables, sensitivities: found, .. }: &DifferentiatedRun) -> String {
    let mut rows =
        vec![row(["", ""].map(str::to_owned), variables.iter().map(|of| format!("d/d{}", of.name)))];
    for (event, derivatives) in run.events().iter().zip(&found.events).skip(1) {
        if let Some(time) = &derivatives.time {
            let name = [&event.supports.join(", "), &event.kind.to_string()].map(String::as_str).join(" ");
            let size = event.t.abs().max(run.scales().time);
            let first = [format!("t({})", name.trim()), number(event.t)];
            rows.push(row(first, format_slopes(variables, time, size)));
        }
    }
    let units = run.scales().state(run.layout());
    for ((name, unit), (x, slopes)) in
        run.layout().names_of_state().zip(units).zip(run.final_state().iter().zip(&found.end))
    {
        rows.push(row([name, number(*x)], format_slopes(variables, slopes, x.abs().max(unit))));
    }
    aligned(&rows, Some(NAME)).iter().map(|line| format!("{line}\n")).collect()
}

/// The same with all digits, and with the state behind each event.
pub fn json(found: &DifferentiatedRun) -> Result<String, CommandError> {
    let DifferentiatedRun { run, variables, sensitivities: found, .. } = found;
    let by_variable = |slopes: &[f64]| -> Value {
        let named = variables.iter().zip(slopes).map(|(of, x)| (of.name.clone(), Value::from(*x)));
        Value::Object(named.collect::<Map<_, _>>())
    };
    let by_entry = |rows: &[Vec<f64>]| -> Value {
        Value::Object(run.layout().names_of_state().zip(rows.iter().map(|row| by_variable(row))).collect())
    };
    let events = run.events().iter().zip(&found.events).map(|(event, derivatives)| {
        serde_json::json!({
            "t": event.t,
            "kind": event.kind.to_string(),
            "supports": event.supports,
            "time": derivatives.time.as_ref().map(|time| by_variable(time)),
            "state": by_entry(&derivatives.state),
        })
    });
    let told = serde_json::json!({ "events": events.collect::<Vec<_>>(), "end": by_entry(&found.end) });
    pretty(&told)
}

fn row(first: [String; 2], rest: impl Iterator<Item = String>) -> Vec<String> {
    first.into_iter().chain(rest).collect()
}

/// Zero where what they change is rounding.
fn format_slopes(variables: &[Variable], slopes: &[f64], size: f64) -> impl Iterator<Item = String> {
    let told = variables.iter().zip(slopes);
    told.map(move |(of, &x)| number(if (x * of.unit).abs() <= ROUNDED * size { 0.0 } else { x }))
}

fn number(x: f64) -> String {
    significant(x, DIGITS)
}
