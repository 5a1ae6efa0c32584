//! Values as whole multiples of a step: short to write, and close enough.

use super::quantities::{AnimatedQuantity, Group};

/// How far a drawing may be from the motion, as a part of what it shows.
pub(super) const CLOSENESS: f64 = 1e-5;

/// Below this part of its group a quantity is rounding.
const NOISE: f64 = 1e-6;

/// The size of what each quantity's graph shows, from rows of values: for positions of the whole
/// scene, else from its low to its high values, so that a pole does not count; never nothing.
pub(super) fn sizes(quantities: &[AnimatedQuantity], rows: &[Vec<f64>]) -> Vec<f64> {
    let columns: Vec<Vec<f64>> = (0..quantities.len()).map(|i| column(rows, i)).collect();
    let of = |group: Group| {
        let members = quantities.iter().zip(&columns).filter(move |(quantity, _)| quantity.group == group);
        members.map(|(_, column)| column)
    };
    let scene = of(Group::Position).map(|column| spread(column, 0.0)).fold(0.0, f64::max);
    let size = |(quantity, column): (&AnimatedQuantity, &Vec<f64>)| {
        let largest = of(quantity.group).map(|column| magnitude(column)).fold(0.0, f64::max);
        let size = match quantity.group {
            Group::Position => scene,
            Group::Gap => spread(column, 0.02).max(NOISE * scene),
            _ => spread(column, 0.02),
        };
        let size = size.max(NOISE * largest);
        if size > 0.0 { size } else { 1.0 }
    };
    quantities.iter().zip(&columns).map(size).collect()
}

/// The finite values of a quantity in order.
fn column(rows: &[Vec<f64>], i: usize) -> Vec<f64> {
    let mut values: Vec<f64> = rows.iter().map(|row| row[i]).filter(|value| value.is_finite()).collect();
    values.sort_by(f64::total_cmp);
    values
}

/// From the lowest to the highest of ordered values, but for this part at either end.
fn spread(values: &[f64], part: f64) -> f64 {
    let skipped = (part * values.len() as f64) as usize;
    let kept = &values[skipped..values.len() - skipped];
    kept.last().zip(kept.first()).map_or(0.0, |(high, low)| high - low)
}

fn magnitude(values: &[f64]) -> f64 {
    let median = values.get(values.len() / 2).map_or(0.0, |value| value.abs());
    median.max(spread(values, 0.02))
}

/// A value as a multiple of a step; none for what is no number.
pub(super) fn whole(value: f64, step: f64) -> Option<i64> {
    let multiple = (value / step).round();
    // Beyond 2⁵³ the page could not tell it from its neighbours.
    (multiple.abs() < 9e15).then_some(multiple as i64)
}
