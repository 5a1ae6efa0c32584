//! What the oracle is told: rigid bodies and particles in the plane, what ties them and what acts,
//! in numbers.

use nalgebra::Vector2;

use super::{AngleTie, Couple, Drive, Hinge, Load, Pin, Slider, Spring, Support, Torsion};

/// A rigid body: its frame has its origin at the first point and its first axis towards the second.
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
    /// Centre of mass: along the first axis and across it (to the left), from the first point.
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
#[derive(Clone, Copy, Debug, PartialEq)]
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

/// Where something is: on a body, with a particle, or fixed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Place {
    /// A point of a body.
    Body(Mark),
    /// A particle, by its index.
    Particle(usize),
    /// A point of the ground.
    Ground(Vector2<f64>),
}

impl From<Mark> for Place {
    fn from(mark: Mark) -> Self {
        Self::Body(mark)
    }
}

/// A point mass.
#[derive(Clone, Debug)]
pub struct Particle {
    /// The point of a body that carries it; free if absent.
    pub carrier: Option<Mark>,
    /// Mass.
    pub mass: f64,
}

/// Bodies and everything that acts on them.
#[derive(Clone, Debug, Default)]
pub struct Assembly {
    /// Rigid bodies.
    pub bodies: Vec<Body>,
    /// Point masses.
    pub particles: Vec<Particle>,
    /// Hinges between bodies.
    pub hinges: Vec<Hinge>,
    /// Pins to the ground.
    pub pins: Vec<Pin>,
    /// Constraints between angles.
    pub ties: Vec<AngleTie>,
    /// Points on guides.
    pub sliders: Vec<Slider>,
    /// Prescribed motions.
    pub drives: Vec<Drive>,
    /// One-sided contacts, open or closed as [`Assembly::solve`] is told.
    pub supports: Vec<Support>,
    /// Springs and dampers between points.
    pub springs: Vec<Spring>,
    /// Springs and dampers between directions.
    pub torsions: Vec<Torsion>,
    /// Applied forces.
    pub loads: Vec<Load>,
    /// Applied couples.
    pub couples: Vec<Couple>,
    /// Acceleration of free fall.
    pub gravity: Vector2<f64>,
}

impl Assembly {
    /// Uniform bars of one length, each hinged to the end of the one before.
    pub fn chain(masses: &[f64], length: f64) -> Self {
        let bar = |(k, &mass): (usize, &f64)| Body::uniform(&format!("bar{k}"), mass, length);
        let hinge = |k: usize| Hinge { first: Mark::along(k - 1, length), second: Mark::along(k, 0.0) };
        let hinges = (1..masses.len()).map(hinge).collect();
        Self { bodies: masses.iter().enumerate().map(bar).collect(), hinges, ..Self::default() }
    }

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
