//! Groups of contacts that the mass matrix does not couple are struck apart, and decided apart:
//! where the Delassus matrix W = J M̂⁻¹ Jᵀ, M̂⁻¹ with the two-sided rows taken in, has no entries
//! between the rows of two contacts, neither knows of the other. Each group has its own law; what
//! changes the rates without contacts, impulses from outside and two-sided rows that take hold, is
//! counted once.

use std::collections::{BTreeMap, BTreeSet};

use nalgebra::DVector;

use super::impact::Stages;
use super::impulse::{Collision, CollisionError, Group, Outcome, Row};
use super::least_constraint::{LeastConstraint, add_change};
use super::trials::Trials;

impl Collision {
    /// The outcomes of the groups together; `None` where all contacts are coupled, or where a group
    /// does not determine its rates without the others, as where a point has no mass.
    pub(super) fn solve_groups<const ROUGH: bool>(
        &self,
        most_trials: usize,
    ) -> Result<Option<Outcome>, CollisionError> {
        let groups = self.find_groups();
        if groups.len() < 2 {
            return Ok(None);
        }
        match self.join_groups::<ROUGH>(groups, most_trials) {
            Err(CollisionError::Singular) => Ok(None),
            joined => joined,
        }
    }

    /// The same with all contacts open but some.
    pub(super) fn with_contacts(&self, contacts: &[usize]) -> Self {
        let opened = |(i, row): (usize, &Row)| match row {
            Row::Contact { .. } | Row::Guide if !contacts.contains(&i) => Row::Open,
            other => *other,
        };
        Self { rows: self.rows.iter().enumerate().map(opened).collect(), ..self.clone() }
    }

    fn find_groups(&self) -> Vec<Vec<usize>> {
        let normal = |&(row, part): &(usize, &Row)| match *part {
            Row::Contact { .. } | Row::Guide => Some((row, row)),
            Row::Tangent { of } | Row::Friction { of, .. } => {
                matches!(self.rows[of], Row::Contact { .. } | Row::Guide).then_some((row, of))
            }
            Row::Open | Row::TwoSided => None,
        };
        let rows: Vec<(usize, usize)> = self.rows.iter().enumerate().filter_map(|it| normal(&it)).collect();
        let contacts: Vec<usize> = rows.iter().filter(|(row, of)| row == of).map(|(row, _)| *row).collect();
        let Some(least) = (if contacts.len() < 2 { None } else { self.at_rest() }) else {
            return vec![contacts];
        };
        least.find_groups(&self.two_sided(), &rows)
    }

    fn join_groups<const ROUGH: bool>(
        &self,
        groups: Vec<Vec<usize>>,
        most_trials: usize,
    ) -> Result<Option<Outcome>, CollisionError> {
        let approach = Stages::new(self, Trials::up_to(most_trials)).approach;
        let takes_hold = self.two_sided().iter().any(|&row| approach[row] != 0.0);
        let is_driven = takes_hold || self.applied.amax() > 0.0;
        let without =
            if is_driven { Some(self.with_contacts(&[]).solve_alone::<ROUGH>(most_trials)?) } else { None };
        let strikes =
            |&row: &usize| approach[row] < 0.0 || self.rows[row] == Row::Guide && approach[row] != 0.0;
        let active = groups.into_iter().filter(|group| is_driven || group.iter().any(strikes));
        let solve = |contacts: Vec<usize>| {
            let outcome = self.with_contacts(&contacts).solve_alone::<ROUGH>(most_trials)?;
            Ok(Group { contacts, outcome })
        };
        let groups = active.map(solve).collect::<Result<Vec<_>, CollisionError>>()?;
        let Some(first) = groups.first() else { return Ok(None) };
        let (rates, impulses, opening) = match &without {
            Some(it) => (&it.rates, &it.impulses, &it.opening),
            None => (&self.rates, &DVector::zeros(self.rows.len()), &approach),
        };
        let joined = |of: fn(&Outcome) -> &DVector<f64>, before: &DVector<f64>| {
            groups.iter().fold(before.clone(), |sum, group| add_change(&sum, before, of(&group.outcome)))
        };
        let mut outcome = Outcome {
            rates: joined(|it| &it.rates, rates),
            impulses: joined(|it| &it.impulses, impulses),
            opening: opening.clone(),
            ..first.outcome.clone()
        };
        for (row, part) in self.rows.iter().enumerate() {
            let of = if let Row::Tangent { of } | Row::Friction { of, .. } = *part { of } else { row };
            if let Some(group) = groups.iter().find(|group| group.contacts.contains(&of)) {
                outcome.opening[row] = group.outcome.opening[row];
            }
        }
        if groups.len() > 1 {
            let outcomes = || groups.iter().map(|group| &group.outcome);
            outcome.compression = None;
            outcome.acting = outcomes().flat_map(|it| it.acting.iter().copied()).collect();
            outcome.acting.sort_unstable();
            outcome.factor = outcomes().map(|it| it.factor).fold(1.0, f64::min);
            outcome.unique = outcomes().all(|it| it.unique);
            outcome.gained = outcomes().map(|it| it.gained).sum();
            outcome.solutions = outcomes().map(|it| it.solutions).product();
            outcome.groups = groups;
        }
        Ok(Some(outcome))
    }
}

impl LeastConstraint {
    /// Contacts in groups that nothing couples but through others of their group, each group in
    /// ascending order; of the rows along which they act, (row, contact).
    pub(super) fn find_groups(&self, fixed: &[usize], rows: &[(usize, usize)]) -> Vec<Vec<usize>> {
        let acting: Vec<usize> = rows.iter().map(|(row, _)| *row).collect();
        let directions = self.free_directions(fixed, &acting);
        let contacts: BTreeSet<usize> = rows.iter().map(|(_, contact)| *contact).collect();
        let contacts: Vec<usize> = contacts.into_iter().collect();
        let place_of: BTreeMap<usize, usize> =
            rows.iter().filter_map(|(row, of)| Some((*row, contacts.binary_search(of).ok()?))).collect();
        let places: Vec<usize> = directions.iter().map(|(row, _)| place_of[row]).collect();
        // The first contact of the group that each is in.
        let mut first: Vec<usize> = (0..contacts.len()).collect();
        for (k, (_, one)) in directions.iter().enumerate() {
            for (l, (_, other)) in directions.iter().enumerate().skip(k + 1) {
                let [kept, joined] = [k, l].map(|it| first[places[it]]);
                if kept != joined && Collision::are_coupled(one, other) {
                    let both = first.iter_mut().filter(|it| [kept, joined].contains(it));
                    both.for_each(|it| *it = kept.min(joined));
                }
            }
        }
        let group =
            |of: usize| (0..contacts.len()).filter(|&it| first[it] == of).map(|it| contacts[it]).collect();
        (0..contacts.len()).filter(|&it| first[it] == it).map(group).collect()
    }
}
