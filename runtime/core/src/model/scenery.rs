//! What stands still.

/// A fixed thing of the scene, for drawings.
#[derive(Clone, Copy, Debug)]
pub struct Scenery {
    /// The support or point it belongs to.
    pub name: &'static str,
    /// Its shape.
    pub shape: Shape,
    /// A point of it.
    pub at: [f64; 2],
}

/// Shapes of [`Scenery`].
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Shape {
    /// A line at `angle` to the horizontal; the free side is the one its normal, `angle + π/2`, points to.
    Line {
        /// Direction of the line, rad.
        angle: f64,
    },
    /// A line that a point is kept on.
    Guide {
        /// Direction of the line, rad.
        angle: f64,
    },
    /// A circle about its place.
    Circle {
        /// Its radius.
        radius: f64,
        /// Whether its inside is free.
        inside: bool,
    },
    /// A corner under a bar.
    Corner,
    /// A pin.
    Pin,
    /// A fixed point.
    Point,
}
