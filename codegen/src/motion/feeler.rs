//! What touches a support: a point, or the rim of a disc about it.

use super::action::{Action, Scene, unit};
use super::dot;
use crate::algebra::Series;
use crate::system::{Disc, Support};

/// A point, and the disc about it if there is one.
pub(super) struct Feeler<'a> {
    pub point: usize,
    disc: Option<&'a Disc>,
}

impl<'a> Feeler<'a> {
    pub fn new(support: &'a Support, point: usize) -> Self {
        Self { point, disc: support.disc.as_ref() }
    }

    /// A gap of the point less the radius.
    pub fn less_radius(&self, gap: Series) -> Series {
        self.disc.map_or(gap.clone(), |disc| &gap - &disc.radius)
    }

    /// Where it touches what pushes along a normal.
    pub fn compute_contact_point(&self, scene: &Scene, normal: &[Series; 2]) -> [Series; 2] {
        let centre = &scene.kinematics.points[self.point];
        match self.disc {
            Some(disc) => [0, 1].map(|axis| &centre[axis] - &(&disc.radius * &normal[axis])),
            None => centre.clone(),
        }
    }

    /// The body that turns with it, and the velocity of its rim for a unit of the body's turning,
    /// times a factor.
    pub fn spin(&self, factor: i8) -> Option<(usize, Series)> {
        let disc = self.disc?;
        Some((disc.body?, disc.radius.scale(crate::algebra::Rational::integer(factor.into()))))
    }

    /// A force where it touches what pushes along a normal.
    pub fn bear(&self, scene: &Scene, normal: &[Series; 2], force: [Series; 2]) -> Action {
        match self.disc.and_then(|disc| disc.body) {
            Some(body) => {
                apply_force(scene, (body, self.point), self.compute_contact_point(scene, normal), force)
            }
            None => Action::at_point(scene, self.point, force),
        }
    }
}

/// A force at a place of a body, of which a point is known.
pub(super) fn apply_force(
    scene: &Scene,
    (body, point): (usize, usize),
    place: [Series; 2],
    force: [Series; 2],
) -> Action {
    let step = [0, 1].map(|axis| &place[axis] - &scene.kinematics.points[point][axis]);
    let along = dot(&unit(&scene.kinematics.directions[body]), &step);
    let along = &scene.system.local(body, point)[0] + &along;
    Action::at_place(body, place, along, force)
}
