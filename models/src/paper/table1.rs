//! Table 1 in the paper's layout: a column for each λ, a row for each quantity, what is printed and
//! what is computed.

use super::quantity::{Row, Value};
use super::reference::References;

/// Ids of the rows, and what the paper writes before them.
const ROWS: [(&str, &str); 4] =
    [("phi_star", "φ*, rad"), ("phi1", "φ₁, rad"), ("phi2", "φ₂, rad"), ("mu", "μ(φ*, λ)")];
/// λ as the ids and as the paper writes it.
const RATIOS: [(&str, &str); 5] =
    [("0.00", "0"), ("0.25", "0.25"), ("0.50", "0.5"), ("0.75", "0.75"), ("1.00", "1")];

/// One number of the table.
#[derive(Clone, Debug)]
pub struct Entry {
    /// As the paper has it.
    pub printed: String,
    /// As computed.
    pub computed: Option<f64>,
    /// Whether what is computed rounds to what is printed.
    pub reproduced: bool,
}

/// The table's head, and its lines with what the paper writes before them.
pub struct Table1 {
    /// λ as the paper writes it.
    pub ratios: [&'static str; 5],
    /// The lines.
    pub lines: Vec<(&'static str, Vec<Entry>)>,
}

/// Whether an id belongs to the table.
pub fn holds(id: &str) -> bool {
    ROWS.iter().any(|(row, _)| id.starts_with(&format!("fig1b.{row}[")))
}

impl Table1 {
    /// From the rows of all quantities.
    pub fn from_rows(rows: &[Row], tables: &References) -> Self {
        let entry = |row: &str, ratio: &str| {
            let id = format!("fig1b.{row}[{ratio}]");
            let computed = match rows.iter().find(|row| row.id == id).and_then(|row| row.computed.as_ref()) {
                Some(Value::Number(number)) => Some(*number),
                _ => None,
            };
            let printed = tables.published(&id);
            Entry {
                printed: printed.map_or_else(String::new, |printed| printed.text().to_owned()),
                reproduced: printed
                    .zip(computed)
                    .is_some_and(|(printed, value)| printed.is_reproduced_by(value)),
                computed,
            }
        };
        let line = |(row, name)| (name, RATIOS.iter().map(|(ratio, _)| entry(row, ratio)).collect());
        Self { ratios: RATIOS.map(|(_, ratio)| ratio), lines: ROWS.map(line).into() }
    }

    /// For a terminal: what is printed above what is computed.
    pub fn text(&self) -> String {
        let cells = |cells: Vec<String>| cells.iter().map(|cell| format!("{cell:>16}")).collect::<String>();
        let mut text = format!("{:<22}{}\n", "Table 1   λ", cells(self.ratios.map(str::to_owned).into()));
        for (name, entries) in &self.lines {
            let printed = entries.iter().map(|entry| entry.printed.clone()).collect();
            let value =
                |entry: &Entry| entry.computed.map_or_else(|| "-".into(), |value| format!("{value:.12}"));
            let computed = entries.iter().map(value).collect();
            text += &format!("{name:<12}{:<10}{}\n", "printed", cells(printed));
            text += &format!("{:<12}{:<10}{}\n", "", "computed", cells(computed));
        }
        text
    }
}
