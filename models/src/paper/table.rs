//! The table on standard output.

use super::quantity::{Row, Value};

/// One line for each quantity.
pub fn text(rows: &[Row]) -> String {
    let mut lines = vec![line(["id", "unit", "published", "computed", "reference", "rel. error"])];
    lines.extend(rows.iter().map(|row| {
        line([
            &row.id,
            row.unit,
            &row.published.map_or_else(none, short),
            &row.computed.as_ref().map_or_else(none, long),
            &row.reference.as_ref().map_or_else(none, long),
            &row.relative_error.map_or_else(none, |error| format!("{error:.1e}")),
        ])
    }));
    lines.concat()
}

/// The largest error, and how many quantities it is the largest of.
pub fn summary(rows: &[Row]) -> String {
    let compared = rows.iter().filter_map(|row| Some((row.relative_error?, row)));
    let count = compared.clone().count();
    let missing = rows.iter().filter(|row| row.reference.is_some() && row.computed.is_none()).count();
    let largest = compared.max_by(|a, b| a.0.total_cmp(&b.0));
    let largest = largest
        .map_or_else(String::new, |(error, row)| format!("largest relative error {error:.1e} ({}) ", row.id));
    let missing =
        if missing == 0 { String::new() } else { format!("; {missing} with a reference not computed") };
    format!("{largest}over {count} quantities{missing}")
}

fn line([id, unit, published, computed, reference, error]: [&str; 6]) -> String {
    format!("{id:<29} {unit:<12} {published:>10} {computed:>20} {reference:>20} {error:>10}\n")
}

fn none() -> String {
    "-".into()
}

/// At most five significant digits: more than the paper ever prints.
pub fn short(value: f64) -> String {
    let text = format!("{value:.4}");
    text.trim_end_matches('0').trim_end_matches('.').into()
}

/// All digits that a double can hold, within a table's column.
pub fn long(value: &Value) -> String {
    match value {
        Value::Number(number) => format!("{number:.15}"),
        Value::Supports(supports) => supports.clone(),
    }
}
