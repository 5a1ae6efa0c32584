//! What the oracle is told: rigid bodies in the plane and what ties them, all in numbers.

use nalgebra::Vector2;

/// A rigid bar: its frame has its origin at the first point and its first axis along the bar.
#[derive(Clone, Debug)]
pub struct Body {
    /// Name in the declaration.
    pub name: String,
    /// Mass.
    pub mass: f64,
    /// Moment of inertia about the centre of mass.
    pub inertia: f64,
    /// Distance of the second point from the first.
    pub length: f64,
    /// Centre of mass: along the bar and across it (to the left), from the first point.
    pub centre: Vector2<f64>,
}

impl Body {
    /// A uniform bar: centre in the middle, I = m l²/12.
    pub fn uniform(name: &str, mass: f64, length: f64) -> Self {
        Self {
            name: name.into(),
            mass,
            inertia: mass * length * length / 12.0,
            length,
            centre: Vector2::new(length / 2.0, 0.0),
        }
    }
}

/// A point fixed to a body, in the body's frame.
#[derive(Clone, Copy, Debug)]
pub struct Mark {
    /// Index of the body.
    pub body: usize,
    /// Along and across, from the body's first point.
    pub local: Vector2<f64>,
}

impl Mark {
    /// The point of body `body` at a distance from its first point, on its axis.
    pub fn along(body: usize, distance: f64) -> Self {
        Self { body, local: Vector2::new(distance, 0.0) }
    }
}

/// A point mass carried by a body.
#[derive(Clone, Debug)]
pub struct Particle {
    /// Where it sits.
    pub at: Mark,
    /// Mass.
    pub mass: f64,
}

/// Two points that stay together.
#[derive(Clone, Debug)]
pub struct Hinge {
    /// The point whose body receives [`Motion::hinges`](super::Motion::hinges).
    pub first: Mark,
    /// The point whose body receives the opposite force.
    pub second: Mark,
}

/// A point that stays at a place of the ground.
#[derive(Clone, Debug)]
pub struct Pin {
    /// The point.
    pub at: Mark,
    /// The place.
    pub ground: Vector2<f64>,
}

/// The two shapes of a one-sided contact.
#[derive(Clone, Debug)]
pub enum Contact {
    /// gap = n·(P − O): the point P over the line through O with unit normal n.
    Point {
        /// P.
        point: Mark,
        /// O.
        through: Vector2<f64>,
        /// n, towards the free side.
        normal: Vector2<f64>,
    },
    /// gap = ±n·(A − K): a corner K beside the axis of a bar with first point A and left normal n.
    Corner {
        /// The bar.
        body: usize,
        /// K.
        corner: Vector2<f64>,
        /// +1 where the bar lies to the left of its axis direction from the corner, −1 on the other side.
        side: f64,
    },
}

/// A named one-sided contact.
#[derive(Clone, Debug)]
pub struct Support {
    /// Name in the declaration.
    pub name: String,
    /// Its geometry.
    pub contact: Contact,
}

/// Σ cᵢ θᵢ = value over body angles.
#[derive(Clone, Debug)]
pub struct AngleTie {
    /// (body, cᵢ).
    pub terms: Vec<(usize, f64)>,
    /// Right-hand side.
    pub value: f64,
}

/// A force of constant direction and magnitude at a point of a body.
#[derive(Clone, Debug)]
pub struct Load {
    /// Point of attack.
    pub at: Mark,
    /// The force.
    pub force: Vector2<f64>,
}

/// Bodies and everything that acts on them.
#[derive(Clone, Debug, Default)]
pub struct Assembly {
    /// Bars.
    pub bodies: Vec<Body>,
    /// Point masses.
    pub particles: Vec<Particle>,
    /// Hinges between bodies.
    pub hinges: Vec<Hinge>,
    /// Pins to the ground.
    pub pins: Vec<Pin>,
    /// One-sided contacts, open or closed as [`Assembly::solve`] is told.
    pub supports: Vec<Support>,
    /// Constraints between angles.
    pub ties: Vec<AngleTie>,
    /// Applied forces.
    pub loads: Vec<Load>,
    /// Acceleration of free fall.
    pub gravity: Vector2<f64>,
}

impl Assembly {
    /// The body of a name.
    pub fn body(&self, name: &str) -> Option<usize> {
        self.bodies.iter().position(|body| body.name == name)
    }

    /// The support of a name.
    pub fn support(&self, name: &str) -> Option<usize> {
        self.supports.iter().position(|support| support.name == name)
    }

    /// The second end of a body.
    pub fn end(&self, body: usize) -> Mark {
        Mark::along(body, self.bodies[body].length)
    }
}
