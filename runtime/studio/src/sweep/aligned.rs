//! Tables as text, of sweeps and of runs.

/// A line for each row, columns as wide as their widest entry: to the right, that of `left` to the left. Rows may be shorter than
/// the first.
pub fn aligned(rows: &[Vec<String>], left: Option<usize>) -> Vec<String> {
    let size = |row: &Vec<String>, k: usize| row.get(k).map_or(0, |text| text.chars().count());
    let width = |k: usize| rows.iter().map(|row| size(row, k)).max().unwrap_or(0);
    let widths: Vec<usize> = (0..rows.first().map_or(0, Vec::len)).map(width).collect();
    // Widths of formats end at 65,535.
    let cell = |(k, (text, width)): (usize, (&String, &usize))| {
        let room = " ".repeat(width.saturating_sub(text.chars().count()));
        if left == Some(k) { format!("{text}{room}") } else { format!("{room}{text}") }
    };
    let line =
        |row: &Vec<String>| row.iter().zip(&widths).enumerate().map(cell).collect::<Vec<_>>().join("  ");
    rows.iter().map(|row| line(row).trim_end().to_owned()).collect()
}
