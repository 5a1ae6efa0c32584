//! Hinges with friction: a journal of radius r in its bearing, which it touches on the line of the
//! hinge force F. The slip is `v = r ω`, the reaction `N = |F|`, so that `R = −μ N sign v` is the
//! couple r R. The row of N has no entries: the hinge holds without it, and F is a joint force of
//! the motion.

use super::action::{Action, Scene};
use super::measured::Measured;
use super::row::Row;
use super::{MOST_HINGES, Motion};
use crate::algebra::Series;
use crate::system::{OneSided, System};

/// The body that turns, what it turns against, and the radius of the journal.
pub(super) fn measure(scene: &Scene, body: usize, from: Option<usize>, radius: &Series) -> Measured {
    let n = scene.n();
    let turn = |i: usize| {
        let against = from.map_or_else(Series::zero, |from| scene.turn(from, i));
        radius * &(&scene.turn(body, i) - &against)
    };
    let slip = Row::tangential((0..n).map(turn).collect(), Series::zero());
    let couple = Action::couple(scene, body, from, radius.clone());
    let back = from.map(|from| Action::couple(scene, from, Some(body), -radius));
    let actions = [Vec::new(), core::iter::once(couple).chain(back).collect()];
    let row = Row::tangential(vec![Series::zero(); n], Series::zero());
    Measured { row, foot: None, tangent: Some(slip), actions }
}

impl Motion {
    /// The places of both components of its force among the quantities, of each hinge with
    /// friction.
    ///
    /// # Errors
    /// Hinges whose friction is not known here.
    pub(super) fn hinge_forces(&mut self, system: &System) -> syn::Result<()> {
        let mut errors: Option<syn::Error> = None;
        let mut count = 0;
        for i in 0..self.contacts.len() {
            let support = self.contacts[i].support(system);
            let OneSided::Hinge { point, body, .. } = support.contact else { continue };
            count += 1;
            let names = format!("{}, {}", system.points[point].name, system.bodies[body].name);
            let place = |axis: &str| {
                let name = format!("{axis}({names})");
                self.quantities.iter().position(|quantity| quantity.name == name)
            };
            let error = match (place("fx"), place("fy")) {
                _ if count > MOST_HINGES => {
                    format!("a model has at most {MOST_HINGES} hinges with friction; this is one more")
                }
                _ if self.is_prescribed(i) => format!(
                    "what turns at hinge `{}` is welded or driven, so that friction has no effect; remove the friction",
                    support.name
                ),
                (Some(x), Some(y)) if self.long_tree().is_none() => {
                    self.contacts[i].force = Some([x, y]);
                    continue;
                }
                _ => format!(
                    "the force at hinge `{}`, which its friction follows, is not known in a model of so many bodies or where contacts share \
                     a load; leave the friction out",
                    support.name
                ),
            };
            super::combine(&mut errors, syn::Error::new(support.span, error));
        }
        errors.map_or(Ok(()), Err)
    }

    /// Whether the slip of a hinge is zero, or a joint's row.
    fn is_prescribed(&self, contact: usize) -> bool {
        let Some(tangent) = self.contacts[contact].tangents.first() else { return true };
        let slip = &tangent.row.jacobian;
        let along = |row: &Row| {
            let across = |(i, a): (usize, &Series)| {
                let minors = slip[i + 1..].iter().zip(&row.jacobian[i + 1..]);
                minors.into_iter().all(|(b, d)| a * d == &row.jacobian[i] * b)
            };
            slip.iter().enumerate().all(across) && row.jacobian.iter().any(|entry| !entry.is_zero())
        };
        let joints = &self.rows[self.contacts.len()..self.slips()];
        slip.iter().all(Series::is_zero) || joints.iter().any(along)
    }

    /// Whether hinges have friction.
    pub fn has_hinges(&self) -> bool {
        self.contacts.iter().any(|contact| contact.force.is_some())
    }
}
