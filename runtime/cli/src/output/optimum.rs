//! What `optimise` prints.

use crate::CommandError;
use crate::output::json::pretty;
use liftoff::__private::expression::significant;
use liftoff_analysis::{Best, Ending};
use liftoff_studio::sweep::aligned;
use serde_json::{Map, Value, json};

/// Digits of values, and of slopes.
const DIGITS: usize = 10;
const FEW: usize = 3;

/// A line for each variable, and what they make of the output.
pub fn text(what: &str, names: &[String], best: &Best) -> String {
    let head = ["", "value", "slope", ""].map(str::to_owned).to_vec();
    let row = |(i, name): (usize, &String)| {
        let bound = if best.at_bounds[i] { "at its bound" } else { "" };
        let [value, slope] = [significant(best.values[i], DIGITS), significant(best.slopes[i], FEW)];
        vec![name.clone(), value, slope, bound.to_owned()]
    };
    let rows: Vec<Vec<String>> = [head].into_iter().chain(names.iter().enumerate().map(row)).collect();
    let lines = aligned(&rows, Some(0));
    let table: String = lines.iter().map(|line| format!("{}\n", line.trim_end())).collect();
    let [first, value] = [best.first, best.value].map(|value| significant(value, DIGITS));
    let ended = if best.ending == Ending::Converged { "converged" } else { "not converged" };
    let runs = if best.runs == 1 { "run" } else { "runs" };
    format!("{table}{what}: {value}, at first {first}\n{ended} after {} {runs}\n", best.runs)
}

/// The same with all digits.
pub fn json(what: &str, names: &[String], best: &Best) -> Result<String, CommandError> {
    let variable = |(i, name): (usize, &String)| {
        let told = json!({ "value": best.values[i], "slope": best.slopes[i], "at_bound": best.at_bounds[i] });
        (name.clone(), told)
    };
    let told = json!({
        "of": what,
        "value": best.value,
        "first": best.first,
        "variables": names.iter().enumerate().map(variable).collect::<Map<String, Value>>(),
        "runs": best.runs,
        "converged": best.ending == Ending::Converged,
    });
    pretty(&told)
}
