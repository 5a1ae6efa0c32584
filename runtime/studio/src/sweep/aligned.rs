//! Tables as text, of sweeps and of runs.

/// A line for each row, columns as wide as their widest entry: to the right, that of `left` to the
/// left. Rows may be shorter than the first.
pub fn aligned(rows: &[Vec<String>], left: Option<usize>) -> Vec<String> {
    let mut columns = Columns::default();
    rows.iter().for_each(|row| columns.widen(row));
    rows.iter().map(|row| columns.line(row, left)).collect()
}

/// The widths of columns, of rows that need not be in memory together.
#[derive(Default)]
pub struct Columns(Vec<usize>);

impl Columns {
    /// Makes room for a row.
    pub fn widen(&mut self, row: &[String]) {
        self.0.resize(self.0.len().max(row.len()), 0);
        for (width, text) in self.0.iter_mut().zip(row) {
            *width = (*width).max(text.chars().count());
        }
    }

    /// The line of a row: entries to the right, that of `left` to the left.
    pub fn line(&self, row: &[String], left: Option<usize>) -> String {
        // Widths of formats end at 65,535.
        let cell = |(k, (text, width)): (usize, (&String, &usize))| {
            let room = " ".repeat(width.saturating_sub(text.chars().count()));
            if left == Some(k) { format!("{text}{room}") } else { format!("{room}{text}") }
        };
        let cells: Vec<String> = row.iter().zip(&self.0).enumerate().map(cell).collect();
        cells.join("  ").trim_end().to_owned()
    }
}
