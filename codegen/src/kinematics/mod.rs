//! Generalised coordinates, and the bodies' directions and positions as Poisson series in them.
//!
//! A point at `(a, c)` along and across a body of direction `δ` whose first point is at `r` lies at
//! `r + a (cos δ, sin δ) + c (−sin δ, cos δ)`. Every `δ` is an integer combination of coordinates.

mod affine;
mod closures;
mod directions;
mod guides;
mod positions;
mod rank;
mod relations;
mod start;

use proc_macro2::Span;

use crate::algebra::{Angle, Series};
use crate::system::{Body, CoordinateKind, ParameterValues, Reference, Settled, System};
use positions::Placed;

pub use directions::Directions;
pub(crate) use guides::height;
pub(crate) use rank::dependent;
pub use rank::nominal_values;

/// A generalised coordinate of the resolved system.
#[derive(Clone, Debug)]
pub struct Coordinate {
    /// Its name.
    pub name: String,
    /// How its value is read off a figure.
    pub reading: CoordinateKind,
}

impl Coordinate {
    /// Whether it is an angle.
    pub fn is_angle(&self) -> bool {
        matches!(self.reading, CoordinateKind::Angle { .. })
    }
}

/// A declared angle that follows coordinates: `quarters` π/2 + Σ factor parameter + Σ factor
/// coordinate.
#[derive(Clone, Debug)]
pub struct DependentAngle {
    /// What is declared.
    pub declared: Coordinate,
    /// Quarter turns; in the nominal figure it is within half a turn.
    pub quarters: i32,
    /// Parameters, each with its factor.
    pub parameters: Vec<(usize, i32)>,
    /// Coordinates, each with its factor.
    pub coordinates: Vec<(usize, i32)>,
}

/// A two-sided constraint that the coordinates do not satisfy by themselves: `equation = 0`.
#[derive(Clone, Debug)]
pub struct Joint {
    /// What it stands for, `pin O (x)`.
    pub name: String,
    /// Vanishes on the constraint; of a drive, `Symbol::opaque(i)` is the prescribed value of the
    /// `i`-th.
    pub equation: Series,
    /// What it holds.
    pub kind: JointKind,
    /// Where it was declared.
    pub span: Span,
}

impl Joint {
    /// Whether its equation is of angles: that of a drive that turns.
    pub fn is_angle(&self, system: &System) -> bool {
        matches!(self.kind, JointKind::Drive(drive) if system.is_angle(&system.drives[drive].driven))
    }
}

/// What a joint holds, and so where its force acts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum JointKind {
    /// A point of a body at the same point of the body that owns it, along an axis.
    Hinge {
        /// The point.
        point: usize,
        /// The body that closes the loop.
        body: usize,
        /// 0 for x, 1 for y.
        axis: usize,
    },
    /// A point at its place on the ground, along an axis.
    Pin {
        /// The point.
        point: usize,
        /// 0 for x, 1 for y.
        axis: usize,
    },
    /// A point on its guide.
    Slider(usize),
    /// A prescribed motion.
    Drive(usize),
}

/// How the bodies hang together: each is reached from a root by one of its points.
#[derive(Clone, Debug)]
pub struct SpanningTree {
    /// The point by which each body is reached.
    pub entry: Vec<usize>,
    /// The body through which each point is reached; none for roots and points of the ground.
    pub owner: Vec<Option<usize>>,
    /// The root of each point's component.
    pub root: Vec<usize>,
}

/// Where everything is, as functions of the coordinates.
#[derive(Clone, Debug)]
pub struct Kinematics {
    /// The generalised coordinates; `Symbol::coordinate(i)` is the `i`-th.
    pub coordinates: Vec<Coordinate>,
    /// Declared angles that follow them.
    pub dependent: Vec<DependentAngle>,
    /// Direction of each body.
    pub directions: Vec<Angle>,
    /// Position of each point.
    pub points: Vec<[Series; 2]>,
    /// Centre of mass of each body.
    pub centres: Vec<[Series; 2]>,
    /// Closed loops, further pins, sliders and drives.
    pub joints: Vec<Joint>,
    /// The tree that the loops close.
    pub tree: SpanningTree,
    /// What the figure said of directions, to be checked with a model's own parameters.
    pub settled: Vec<Settled>,
}

