//! Forces inside: of a joint on one of its bodies, and in a section of a uniform bar.
//!
//! The part of a bar beyond the section at distance s from the first point, of mass m_p, centre C_p
//! and inertia I_p, moves as Newton and Euler say under the force F and the couple M of the part
//! before it:
//!
//! F + Σ F_k + m_p g = m_p C̈_p,  M + Σ (r_k − S) × F_k + (C_p − S) × m_p (g − C̈_p) = I_p α.
//!
//! Along the axis e and its left normal n: normal force N = −F·e (tension positive), shear Q = F·n,
//! bending moment M counter-clockwise, each of the first part on the part beyond.

use nalgebra::Vector2;

use super::state::axes;
use super::{Assembly, Mark, Motion, Place, State};

/// Points of a body nearer than this are one.
const SAME: f64 = 1e-9;

/// What the first part of a bar exerts on the part beyond a section.
#[derive(Clone, Copy, Debug)]
pub struct Internal {
    /// N, tension positive.
    pub normal: f64,
    /// Q, along the left normal.
    pub shear: f64,
    /// M, counter-clockwise.
    pub moment: f64,
}

impl Assembly {
    /// Force on a body at one of its points: of the joint there, which bears whatever else acts at
    /// the point.
    pub fn joint_force(&self, motion: &Motion, mark: Mark) -> Vector2<f64> {
        let here = |place: &Place| matches!(place, Place::Body(at) if at.body == mark.body && (at.local - mark.local).norm() < SAME);
        motion.actions.iter().filter(|(place, _)| here(place)).map(|(_, force)| force).sum()
    }

    /// Internal forces of a uniform bar at a distance from its first point. Couples are taken to
    /// act on the part before the section.
    pub fn internal(&self, state: &State, motion: &Motion, section: Mark) -> Internal {
        let Mark { body, local } = section;
        let bar = &self.bodies[body];
        let beyond = bar.length - local.x;
        let mass = bar.mass * beyond / bar.length;
        let centre = Mark::along(body, local.x + beyond / 2.0);
        let at = self.position(state, section);
        let inertial = (self.acceleration(state, motion, centre) - self.gravity) * mass;
        let mut force = inertial;
        let mut moment = mass * beyond * beyond / 12.0 * motion.angular(body)
            + (self.position(state, centre) - at).perp(&inertial);
        for (place, act) in &motion.actions {
            if matches!(place, Place::Body(mark) if mark.body == body && mark.local.x > local.x) {
                force -= act;
                moment -= (self.position(state, *place) - at).perp(act);
            }
        }
        let [e, n] = axes(state, body);
        Internal { normal: -force.dot(&e), shear: force.dot(&n), moment: -moment }
    }
}
