//! Many contacts: a solution by Lemke's method on few of them at a time. A solution with some
//! contacts left open that nothing presses on is one of all, so contacts are taken in only where
//! one does: of redundant contacts, however many, those that bear are enough.
//!
//! A contact whose limit of sticking is above its kinetic friction is taken to slide where it
//! cannot stick at its limit. A rough contact is taken to stick; those that open are released with
//! their tangents. What is found is checked by the equations with these contacts closed.

use super::modes::{ContactMode, SlipDirection};
use super::planar_lcp::Shape;
use super::problem::{ActiveRows, BalancedProblem, Candidate};
use crate::contact::trials::LcpError;

/// Up to this many contacts are taken in at once.
const FEW: usize = 12;

/// What is assumed of the contacts.
struct Assumed {
    /// Those taken in.
    within: Vec<usize>,
    /// Those that slide although their limit is above their kinetic friction.
    broken: Vec<(usize, SlipDirection)>,
    /// Rough ones that open.
    released: Vec<usize>,
}

impl BalancedProblem<'_> {
    /// A solution, if this finds one.
    pub(super) fn pivot(&self) -> Result<Option<Candidate>, LcpError> {
        let Some(shapes) = self.shapes() else { return Ok(None) };
        let mut assumed =
            Assumed { within: self.first_within(&shapes), broken: Vec::new(), released: Vec::new() };
        for _ in 0..3 * self.units.len() + 1 {
            self.question.rows.attempt()?;
            let Some(chosen) = self.with(&shapes, &assumed) else { return Ok(None) };
            if self.revise(&chosen, &mut assumed) {
                continue;
            }
            let choices: Vec<_> = self.units.iter().zip(&chosen).map(|(unit, &k)| &unit.choices[k]).collect();
            let Some(trial) = self.attempt(&choices)? else { return Ok(None) };
            let violated = |&at: &usize| !self.holds(&self.units[at], choices[at], &trial);
            let violated: Vec<usize> = (0..self.units.len()).filter(violated).collect();
            if violated.is_empty() {
                return Ok(Some(Candidate { acting: self.modes(&chosen), chosen, trial }));
            }
            if violated.iter().any(|at| assumed.within.contains(at)) {
                return Ok(None);
            }
            let opening = |at: &usize| self.kkt.opening(self.units[*at].normal, &trial.a);
            let worst = violated.iter().copied().min_by(|a, b| opening(a).total_cmp(&opening(b)));
            assumed.within.extend(worst);
        }
        Ok(None)
    }

    /// How each contact that is not decided enters.
    fn shapes(&self) -> Option<Vec<Option<Shape>>> {
        let shape = |unit: &super::problem::Unit| match unit.choices.len() {
            1 => Some(None),
            _ => unit.shape().map(Some),
        };
        self.units.iter().map(shape).collect()
    }

    /// All, or those that bear without friction and those that act whatever is found.
    fn first_within(&self, shapes: &[Option<Shape>]) -> Vec<usize> {
        let open: Vec<usize> = (0..shapes.len()).filter(|&at| shapes[at].is_some()).collect();
        if open.len() <= FEW {
            return open;
        }
        let normals: Vec<usize> = open.iter().map(|&at| self.units[at].normal).collect();
        let two_sided = self.held(shapes, &[]).rows;
        let bearing =
            self.kkt.least_constraint().and_then(|least| least.find_active_basis(&two_sided, &normals));
        let Ok(bearing) = bearing else { return open };
        let acts = |at: usize| matches!(shapes[at], Some(Shape::Brink(_))) || self.units[at].given.is_some();
        open.into_iter().filter(|&at| acts(at) || bearing.contains(&self.units[at].normal)).collect()
    }

    /// The modes of all contacts with those taken in solved for.
    fn with(&self, shapes: &[Option<Shape>], assumed: &Assumed) -> Option<Vec<usize>> {
        let broken = |at: usize| assumed.broken.iter().find(|(unit, _)| *unit == at);
        let shape = |at: usize| match broken(at) {
            Some((_, sense)) => Some(Shape::Normal { closed: ContactMode::Slide(*sense) }),
            None => shapes[at],
        };
        let within: Vec<_> =
            assumed.within.iter().filter_map(|&at| shape(at).map(|shape| (at, shape))).collect();
        let rough = |at: &usize| {
            self.question.rows.is_rough(self.units[*at].normal) && !assumed.released.contains(at)
        };
        let rough: Vec<usize> =
            assumed.within.iter().copied().filter(rough).map(|at| self.units[at].normal).collect();
        let kinetic = |at: usize| match broken(at) {
            None if matches!(shapes[at], Some(Shape::Rest)) => self.units[at].limit,
            _ => self.units[at].mu,
        };
        let found = self.lemke(&within, &self.held(shapes, &rough), &kinetic)?;
        let mode = |at: usize| match (found.iter().find(|(unit, _)| *unit == at), shapes[at]) {
            (Some((_, mode)), _) => *mode,
            (None, None) => self.units[at].choices[0].mode,
            (None, Some(_)) => ContactMode::Open,
        };
        let place = |at: usize| self.units[at].choices.iter().position(|choice| choice.mode == mode(at));
        (0..self.units.len()).map(place).collect()
    }

    /// The rows that are closed whatever is found: two-sided ones, contacts that are decided or at
    /// their brink, and tangents of rough contacts.
    fn held(&self, shapes: &[Option<Shape>], rough: &[usize]) -> ActiveRows {
        let mode = |at: usize| match shapes[at] {
            None => self.units[at].choices[0].mode,
            Some(Shape::Brink(sense)) => ContactMode::Slide(sense),
            Some(_) => ContactMode::Open,
        };
        let mut held = self.closed(&(0..shapes.len()).map(mode).collect::<Vec<_>>());
        held.rows.extend(self.question.rows.tied_to(rough));
        held
    }

    /// Takes in what modes say against what was assumed.
    fn revise(&self, chosen: &[usize], assumed: &mut Assumed) -> bool {
        let mut revised = false;
        for (at, unit) in self.units.iter().enumerate() {
            let mode = unit.choices[chosen[at]].mode;
            let is_known = assumed.broken.iter().any(|(other, _)| *other == at);
            match mode {
                ContactMode::Slide(sense) if unit.limit > unit.mu && unit.choices.len() > 2 && !is_known => {
                    assumed.broken.push((at, sense));
                    revised = true;
                }
                ContactMode::Open
                    if self.question.rows.is_rough(unit.normal)
                        && assumed.within.contains(&at)
                        && !assumed.released.contains(&at) =>
                {
                    assumed.released.push(at);
                    revised = true;
                }
                _ => {}
            }
        }
        revised
    }
}

#[cfg(test)]
mod tests;
