//! What `fit` prints.

use crate::CommandError;
use crate::output::json::pretty;
use core::fmt::Write;
use liftoff::__private::expression::significant;
use liftoff_analysis::{Ending, Fitted};
use liftoff_studio::analyses::Measured;
use liftoff_studio::sweep::aligned;
use serde_json::{Map, Value, json};

/// Digits of values.
const DIGITS: usize = 10;
/// Digits of errors.
const FEW: usize = 3;

/// A line for each variable, correlations, and how well the data are met.
pub fn text(measured: &Measured, found: &Fitted) -> String {
    let head = ["", "value", "standard error", "95 % from", "to"].map(str::to_owned).to_vec();
    let rows = found.estimates.iter().map(|estimate| {
        let value = significant(estimate.value, DIGITS);
        let error = estimate.standard_error.map(|error| significant(error, FEW));
        let ends = estimate.interval.into_iter().flatten().map(|end| significant(end, DIGITS));
        [estimate.name.clone(), value].into_iter().chain(error).chain(ends).collect()
    });
    let head = if found.freedom > 0 { head } else { head[..2].to_vec() };
    let mut text = table([head].into_iter().chain(rows).collect());
    if found.freedom > 0 && found.estimates.len() > 1 {
        text += &correlations(found);
    }
    let told = |count: usize, what: &str| format!("{count} {what}{}", if count == 1 { "" } else { "s" });
    let values = told(measured.data.len(), "value");
    let freedom = match found.scatter {
        Some(scatter) => {
            let scatter = significant(scatter, FEW);
            let of = match measured.is_weighed() {
                true => format!("they scatter by {scatter} of their standard deviations"),
                false => format!("they scatter by {scatter}"),
            };
            format!("{of}, with {} of freedom", told(found.freedom, "degree"))
        }
        None => "there are no degrees of freedom left for error estimates".to_owned(),
    };
    let _ = writeln!(text, "{values}, norm of the residuals {}: {freedom}", significant(found.norm, FEW));
    let ended = if found.ending == Ending::Converged { "converged" } else { "not converged" };
    let _ = writeln!(text, "{ended} after {}, {}", told(found.iterations, "step"), told(found.runs, "run"));
    text
}

/// The lower half, without what each has with itself.
fn correlations(found: &Fitted) -> String {
    let names = found.estimates.iter().map(|estimate| estimate.name.clone());
    let last = found.estimates.len() - 1;
    let head = [String::from("correlation")].into_iter().chain(names.clone().take(last)).collect();
    let rows = names.zip(&found.correlations).enumerate().skip(1).map(|(i, (name, row))| {
        [name].into_iter().chain(row[..i].iter().map(|x| format!("{x:.3}"))).collect()
    });
    table([head].into_iter().chain(rows).collect())
}

fn table(rows: Vec<Vec<String>>) -> String {
    aligned(&rows, Some(0)).iter().map(|line| format!("{line}\n")).collect()
}

/// The same with all digits, and with the residuals.
pub fn json(measured: &Measured, found: &Fitted) -> Result<String, CommandError> {
    let estimates = found.estimates.iter().map(|estimate| {
        let told = json!({
            "value": estimate.value,
            "standard_error": estimate.standard_error,
            "interval": estimate.interval,
        });
        (estimate.name.clone(), told)
    });
    let residuals = measured.data.iter().zip(&found.residuals).map(
        |(datum, residual)| json!({ "of": datum.to_string(), "measured": datum.value, "residual": residual }),
    );
    let told = json!({
        "estimates": estimates.collect::<Map<String, Value>>(),
        "correlations": found.correlations,
        "residuals": residuals.collect::<Vec<_>>(),
        "norm": found.norm,
        "freedom": found.freedom,
        "scatter": found.scatter,
        "iterations": found.iterations,
        "runs": found.runs,
        "converged": found.ending == Ending::Converged,
        "skipped": measured.skipped,
    });
    pretty(&told)
}
