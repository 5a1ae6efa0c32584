//! Independent contacts that carry a shared load without pulling. The reactions satisfy
//! `Σ aₖ λₖ = F`, λ ≥ 0. Where there are more columns than their rank, a null vector v of A leads
//! to other reactions, in which one of them vanishes (Carathéodory):
//!
//! ```text
//! λ − t v,    A v = 0,    t = λᵢ / vᵢ
//! ```
//!
//! v is the projection of eᵢ on the null space of A, `vᵢ = 1 − aᵢᵀ (A Aᵀ)⁺ aᵢ`. The others replace
//! the contact with the largest vᵢ best; it is left out first. So the feet at the ends of a plank
//! remain.

use nalgebra::{DMatrix, DVector};

use super::modes::ContactMode;
use super::problem::FrictionProblem;
use crate::contact::complementarity::Solution;
use crate::contact::equilibrated_kkt::EquilibratedKkt;
use crate::numerics::decomposition::range;
use crate::numerics::zero::MARGIN;

/// A closed row.
struct Column {
    row: usize,
    /// Its column, bent where its contact slides.
    entries: DVector<f64>,
    /// λ, positive where the contact presses.
    load: f64,
    /// Whether it may not turn negative.
    one_sided: bool,
    /// Whether its contact sticks. It is left out last: others may not hold across.
    sticks: bool,
}

impl EquilibratedKkt {
    /// The closed rows of a motion whose reactions are shared, those that bear it alone first.
    /// `modes` are those of the contacts with friction.
    pub(in crate::contact) fn order_active_basis(
        &self,
        question: &FrictionProblem,
        modes: &[ContactMode],
        found: &Solution,
    ) -> Vec<usize> {
        let mut kept = self.columns(question, modes, found);
        let mut removed = Vec::new();
        while let Some(place) = find_replaceable(&mut kept) {
            removed.push(kept.remove(place).row);
        }
        kept.iter().map(|column| column.row).chain(removed.into_iter().rev()).collect()
    }

    fn columns(&self, question: &FrictionProblem, modes: &[ContactMode], found: &Solution) -> Vec<Column> {
        let load = |row: usize| found.reactions[row] / self.scale[self.n + row];
        let mut columns = Vec::new();
        for (contact, mode) in question.contacts.iter().zip(modes).filter(|(_, mode)| mode.is_closed()) {
            let side = mode.side();
            let entries = match mode.sense() {
                Some(sense) => {
                    self.bent_column(contact.normal, contact.tangent, -side * sense.sign() * contact.mu)
                }
                None => self.column_of(contact.normal),
            };
            let one_sided = !matches!(mode, ContactMode::Guide { .. });
            let (row, load, sticks) = (contact.normal, load(contact.normal), mode.sense().is_none());
            columns.push(Column { row, entries, load, one_sided, sticks });
        }
        // What is borne across stays as it is.
        let is_across = |row: usize| {
            question.contacts.iter().any(|contact| [contact.normal, contact.tangent].contains(&row))
                || question.rows.tied.iter().any(|(tangent, _)| *tangent == row)
        };
        let others = found.tight.iter().copied().filter(|row| !is_across(*row));
        columns.extend(others.map(|row| {
            let one_sided = question.rows.candidates.contains(&row);
            let sticks = question.rows.is_rough(row);
            Column { row, entries: self.column_of(row), load: load(row), one_sided, sticks }
        }));
        columns
    }
}

/// The place of a contact that the others replace, whose load they take; `None` where all are
/// independent.
fn find_replaceable(columns: &mut [Column]) -> Option<usize> {
    let entries: Vec<DVector<f64>> = columns.iter().map(|column| column.entries.clone()).collect();
    let determined = range(&DMatrix::from_columns(&entries).transpose());
    let free = |i: usize| 1.0 - determined.row(i).norm_squared();
    let mut replaceable: Vec<usize> =
        (0..columns.len()).filter(|&i| columns[i].one_sided && free(i) > MARGIN * MARGIN).collect();
    replaceable.sort_by(|&i, &j| columns[i].sticks.cmp(&columns[j].sticks).then(free(j).total_cmp(&free(i))));
    let without = |i: usize| {
        let mut along = &determined * determined.row(i).transpose() * -1.0;
        along[i] += 1.0;
        along
    };
    // How far the load of a column can be taken by others, the first of them to vanish on the way
    // or itself.
    let step = |along: &DVector<f64>| {
        let falls = (0..columns.len()).filter(|&k| columns[k].one_sided && along[k] > 0.0);
        falls.map(|k| (k, columns[k].load.max(0.0) / along[k])).min_by(|a, b| a.1.total_cmp(&b.1))
    };
    let steps: Vec<(usize, usize, f64)> =
        replaceable.iter().filter_map(|&i| step(&without(i)).map(|(k, part)| (i, k, part))).collect();
    let whole = steps.iter().find(|(i, k, _)| i == k).or_else(|| steps.first());
    let &(i, place, part) = whole?;
    let along = without(i);
    columns.iter_mut().zip(along.iter()).for_each(|(column, along)| column.load -= part * along);
    Some(place)
}

#[cfg(test)]
mod tests;
