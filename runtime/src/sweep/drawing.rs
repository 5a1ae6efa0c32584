//! A sweep as a drawing: curves over one varied name with its categories as bands, a map over two for each observation.

use super::cell::Cell;
use super::summary::counted;
use super::{Observation, Spread, SweepError, Table, Varied};
use crate::plot::{Axis, Banded, Curve, Dot, Ink, Map, Patch, Scale, Shade, Sheet, Stripe, Swatch};

/// Width of a drawing and heights of its panels, pixels.
const WIDTH: u32 = 760;
const CHART: u32 = 340;
const STRIP: u32 = 150;
const MAP: u32 = 520;

/// Colours of categories, the most frequent first; all further ones share the last.
const INKS: [Ink; 6] = [Ink::Blue, Ink::Vermilion, Ink::Green, Ink::Purple, Ink::Sky, Ink::Orange];
const FAILED: &str = "failed";
const NONE: &str = "none";
const WITHOUT: &str = "without";

pub(super) fn svg(table: &Table) -> Result<String, SweepError> {
    match &table.varied[..] {
        [_] => curves(table),
        [_, _] => maps(table),
        names => {
            let count = names.len();
            Err(SweepError::Asked(format!(
                "a drawing shows one varied name or two, not {count}: set the others"
            )))
        }
    }
}

fn description(table: &Table, over: &str) -> String {
    let observed: Vec<_> = table.observations.iter().map(Observation::text).collect();
    format!("{}: {} over {over}", table.model, observed.join(", "))
}

/// A varied name as an axis.
fn axis(table: &Table, varied: usize) -> Axis {
    let Varied { name, spread } = &table.varied[varied];
    let values: Vec<f64> = match spread {
        Spread::Grid(range, _) | Spread::Anywhere(range) => vec![range.low, range.high],
        Spread::Listed(values) => values.clone(),
    };
    let [low, high] = ends(&values);
    let scale = if spread.is_logarithmic() { Scale::Logarithmic } else { Scale::Linear };
    Axis { name: with_unit(table, name), scale, range: [low, high], ticks: Vec::new() }
}

/// The ends of what is to be shown: a little more than nothing.
fn ends(values: &[f64]) -> [f64; 2] {
    let [low, high] =
        values.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], v| [a.min(*v), b.max(*v)]);
    match low < high {
        true => [low, high],
        false if low == 0.0 || !low.is_finite() => [-0.5, 0.5],
        false => [low - 0.05 * low.abs(), low + 0.05 * low.abs()],
    }
}

fn with_unit(table: &Table, name: &str) -> String {
    let is_angle = table.angles.iter().any(|angle| angle == name);
    if is_angle { format!("{name}, rad") } else { name.to_owned() }
}

/// An observation with the unit of its output.
fn title(table: &Table, observation: &Observation) -> String {
    let output = observation.output().map(ToString::to_string).unwrap_or_default();
    let is_angle = table.angles.contains(&output);
    if is_angle { format!("{}, rad", observation.text()) } else { observation.text().to_owned() }
}

/// Categories of an observation with their colours.
struct Colours(Vec<(String, Ink)>);

impl Colours {
    fn of(table: &Table, observation: usize) -> Self {
        let mut inks = INKS.into_iter();
        let ink = |(name, _): (String, usize)| {
            let ink = if name == NONE { Ink::Grey } else { inks.next().unwrap_or(INKS[INKS.len() - 1]) };
            (name, ink)
        };
        let mut colours: Vec<_> = counted(table, observation).into_iter().map(ink).collect();
        if table.failed().next().is_some() {
            colours.push((FAILED.to_owned(), Ink::Black));
        }
        Self(colours)
    }

    fn ink(&self, name: &str) -> Ink {
        self.0.iter().find(|(known, _)| known == name).map_or(Ink::Black, |(_, ink)| *ink)
    }

    fn key(&self) -> Vec<Swatch> {
        self.0.iter().map(|(name, ink)| Swatch { name: name.clone(), ink: *ink }).collect()
    }
}

