//! Maps over two varied names, one for each observation.

use super::super::{MemberResult, Table};
use super::{Colours, FAILED, WIDTH, axis, description, edges, ends, title};
use crate::plot::{Colour, Dot, Figure, Map, Patch, Shade};

/// Height of a map, pixels.
const MAP: u32 = 520;
const WITHOUT: &str = "without";

pub(super) fn maps(table: &Table) -> String {
    let panels: Vec<Map> = (0..table.observations.len()).map(|i| map(table, i)).collect();
    let size = (WIDTH, MAP * panels.len() as u32);
    let over = format!("{} and {}", table.varied[0].name, table.varied[1].name);
    Figure { description: description(table, &over), size }.maps(&panels)
}

fn map(table: &Table, i: usize) -> Map {
    let observation = &table.observations[i];
    let numbers: Vec<f64> =
        table.cells(i).filter_map(|(_, cell)| cell.number()).filter(|value| value.is_finite()).collect();
    let (legend, bar) = if observation.is_category() {
        (Colours::from_table(table, i), None)
    } else {
        let mut colours = Vec::new();
        if table.cells(i).any(|(_, cell)| cell.number().is_none()) {
            colours.push((WITHOUT.to_owned(), Colour::Grey));
        }
        if table.failed().next().is_some() {
            colours.push((FAILED.to_owned(), Colour::Black));
        }
        (Colours(colours), (!numbers.is_empty()).then(|| ends(&numbers)))
    };
    let shade = |row: usize| match (&table.rows[row].outcome, bar) {
        (Err(_), _) => Shade::Colour(legend.colour(FAILED)),
        (Ok(cells), Some([low, high])) => match cells[i].number() {
            Some(value) if value.is_finite() => Shade::of_part((value - low) / (high - low)),
            _ => Shade::Colour(legend.colour(WITHOUT)),
        },
        (Ok(cells), None) => Shade::Colour(legend.colour(&cells[i].to_string())),
    };
    let (patches, dots) = if table.grid {
        (patches(table, &shade), Vec::new())
    } else {
        let dot =
            |(i, row): (usize, &MemberResult)| Dot { at: [row.point[0], row.point[1]], shade: shade(i) };
        (Vec::new(), table.rows.iter().enumerate().map(dot).collect())
    };
    let (x, y) = (axis(table, 0), axis(table, 1));
    Map { x, y, patches, dots, legend: legend.legend(), caption: title(table, observation), bar }
}

/// Cells of a grid; those of one column that are alike and neighbours are one.
fn patches(table: &Table, shade: &dyn Fn(usize) -> Shade) -> Vec<Patch> {
    let ranks = [0, 1].map(|k| {
        let mut values: Vec<f64> = table.varied[k].spread.values().unwrap_or_default();
        values.sort_by(f64::total_cmp);
        values.dedup();
        (edges(&values, table.varied[k].spread.is_logarithmic()), values)
    });
    let rank = |k: usize, value: f64| ranks[k].1.partition_point(|known| *known < value);
    let cell = |k: usize, at: usize| [ranks[k].0[at], ranks[k].0[at + 1]];
    let mut order: Vec<(usize, usize, usize)> = table
        .rows
        .iter()
        .enumerate()
        .map(|(i, row)| (rank(0, row.point[0]), rank(1, row.point[1]), i))
        .collect();
    order.sort_unstable();
    let mut patches: Vec<(usize, usize, Patch)> = Vec::new();
    for (column, line, row) in order {
        let (shade, [low, high]) = (shade(row), cell(1, line));
        match patches.last_mut() {
            Some((c, l, last)) if *c == column && *l + 1 == line && last.shade == shade => {
                (*l, last.y[1]) = (line, high);
            }
            _ => patches.push((column, line, Patch { x: cell(0, column), y: [low, high], shade })),
        }
    }
    patches.into_iter().map(|(_, _, patch)| patch).collect()
}