impl Kinematics {
    /// Chooses the coordinates of `system` and places its bodies.
    ///
    /// # Errors
    /// Contradictory or redundant angles, coordinates that are determined already, loops without
    /// mobility, each at its place.
    pub fn derive(system: &System) -> syn::Result<Self> {
        let Directions { mut coordinates, dependent, directions, settled } = Directions::solve(system)?;
        let placed = positions::place_points(system, &directions, &mut coordinates)?;
        let Placed { points, joints, tree } = placed;
        let centres = Vec::new();
        let mut kinematics =
            Self { coordinates, dependent, directions, points, centres, joints, tree, settled };
        kinematics.centres = system
            .bodies
            .iter()
            .enumerate()
            .map(|(i, body)| kinematics.compute_position(system, i, &body.centre))
            .collect();
        kinematics.guide(system);
        kinematics.check(system)?;
        Ok(kinematics)
    }

    /// Where a point of a body's frame is.
    pub fn compute_position(&self, system: &System, body: usize, local: &[Series; 2]) -> [Series; 2] {
        let entry = self.tree.entry[body];
        let first = system.local(body, entry);
        let step = [&local[0] - &first[0], &local[1] - &first[1]];
        offset(&self.points[entry], &self.directions[body], &step)
    }

    fn check(&self, system: &System) -> syn::Result<()> {
        let dependent = self.dependent.iter().map(|angle| &angle.declared);
        for coordinate in self.coordinates.iter().chain(dependent) {
            if let Some(field) = system.parameters.iter().find(|p| *p == &coordinate.name) {
                let text = format!(
                    "parameter `{}` has the name of a generalised coordinate; rename it",
                    coordinate.name
                );
                return Err(syn::Error::new(field.span(), text));
            }
        }
        rank::check_mobility(system, self)
    }

    /// The direction's reading `q = sign (δ − reference)` evaluated on the nominal figure, with the
    /// parameters of a sample.
    pub fn nominal(&self, system: &System, numbers: &ParameterValues) -> Vec<f64> {
        self.coordinates.iter().map(|c| evaluate_reading(system, numbers, &c.reading)).collect()
    }
}

/// `r + a e(δ) + c n(δ)`.
pub(crate) fn offset(r: &[Series; 2], direction: &Angle, [along, across]: &[Series; 2]) -> [Series; 2] {
    let (cos, sin) = (Series::cos(direction), Series::sin(direction));
    [&r[0] + &(&(along * &cos) - &(across * &sin)), &r[1] + &(&(along * &sin) + &(across * &cos))]
}

fn evaluate_reading(system: &System, numbers: &ParameterValues, reading: &CoordinateKind) -> f64 {
    match reading {
        CoordinateKind::Position { point, axis, sign } => {
            f64::from(*sign) * numbers.evaluate(&system.figure[*point][*axis])
        }
        CoordinateKind::Angle { body, reference, sign } => {
            let from = match reference {
                Reference::Ground(angle) => {
                    angle.evaluate(&|symbol| numbers.evaluate(&Series::symbol(symbol)))
                }
                Reference::Body(other) => figure_direction(system, numbers, *other),
            };
            f64::from(*sign) * wrapped(figure_direction(system, numbers, *body) - from)
        }
    }
}

/// Direction of a body in the nominal figure.
fn figure_direction(system: &System, numbers: &ParameterValues, body: usize) -> f64 {
    let at = |point: usize, axis: usize| numbers.evaluate(&system.figure[point][axis]);
    let Body { from, to, .. } = system.bodies[body];
    let [across, along] = [1, 0].map(|axis| {
        let local = |point| numbers.evaluate(&system.local(body, point)[axis]);
        local(to) - local(from)
    });
    (at(to, 1) - at(from, 1)).atan2(at(to, 0) - at(from, 0)) - across.atan2(along)
}

fn wrapped(angle: f64) -> f64 {
    let turn = core::f64::consts::TAU;
    let rest = angle.rem_euclid(turn);
    if rest > turn / 2.0 + 1e-12 { rest - turn } else { rest }
}