fn curves(table: &Table) -> Result<String, SweepError> {
    let mut order: Vec<usize> = (0..table.rows.len()).collect();
    order.sort_by(|&i, &j| table.rows[i].point[0].total_cmp(&table.rows[j].point[0]));
    let is_category = |i: &usize| table.observations[*i].is_category();
    let (names, numbers): (Vec<usize>, Vec<usize>) = (0..table.observations.len()).partition(is_category);
    let bands =
        |observation: Option<&usize>| observation.map(|&i| bands(table, &order, i)).unwrap_or_default();
    let title_of = |i: usize| title(table, &table.observations[i]);
    let x = axis(table, 0);
    let chart = |&i: &usize| {
        let (bands, key) = bands(names.first());
        let caption = names.first().map_or(String::new(), |&i| title_of(i));
        let (curves, dots) = series(table, &order, i, names.first().copied());
        let values = table.cells(i).filter_map(|(_, cell)| cell.number());
        let y = Axis::holding(&title_of(i), values);
        (CHART, Banded { x: x.clone(), y: Some(y), bands, curves, dots, key, caption })
    };
    let mut panels: Vec<(u32, Banded)> = numbers.iter().map(chart).collect();
    // The first category stands behind the curves, if there are any.
    for &i in names.iter().skip(usize::from(!numbers.is_empty())) {
        let (bands, key) = bands(Some(&i));
        let (x, caption) = (x.clone(), title_of(i));
        panels
            .push((STRIP, Banded { x, y: None, bands, key, caption, curves: Vec::new(), dots: Vec::new() }));
    }
    let size = (WIDTH, panels.iter().map(|(height, _)| height).sum());
    let sheet = Sheet { description: description(table, &table.varied[0].name), size };
    Ok(sheet.banded(&panels)?)
}

/// Neighbours of one category as one band; each reaches half way to the next.
fn bands(table: &Table, order: &[usize], observation: usize) -> (Vec<Stripe>, Vec<Swatch>) {
    let colours = Colours::of(table, observation);
    let label = |row: usize| match &table.rows[row].outcome {
        Ok(cells) => cells[observation].to_string(),
        Err(_) => FAILED.to_owned(),
    };
    let values: Vec<f64> = order.iter().map(|&row| table.rows[row].point[0]).collect();
    let edges = edges(&values, table.varied[0].spread.is_logarithmic());
    let mut bands: Vec<Stripe> = Vec::new();
    for (&row, ends) in order.iter().zip(edges.windows(2)) {
        let ink = colours.ink(&label(row));
        match bands.last_mut() {
            Some(last) if last.ink == ink => last.range[1] = ends[1],
            _ => bands.push(Stripe { range: [ends[0], ends[1]], ink }),
        }
    }
    (bands, colours.key())
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
    (lines.map(|points| Curve::solid("", Ink::Black, points)).collect(), alone)
}

/// The ends of the cells round sorted values: half way to their neighbours, in equal ratios where so spread.
fn edges(values: &[f64], logarithmic: bool) -> Vec<f64> {
    let middle = |pair: &[f64]| match logarithmic {
        true => (pair[0] * pair[1]).sqrt(),
        false => 0.5 * (pair[0] + pair[1]),
    };
    let [first, last] = ends(values);
    let mut edges = vec![first];
    edges.extend(values.windows(2).map(middle));
    edges.push(last);
    edges
}

fn maps(table: &Table) -> Result<String, SweepError> {
    let panels: Vec<Map> = (0..table.observations.len()).map(|i| map(table, i)).collect();
    let size = (WIDTH, MAP * panels.len() as u32);
    let over = format!("{} and {}", table.varied[0].name, table.varied[1].name);
    Ok(Sheet { description: description(table, &over), size }.maps(&panels)?)
}

fn map(table: &Table, i: usize) -> Map {
    let observation = &table.observations[i];
    let numbers: Vec<f64> =
        table.cells(i).filter_map(|(_, cell)| cell.number()).filter(|value| value.is_finite()).collect();
    let (key, bar) = if observation.is_category() {
        (Colours::of(table, i), None)
    } else {
        let mut colours = Vec::new();
        if table.cells(i).any(|(_, cell)| cell.number().is_none()) {
            colours.push((WITHOUT.to_owned(), Ink::Grey));
        }
        if table.failed().next().is_some() {
            colours.push((FAILED.to_owned(), Ink::Black));
        }
        (Colours(colours), (!numbers.is_empty()).then(|| ends(&numbers)))
    };
    let shade = |row: usize| match (&table.rows[row].outcome, bar) {
        (Err(_), _) => Shade::Ink(key.ink(FAILED)),
        (Ok(cells), Some([low, high])) => match cells[i].number() {
            Some(value) if value.is_finite() => Shade::of_part((value - low) / (high - low)),
            _ => Shade::Ink(key.ink(WITHOUT)),
        },
        (Ok(cells), None) => Shade::Ink(key.ink(&cells[i].to_string())),
    };
    let (patches, dots) = if table.grid {
        (patches(table, &shade), Vec::new())
    } else {
        let dot = |(i, row): (usize, &super::Row)| Dot { at: [row.point[0], row.point[1]], shade: shade(i) };
        (Vec::new(), table.rows.iter().enumerate().map(dot).collect())
    };
    let (x, y) = (axis(table, 0), axis(table, 1));
    Map { x, y, patches, dots, key: key.key(), caption: title(table, observation), bar }
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
