//! What ties bodies to one another and to the ground.

use proc_macro2::Span;

use super::{Formula, Reading};
use crate::algebra::{Angle, Series};

/// Directions that keep their difference: `direction(body) = direction(to) + angle`.
#[derive(Clone, Debug)]
pub struct Weld {
    /// The body that is held.
    pub body: usize,
    /// The body that holds it; the ground if absent.
    pub to: Option<usize>,
    /// The difference.
    pub angle: Angle,
    /// Where it is declared.
    pub span: Span,
}

/// A point kept on a guide, two-sided.
#[derive(Clone, Debug)]
pub struct Slider {
    /// Its name.
    pub name: String,
    /// The point.
    pub point: usize,
    /// What it slides along.
    pub guide: Guide,
    /// Whether it has friction, and its guide is a contact.
    pub rubs: bool,
    /// Where it is declared.
    pub span: Span,
}

/// What a point slides along.
#[derive(Clone, Debug)]
pub enum Guide {
    /// A line of the ground.
    Line {
        /// A point of it.
        through: [Series; 2],
        /// Its direction.
        direction: Angle,
    },
    /// A circle of the ground.
    Circle {
        /// Its centre.
        centre: [Series; 2],
        /// Its radius.
        radius: Series,
        /// 1 over the radius.
        inverse: Series,
    },
    /// The axis of a body: through its first point, in its direction.
    Axis(usize),
}

/// A prescribed motion: what is read equals an expression of time.
#[derive(Clone, Debug)]
pub struct Drive {
    /// Its name: `phi`, `x(P)`, `angle(AB)`, `distance(A, B)`.
    pub name: String,
    /// What is driven.
    pub driven: Driven,
    /// Its value; contains no motion.
    pub value: Formula,
    /// Whether it holds on a condition only: then it is a contact,
    /// [`OneSided::Drive`](super::OneSided::Drive).
    pub switched: bool,
    /// Where it is declared.
    pub span: Span,
}

/// What a drive prescribes.
#[derive(Clone, Debug, PartialEq)]
pub enum Driven {
    /// What is read off the motion.
    Reading(Reading),
    /// The distance of two points, apart in the figure.
    Distance {
        /// The points.
        ends: [usize; 2],
        /// 1 over their distance in the figure.
        inverse: Series,
    },
    /// direction(body) − direction(from).
    Turn {
        /// The body that bears the opposite torque.
        from: usize,
        /// The body.
        body: usize,
    },
    /// How far a point is along a bar, from its first point.
    Along {
        /// The point.
        point: usize,
        /// The bar.
        body: usize,
    },
}
