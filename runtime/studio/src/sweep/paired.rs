//! Members whose values are given in pairs, not by ranges.

use super::plan::Plan;
use super::{MOST_MEMBERS, Outcome, Spread, Sweep, SweepError, Varied};

impl Sweep<'_> {
    /// Runs as many members as each name has values: the first takes the first of all names, and so
    /// on. Nothing is kept: what was read of each is told as soon as it has run, from any thread;
    /// members that were not run are not told.
    pub fn each_paired(&self, told: &(dyn Fn(usize, Outcome) + Sync)) -> Result<(), SweepError> {
        let plan = Plan::new(self)?;
        let columns = listed(&self.varied)?;
        let point = |i: usize| columns.iter().map(|values| values[i]).collect();
        plan.run(&point, columns.first().map_or(0, |values| values.len()), &|i, outcome| {
            told(i, outcome);
            Ok(())
        })
    }
}

fn values_of(varied: &Varied) -> Result<&[f64], SweepError> {
    match &varied.spread {
        Spread::Listed(values) => Ok(values),
        _ => Err(SweepError::Invalid(format!("`{}` has a range: members in pairs have values", varied.name))),
    }
}

/// The values of all names, as many of each.
fn listed(varied: &[Varied]) -> Result<Vec<&[f64]>, SweepError> {
    let columns: Vec<&[f64]> = varied.iter().map(values_of).collect::<Result<_, _>>()?;
    let count = columns.first().map_or(0, |values| values.len());
    match varied.iter().zip(&columns).find(|(_, values)| values.len() != count) {
        Some((odd, values)) => {
            let text = format!("`{}` has {} values, `{}` {count}", odd.name, values.len(), varied[0].name);
            Err(SweepError::Invalid(text))
        }
        None if count > MOST_MEMBERS => {
            Err(SweepError::Invalid(format!("{count} members: {MOST_MEMBERS} are the most; vary in parts")))
        }
        None => Ok(columns),
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::{models, sweep};
    use super::*;
    use std::sync::Mutex;

    fn listed(name: &str, values: &[f64]) -> Varied {
        Varied { name: name.to_owned(), spread: Spread::Listed(values.to_vec()), units: Vec::new() }
    }

    #[test]
    fn members_in_pairs_are_those_of_a_grid() {
        let models = models();
        let grid = sweep(&models, "ladder", &["vary l=1,2", "vary phi=0.5,1,1.3", "observe t of first open"]);
        let grid = grid.and_then(|sweep| sweep.run()).expect("a table");
        let paired = sweep(&models, "ladder", &["observe t of first open"]).expect("a sweep");
        let paired = paired.over(listed("l", &[2.0, 1.0])).over(listed("phi", &[0.5, 1.3]));
        let told = Mutex::new(vec![None; 2]);
        paired.each_paired(&|i, outcome| told.lock().expect("no panic")[i] = outcome.ok()).expect("members");
        let expected = [3, 2].map(|member| grid.rows[member].outcome.clone().ok());
        assert_eq!(told.into_inner().expect("no panic"), expected);
    }

    #[test]
    fn what_is_in_no_pairs_is_refused() {
        let models = models();
        let told = |varied: [Varied; 2]| {
            let start = sweep(&models, "ladder", &["observe end"]).expect("a sweep");
            let sweep = varied.into_iter().fold(start, Sweep::over);
            sweep.each_paired(&|_, _| ()).map_err(|error| error.to_string())
        };
        let uneven = told([listed("l", &[1.0, 2.0]), listed("phi", &[1.0])]);
        assert_eq!(uneven, Err("`phi` has 1 values, `l` 2".to_owned()));
        let ranged = told([listed("l", &[1.0]), Varied::parse("phi=0.5:1:3").expect("a range")]);
        assert_eq!(ranged, Err("`phi` has a range: members in pairs have values".to_owned()));
    }
}
