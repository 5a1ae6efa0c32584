//! What acts beside gravity.

use nalgebra::Vector2;

use super::{Formula, Place};

/// A force at a place.
#[derive(Clone, Debug)]
pub struct Load {
    /// Point of attack.
    pub at: Place,
    /// Its components.
    pub force: [Formula; 2],
    /// The body along and across which they are; the ground if absent.
    pub frame: Option<usize>,
}

impl Load {
    /// A constant force.
    pub fn constant(at: impl Into<Place>, force: Vector2<f64>) -> Self {
        Self { at: at.into(), force: [force.x, force.y].map(Formula::Constant), frame: None }
    }
}

/// A couple, counter-clockwise.
#[derive(Clone, Debug)]
pub struct Couple {
    /// The body that bears it.
    pub on: usize,
    /// The body that bears the opposite.
    pub from: Option<usize>,
    /// Its value.
    pub value: Formula,
}

/// A spring, a damper or both between two points: tension k (r − ℓ₀) + c ṙ at distance r.
#[derive(Clone, Debug)]
pub struct Spring {
    /// Its ends.
    pub ends: [Place; 2],
    /// k.
    pub stiffness: f64,
    /// ℓ₀.
    pub length: f64,
    /// c.
    pub damping: f64,
}

/// A torsion spring, a damper or both: torque −k (Δ − a) − c Δ̇ on `on`, Δ = θ_on − θ_from.
#[derive(Clone, Debug)]
pub struct Torsion {
    /// The body.
    pub on: usize,
    /// The body that bears the opposite torque; the ground (θ = 0) if absent.
    pub from: Option<usize>,
    /// k.
    pub stiffness: f64,
    /// a.
    pub angle: f64,
    /// c.
    pub damping: f64,
}
