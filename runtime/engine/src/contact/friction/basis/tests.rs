//! The same force from fewer columns.

use nalgebra::{DMatrix, DVector};

use super::{Column, find_replaceable};
use crate::contact::friction::tests::random::{Random, cases};

fn reduce(columns: Vec<Column>) -> Vec<Column> {
    let mut kept = columns;
    while let Some(place) = find_replaceable(&mut kept) {
        kept.remove(place);
    }
    kept
}

fn force(columns: &[Column]) -> DVector<f64> {
    columns.iter().map(|column| &column.entries * column.load).sum()
}

/// What stays is independent, bears the same, and pulls nowhere that it must not.
#[test]
fn what_stays_bears_the_same() {
    let mut random = Random(0x0123_4567_89AB_CDEF);
    let mut fewer = 0;
    for k in 0..cases(2_000) {
        let (n, count) = (1 + random.below(4), 1 + random.below(9));
        let columns: Vec<Column> = (0..count)
            .map(|row| Column {
                row,
                entries: DVector::from_fn(n, |_, _| random.between(-1.0, 1.0)),
                load: random.between(0.0, 1.0),
                one_sided: random.below(4) > 0,
                sticks: random.below(2) > 0,
            })
            .collect();
        let before = force(&columns);
        let kept = reduce(columns);
        fewer += usize::from(kept.len() < count);
        // Columns that all but depend on each other bear large loads, and their rounding.
        let largest = kept.iter().fold(1.0, |most: f64, column| most.max(column.load.abs()));
        assert!((force(&kept) - before).amax() < 1e-9 * largest, "{k}");
        assert!(kept.iter().all(|column| !column.one_sided || column.load >= -1e-12 * largest), "{k}");
        // No other columns make up for one, unless they all but depend on each other.
        let is_replaceable = |place: &usize| {
            let others = kept.iter().enumerate().filter(|(other, _)| other != place);
            let others: Vec<DVector<f64>> = others.map(|(_, column)| column.entries.clone()).collect();
            if !kept[*place].one_sided || others.is_empty() {
                return false;
            }
            let (own, others) = (&kept[*place].entries, DMatrix::from_columns(&others));
            let parts = others.clone().svd(true, true).solve(own, 1e-12).unwrap();
            (others * &parts - own).amax() < 1e-9 && parts.amax() < 1e5
        };
        assert_eq!((0..kept.len()).find(is_replaceable), None, "{k}");
    }
    assert!(fewer > 500, "{fewer}");
}

/// A plank with its weight over one of its feet: the two at its ends bear it, each with a part.
#[test]
fn the_feet_at_the_ends_of_a_plank_stay() {
    for (feet, centre) in [(5, 2.0), (9, 4.0), (40, 17.0)] {
        let columns = (0..feet).map(|row| Column {
            row,
            entries: DVector::from_row_slice(&[1.0, row as f64 - centre]),
            load: 1.0,
            one_sided: true,
            sticks: false,
        });
        let kept = reduce(columns.collect());
        assert_eq!(kept.iter().map(|column| column.row).collect::<Vec<_>>(), [0, feet - 1]);
        assert!(kept.iter().all(|column| column.load > 0.4), "{feet}");
    }
}
