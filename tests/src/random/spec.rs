//! A bar system as drawn, before it is written down in either form.

use std::collections::BTreeMap;

use super::parameters::Parameters;
use super::parts::{Manner, Parts};
use super::quantity::Quantity;

/// A pair of expressions: x and y, or along and across.
pub type Pair = [Quantity; 2];

/// cos = p/r, sin = q/r: directions whose figure is exact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Heading {
    pub p: i32,
    pub q: i32,
    pub r: i32,
}

impl Heading {
    pub fn angle(self) -> f64 {
        f64::from(self.q).atan2(f64::from(self.p))
    }

    pub fn slanted(self) -> bool {
        self.p != 0 && self.q != 0
    }

    /// along (cos, sin) + across (−sin, cos), added to a position.
    pub fn walk(self, from: &Pair, along: &Quantity, across: &Quantity) -> Pair {
        let step = |start: &Quantity, a: i32, b: i32| add(&add(start, along, a, self.r), across, b, self.r);
        [step(&from[0], self.p, -self.q), step(&from[1], self.q, self.p)]
    }
}

/// start + by p/r.
fn add(start: &Quantity, by: &Quantity, p: i32, r: i32) -> Quantity {
    if p == 0 || by.is_zero() {
        return start.clone();
    }
    let part = by.scaled(p.abs(), r);
    match (start.is_zero(), p > 0) {
        (true, true) => part,
        (true, false) => part.negated(),
        (false, true) => start.plus(&part),
        (false, false) => start.minus(&part),
    }
}

/// One bar, alone or as the link of a chain.
#[derive(Clone, Debug)]
pub struct Bar {
    pub name: String,
    pub from: String,
    pub to: String,
    pub mass: Quantity,
    pub length: Quantity,
    pub inertia: Option<Quantity>,
    /// Along, and across where given.
    pub centre: Option<(Quantity, Option<Quantity>)>,
    pub heading: Heading,
    /// Index of the chain it belongs to.
    pub chain: Option<usize>,
    /// The third corner of a triangle and its place in the bar's frame.
    pub corner: Option<(String, Pair)>,
}

/// A chain of bars.
#[derive(Clone, Debug)]
pub struct Chain {
    pub name: String,
    pub links: usize,
    pub last: Option<String>,
    /// Whether its points are given in the figure.
    pub drawn: bool,
}

/// A named point on a bar.
#[derive(Clone, Debug)]
pub struct Spot {
    pub name: String,
    pub bar: usize,
    pub along: Quantity,
    pub across: Option<Quantity>,
}

/// The shapes of supports.
#[derive(Clone, Debug)]
pub enum Shape {
    Floor(Option<Quantity>),
    /// Place, free side (+1 right), whether it is said or left to the figure.
    Wall {
        at: Quantity,
        side: f64,
        said: bool,
    },
    Slope {
        angle: Quantity,
        through: Option<Pair>,
    },
    /// A corner below (+1) or above a bar.
    Corner {
        bar: usize,
        at: Pair,
        under: bool,
    },
    /// The circle's centre and radius; whether the point is kept inside.
    Circle {
        centre: Pair,
        radius: Quantity,
        inside: bool,
    },
    /// Between two lines of this angle, this far apart, a point midway between them.
    Slot {
        angle: Quantity,
        through: Pair,
        width: Quantity,
    },
}

/// A one-sided support; of a bar for corners, else of a point.
#[derive(Clone, Debug)]
pub struct SupportSpec {
    pub name: String,
    pub point: String,
    pub shape: Shape,
    pub manner: Manner,
}

/// Where a declared angle is counted from.
#[derive(Clone, Debug)]
pub enum Origin {
    /// `horizontal` or `vertical`.
    Line(&'static str),
    /// `right`, `up`, `left`, `down` as quarter turns; whether counted clockwise.
    Direction(usize, bool),
    /// Another bar.
    Bar(usize),
}

/// A declared coordinate.
#[derive(Clone, Debug)]
pub enum Declared {
    Angle { name: String, bar: usize, origin: Origin },
    Position { name: String, point: String, axis: usize, negative: bool },
}

/// Angles kept equal: of two bars in the same direction, or of two declared coordinates.
#[derive(Clone, Copy, Debug)]
pub enum Tie {
    Bars(usize, usize),
    Coordinates(usize, usize),
}

/// The acceleration of free fall.
#[derive(Clone, Debug)]
pub enum Gravity {
    None,
    Down(Quantity),
    Vector(Pair),
}

/// The line x = at (axis 0) or y = at (axis 1) across which the second half of the bars is the
/// image of the first.
#[derive(Clone, Debug)]
pub struct Mirror {
    pub axis: usize,
    pub at: Quantity,
    /// Number of bars on either side.
    pub half: usize,
    /// The only point on the line.
    pub root: String,
    /// Points and their images.
    pub images: Vec<(String, String)>,
    /// Whether the pairs are written down; they have to be where the figure does not tell them.
    pub said: bool,
    /// Whether the images are given in the figure.
    pub drawn: bool,
}

impl Mirror {
    /// Direction of the image of a bar.
    pub fn angle(&self, angle: f64) -> f64 {
        if self.axis == 0 { std::f64::consts::PI - angle } else { -angle }
    }
}

/// Everything drawn.
#[derive(Clone, Debug)]
pub struct Spec {
    pub parameters: Parameters,
    pub gravity: Gravity,
    pub bars: Vec<Bar>,
    pub chains: Vec<Chain>,
    pub spots: Vec<Spot>,
    pub masses: Vec<(String, Quantity)>,
    pub pins: Vec<String>,
    pub supports: Vec<SupportSpec>,
    pub ties: Vec<Tie>,
    pub coordinates: Vec<Declared>,
    pub mirror: Option<Mirror>,
    pub parts: Parts,
    /// Position of each point in the nominal figure.
    pub figure: BTreeMap<String, Pair>,
}

impl Spec {
    /// The bars a point belongs to, with its place on each.
    pub fn on(&self, point: &str) -> Vec<(usize, Pair)> {
        let zero = Quantity::literal(0);
        let mut found = Vec::new();
        for (index, bar) in self.bars.iter().enumerate() {
            if bar.from == point {
                found.push((index, [zero.clone(), zero.clone()]));
            }
            if bar.to == point {
                found.push((index, [bar.length.clone(), zero.clone()]));
            }
            if let Some((_, place)) = bar.corner.iter().find(|(name, _)| name == point) {
                found.push((index, place.clone()));
            }
        }
        for spot in self.spots.iter().filter(|spot| spot.name == point) {
            let across = spot.across.clone().unwrap_or_else(|| zero.clone());
            found.push((spot.bar, [spot.along.clone(), across]));
        }
        found
    }
}
