//! Curves over one varied name, categories as bands behind them.

use super::super::Table;
use super::super::cell::Cell;
use super::{Colours, FAILED, WIDTH, axis, description, edges, title};
use crate::plot::{Axis, Banded, Colour, Curve, Figure, LegendSquare, Stripe};

/// Heights of panels, pixels.
const CHART: u32 = 340;
const STRIP: u32 = 150;

pub(super) fn curves(table: &Table) -> String {
    let mut order: Vec<usize> = (0..table.rows.len()).collect();
    order.sort_by(|&i, &j| table.rows[i].point[0].total_cmp(&table.rows[j].point[0]));
    let is_category = |i: &usize| table.observations[*i].is_category();
    let (names, numbers): (Vec<usize>, Vec<usize>) = (0..table.observations.len()).partition(is_category);
    let bands =
        |observation: Option<&usize>| observation.map(|&i| bands(table, &order, i)).unwrap_or_default();
    let title_of = |i: usize| title(table, &table.observations[i]);
    let x = axis(table, 0);
    let chart = |&i: &usize| {
        let (bands, legend) = bands(names.first());
        let caption = names.first().map_or(String::new(), |&i| title_of(i));
        let (curves, dots) = series(table, &order, i, names.first().copied());
        let values = table.cells(i).filter_map(|(_, cell)| cell.number());
        let y = Axis::holding(&title_of(i), values);
        (CHART, Banded { x: x.clone(), y: Some(y), bands, curves, dots, legend, caption })
    };
    let mut panels: Vec<(u32, Banded)> = numbers.iter().map(chart).collect();
    // The first category stands behind the curves, if there are any.
    for &i in names.iter().skip(usize::from(!numbers.is_empty())) {
        let (bands, legend) = bands(Some(&i));
        let (x, caption) = (x.clone(), title_of(i));
        panels.push((
            STRIP,
            Banded { x, y: None, bands, legend, caption, curves: Vec::new(), dots: Vec::new() },
        ));
    }
    let size = (WIDTH, panels.iter().map(|(height, _)| height).sum());
    let figure = Figure { description: description(table, &table.varied[0].name), size };
    figure.banded(&panels)
}

/// Neighbours of one category as one band; each reaches half way to the next.
fn bands(table: &Table, order: &[usize], observation: usize) -> (Vec<Stripe>, Vec<LegendSquare>) {
    let colours = Colours::from_table(table, observation);
    let label = |row: usize| match &table.rows[row].outcome {
        Ok(cells) => cells[observation].to_string(),
        Err(_) => FAILED.to_owned(),
    };
    let values: Vec<f64> = order.iter().map(|&row| table.rows[row].point[0]).collect();
    let edges = edges(&values, table.varied[0].spread.is_logarithmic());
    let mut bands: Vec<Stripe> = Vec::new();
    for (&row, ends) in order.iter().zip(edges.windows(2)) {
        let colour = colours.colour(&label(row));
        match bands.last_mut() {
            Some(last) if last.colour == colour => last.range[1] = ends[1],
            _ => bands.push(Stripe { range: [ends[0], ends[1]], colour }),
        }
    }
    (bands, colours.legend())
}

/// Lines through neighbours of one category where the values are a grid, else dots.
fn series(
    table: &Table,
    order: &[usize],
    observation: usize,
    category: Option<usize>,
) -> (Vec<Curve>, Vec<[f64; 2]>) {
    let point = |row: usize| {
        let row = &table.rows[row];
        let cells = row.outcome.as_ref().ok()?;
        let value = cells[observation].number().filter(|value| value.is_finite())?;
        Some(([row.point[0], value], category.map(|i| cells[i].clone())))
    };
    let points = order.iter().map(|&row| point(row));
    if !table.grid {
        return (Vec::new(), points.flatten().map(|(point, _)| point).collect());
    }
    let mut pieces: Vec<Vec<[f64; 2]>> = vec![Vec::new()];
    let mut before: Option<Option<Cell>> = None;
    for found in points {
        let kind = found.as_ref().map(|(_, kind)| kind.clone());
        if kind != before {
            pieces.push(Vec::new());
        }
        if let (Some((point, _)), Some(piece)) = (found, pieces.last_mut()) {
            piece.push(point);
        }
        before = kind;
    }
    let alone = pieces.iter().filter(|piece| piece.len() == 1).flatten().copied().collect();
    let lines = pieces.into_iter().filter(|piece| piece.len() > 1);
    (lines.map(|points| Curve::solid("", Colour::Black, points)).collect(), alone)
}
