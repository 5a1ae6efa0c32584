//! Where what is observed changes: coarse grid, then bisection of every change at once.

use super::criterion::Criterion;
use super::plan::Plan;
use super::{Range, Spread, SweepError, Varied};

/// Values of the coarse grid where no count is given.
const COARSE: usize = 33;
/// Halvings after which doubles have no more values between.
const MOST: usize = 1100;

/// A change of what is observed between two values of the varied name.
#[derive(Clone, PartialEq, Debug)]
pub struct Threshold {
    /// Below it.
    pub below: f64,
    /// Above it.
    pub above: f64,
    /// What is observed at `below`.
    pub before: String,
    /// What is observed at `above`.
    pub after: String,
}

pub(super) fn thresholds(
    plan: &Plan<'_>,
    varied: &[Varied],
    criterion: &Criterion,
    width: f64,
) -> Result<Vec<Threshold>, SweepError> {
    let [varied] = varied else {
        return Err(SweepError::Invalid("a threshold needs exactly one varied name".into()));
    };
    criterion.check(plan.observations, plan.model.layout())?;
    if !(width > 0.0 && width.is_finite()) {
        return Err(SweepError::Invalid(format!("a width above zero, not {width}")));
    }
    let labelled = |values: &[f64]| -> Result<Vec<(f64, String)>, SweepError> {
        let rows = plan.rows(values.iter().map(|value| vec![*value]).collect())?;
        Ok(rows.into_iter().map(|row| (row.point[0], criterion.label(&row.outcome))).collect())
    };
    let mut changes = changes(&labelled(&coarse(varied))?);
    for _ in 0..MOST {
        let open = |change: &Threshold| change.middle(varied, width).is_some();
        let middles: Vec<f64> = changes.iter().filter_map(|change| change.middle(varied, width)).collect();
        let found = labelled(&middles)?;
        if found.len() < middles.len() || middles.is_empty() {
            break;
        }
        let mut found = found.into_iter();
        changes = changes
            .into_iter()
            .flat_map(|change| match open(&change).then(|| found.next()).flatten() {
                Some(middle) => change.halved(middle),
                None => vec![change],
            })
            .collect();
    }
    Ok(changes)
}

fn coarse(varied: &Varied) -> Vec<f64> {
    match &varied.spread {
        Spread::Anywhere(range) => Spread::Grid(*range, COARSE).values().unwrap_or_default(),
        spread => {
            let mut values = spread.values().unwrap_or_default();
            values.sort_by(f64::total_cmp);
            values.dedup();
            values
        }
    }
}

/// Neighbours that differ.
fn changes(labelled: &[(f64, String)]) -> Vec<Threshold> {
    let change = |pair: &[(f64, String)]| {
        let [(below, before), (above, after)] = pair else { return None };
        let differs = before != after;
        differs.then(|| Threshold {
            below: *below,
            above: *above,
            before: before.clone(),
            after: after.clone(),
        })
    };
    labelled.windows(2).filter_map(change).collect()
}

impl Threshold {
    /// The value half way, where there is one and it is still to be looked at.
    fn middle(&self, varied: &Varied, width: f64) -> Option<f64> {
        let range = Range { low: self.below, high: self.above, logarithmic: varied.spread.is_logarithmic() };
        let middle = range.interpolate(0.5);
        (self.above - self.below > width && self.below < middle && middle < self.above).then_some(middle)
    }

    /// The changes on either side of a value between.
    fn halved(self, middle: (f64, String)) -> Vec<Self> {
        changes(&[(self.below, self.before), middle, (self.above, self.after)])
    }
}
