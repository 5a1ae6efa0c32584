//! One-sided constraints.

use nalgebra::Vector2;

use super::Place;

/// The shapes of a one-sided contact.
#[derive(Clone, Debug)]
pub enum Contact {
    /// gap = n·(P − O): the point P over the line through O with unit normal n.
    Point {
        /// P.
        point: Place,
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
        /// +1 where the bar lies to the left of its axis direction from the corner, −1 on the other
        /// side.
        side: f64,
    },
    /// gap = ±(|P − O| − R): the point P outside (+) or inside (−) the circle about O of radius R.
    Circle {
        /// P.
        point: Place,
        /// O.
        centre: Vector2<f64>,
        /// R.
        radius: f64,
        /// Whether P is kept inside.
        inside: bool,
    },
    /// gap = ℓ − Σ |Pᵢ₊₁ − Pᵢ|: an inextensible thread through points; its reaction is the tension.
    Thread {
        /// P₀, P₁, …
        path: Vec<Place>,
        /// ℓ.
        length: f64,
    },
}

/// A named one-sided contact.
#[derive(Clone, Debug)]
pub struct Support {
    /// Name in the declaration.
    pub name: String,
    /// Its geometry.
    pub contact: Contact,
    /// Whether it admits no slip while closed.
    pub rough: bool,
}
