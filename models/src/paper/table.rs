//! The tables on standard output.

use super::quantity::{Row, Value};
use super::reference::References;
use super::table1::{self, Table1};

/// Table 1, the other numbers that the paper prints, and all references.
pub fn text(rows: &[Row], tables: &References) -> String {
    [Table1::from_rows(rows, tables).text(), printed(rows, tables), compared(rows)].join("\n")
}

/// What the paper prints outside its table, in its units.
fn printed(rows: &[Row], tables: &References) -> String {
    let mut lines = vec![format!(
        "{:<62}{:<7}{:>9}{:>18}  {}\n",
        "The paper's text and figures", "unit", "printed", "computed", "where"
    )];
    for row in rows.iter().filter(|row| !table1::holds(&row.id)) {
        let Some(printed) = tables.published(&row.id) else { continue };
        let computed = number(row).map_or_else(none, |value| format!("{:.10}", printed.in_its_unit(value)));
        lines.push(format!(
            "{:<62}{:<7}{:>9}{computed:>18}  {}\n",
            row.name_as(printed.what.as_deref()),
            printed.unit,
            printed.text(),
            printed.source,
        ));
    }
    lines.concat()
}

/// Everything that has a reference.
fn compared(rows: &[Row]) -> String {
    let mut lines =
        vec![line(["Against references of 25 digits", "unit", "computed", "reference", "rel. error"])];
    lines.extend(rows.iter().map(|row| {
        line([
            &row.name(),
            row.unit,
            &row.computed.as_ref().map_or_else(none, long),
            &row.reference.as_ref().map_or_else(none, long),
            &row.relative_error.map_or_else(none, |error| format!("{error:.1e}")),
        ])
    }));
    lines.concat()
}

fn line([name, unit, computed, reference, error]: [&str; 5]) -> String {
    format!("{name:<62} {unit:<12} {computed:>20} {reference:>20} {error:>10}\n")
}

/// How many of the printed numbers are reproduced, and the others with the reason.
pub fn reproduced(rows: &[Row], tables: &References) -> (usize, Vec<String>) {
    let (mut count, mut others) = (0, Vec::new());
    for row in rows {
        let (Some(printed), Some(value)) = (tables.published(&row.id), number(row)) else { continue };
        if printed.is_reproduced_by(value) {
            count += 1;
            continue;
        }
        others.push(format!(
            "{} {} for {:.*} ({}{})",
            printed.text(),
            printed.unit,
            printed.decimals() + 1,
            printed.in_its_unit(value),
            printed.source,
            printed.reason.as_ref().map_or_else(String::new, |reason| format!(": {reason}")),
        ));
    }
    (count, others)
}

/// How many printed numbers are reproduced; the largest error, and how many quantities it is the
/// largest of.
pub fn summary(rows: &[Row], tables: &References) -> String {
    let (count, others) = reproduced(rows, tables);
    let total = count + others.len();
    let printed = format!(
        "{count} of {total} printed numbers reproduced to the last digit; not: {}",
        others.join("; ")
    );
    let compared = rows.iter().filter_map(|row| Some((row.relative_error?, row)));
    let count = compared.clone().count();
    let missing = rows.iter().filter(|row| row.reference.is_some() && row.computed.is_none()).count();
    let largest = compared.max_by(|a, b| a.0.total_cmp(&b.0));
    let largest = largest.map_or_else(String::new, |(error, row)| {
        format!("largest relative error {error:.1e} ({}) ", row.name())
    });
    let missing =
        if missing == 0 { String::new() } else { format!("; {missing} with a reference not computed") };
    format!("{printed}\n{largest}over {count} quantities{missing}")
}

fn number(row: &Row) -> Option<f64> {
    match row.computed {
        Some(Value::Number(number)) => Some(number),
        _ => None,
    }
}

fn none() -> String {
    "-".into()
}

/// All digits that a double can hold, within a table's column.
pub fn long(value: &Value) -> String {
    match value {
        Value::Number(number) => format!("{number:.15}"),
        Value::Supports(supports) => supports.clone(),
    }
}
