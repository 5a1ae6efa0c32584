//! What a spec has beside bars, pins, masses, supports and equal angles.

use super::expression::Expression;
use super::quantity::Quantity;
use super::spec::Pair;

/// direction(second) − direction(first), or direction(first) itself, stays what it is in the
/// figure.
#[derive(Clone, Copy, Debug)]
pub struct Weld {
    pub first: usize,
    pub second: Option<usize>,
    /// The angle as quarter turns.
    pub quarters: i32,
    /// Whether the angle is written down.
    pub said: bool,
}

/// A point on a guide.
#[derive(Clone, Debug)]
pub struct SliderSpec {
    pub name: String,
    pub point: String,
    pub track: Track,
}

/// What a point slides along.
#[derive(Clone, Debug)]
pub enum Track {
    Horizontal(Quantity),
    Vertical(Quantity),
    Line(Quantity, Pair),
    Bar(usize),
}

/// A spring, a damper or both.
#[derive(Clone, Debug)]
pub struct SpringSpec {
    pub name: String,
    pub ends: [String; 2],
    pub stiffness: Option<Quantity>,
    pub length: Option<Quantity>,
    pub damping: Option<Quantity>,
}

/// The same between directions: of `first` from the right, or of `second` from `first`.
#[derive(Clone, Debug)]
pub struct TorsionSpec {
    pub first: usize,
    pub second: Option<usize>,
    pub stiffness: Option<Quantity>,
    pub angle: Option<Quantity>,
    pub damping: Option<Quantity>,
}

/// A force at a point.
#[derive(Clone, Debug)]
pub struct Force {
    pub name: String,
    pub point: String,
    pub value: [Expression; 2],
    pub frame: Option<usize>,
}

/// A couple.
#[derive(Clone, Debug)]
pub struct CoupleSpec {
    pub name: String,
    pub on: usize,
    pub from: Option<usize>,
    pub value: Expression,
}

/// A prescribed motion.
#[derive(Clone, Debug)]
pub struct DriveSpec {
    pub target: Target,
    pub value: Expression,
}

/// What is driven.
#[derive(Clone, Debug)]
pub enum Target {
    /// A declared coordinate.
    Coordinate(usize),
    /// The direction of a bar.
    Direction(usize),
    /// The position of a point along an axis.
    Position(String, usize),
}

/// A section of a bar.
#[derive(Clone, Debug)]
pub struct Section {
    pub name: String,
    pub bar: usize,
    pub at: Quantity,
}

/// How a support or thread acts.
#[derive(Clone, Debug, Default)]
pub struct Manner {
    pub rough: bool,
    pub restitution: Option<Quantity>,
    pub poisson: bool,
}

/// A thread from point to point.
#[derive(Clone, Debug)]
pub struct Thread {
    pub name: String,
    pub path: Vec<String>,
    pub length: Quantity,
    pub manner: Manner,
}

/// Everything of this kind in a spec.
#[derive(Clone, Debug, Default)]
pub struct Parts {
    /// Free point masses.
    pub particles: Vec<(String, Quantity)>,
    /// Points of the ground, placed by the figure.
    pub grounds: Vec<String>,
    pub welds: Vec<Weld>,
    pub sliders: Vec<SliderSpec>,
    pub springs: Vec<SpringSpec>,
    pub torsions: Vec<TorsionSpec>,
    pub forces: Vec<Force>,
    pub couples: Vec<CoupleSpec>,
    pub drives: Vec<DriveSpec>,
    pub sections: Vec<Section>,
    pub threads: Vec<Thread>,
}
