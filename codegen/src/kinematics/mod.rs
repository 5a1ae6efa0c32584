//! Generalised coordinates, and the bodies' directions and positions as Poisson series in them.
//!
//! A point at `(a, c)` along and across a body of direction `δ` whose first point is at `r` lies at
//! `r + a (cos δ, sin δ) + c (−sin δ, cos δ)`. Every `δ` is an integer combination of coordinates.

mod directions;
mod positions;
mod rank;

use proc_macro2::Span;

use crate::algebra::{Angle, Series};
use crate::system::{CoordinateKind, Reference, System};

pub use directions::Directions;
pub use rank::{generic_rank, nominal_values};

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

/// A two-sided constraint that the coordinates do not satisfy by themselves: `equation = 0`.
#[derive(Clone, Debug)]
pub struct Joint {
    /// What it stands for, `pin O (x)`.
    pub name: String,
    /// Vanishes on the constraint.
    pub equation: Series,
    /// Where it was declared.
    pub span: Span,
}

/// Where everything is, as functions of the coordinates.
#[derive(Clone, Debug)]
pub struct Kinematics {
    /// The generalised coordinates; `Symbol::coordinate(i)` is the `i`-th.
    pub coordinates: Vec<Coordinate>,
    /// Direction of each body.
    pub directions: Vec<Angle>,
    /// Position of each point.
    pub points: Vec<[Series; 2]>,
    /// Centre of mass of each body.
    pub centres: Vec<[Series; 2]>,
    /// Closed loops and further pins.
    pub joints: Vec<Joint>,
}

impl Kinematics {
    /// Chooses the coordinates of `system` and places its bodies.
    ///
    /// # Errors
    /// Contradictory or redundant angles, coordinates that are determined already, loops without
    /// mobility, each at its place.
    pub fn of(system: &System) -> syn::Result<Self> {
        let Directions { mut coordinates, directions } = Directions::solve(system)?;
        let placed = positions::place(system, &directions, &mut coordinates)?;
        let centres = system
            .bodies
            .iter()
            .enumerate()
            .map(|(i, body)| offset(&placed.points[body.from], &directions[i], &body.centre))
            .collect();
        let kinematics =
            Self { coordinates, directions, points: placed.points, centres, joints: placed.joints };
        kinematics.check(system)?;
        Ok(kinematics)
    }

    fn check(&self, system: &System) -> syn::Result<()> {
        for coordinate in &self.coordinates {
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

    /// The direction's reading `q = sign (δ − reference)` evaluated on the nominal figure with all
    /// parameters 1.
    pub fn nominal(&self, system: &System) -> Vec<f64> {
        self.coordinates.iter().map(|c| read(system, &c.reading)).collect()
    }
}

/// `r + a e(δ) + c n(δ)`.
pub(crate) fn offset(r: &[Series; 2], direction: &Angle, [along, across]: &[Series; 2]) -> [Series; 2] {
    let (cos, sin) = (Series::cos(direction), Series::sin(direction));
    [&r[0] + &(&(along * &cos) - &(across * &sin)), &r[1] + &(&(along * &sin) + &(across * &cos))]
}

fn read(system: &System, reading: &CoordinateKind) -> f64 {
    match reading {
        CoordinateKind::Position { point, axis, sign } => {
            f64::from(*sign) * system.nominal_number(&system.figure[*point][*axis])
        }
        CoordinateKind::Angle { body, reference, sign } => {
            let from = match reference {
                Reference::Ground(angle) => constant_angle(system, angle),
                Reference::Body(other) => figure_direction(system, *other),
            };
            f64::from(*sign) * wrapped(figure_direction(system, *body) - from)
        }
    }
}

/// Direction of a body in the nominal figure with all parameters 1.
pub(crate) fn figure_direction(system: &System, body: usize) -> f64 {
    let at = |point: usize, axis: usize| system.nominal_number(&system.figure[point][axis]);
    let body = &system.bodies[body];
    (at(body.to, 1) - at(body.from, 1)).atan2(at(body.to, 0) - at(body.from, 0))
}

fn constant_angle(system: &System, angle: &Angle) -> f64 {
    let turns = f64::from(angle.quarter_turns()) * core::f64::consts::FRAC_PI_2;
    angle
        .terms()
        .iter()
        .fold(turns, |sum, &(symbol, k)| sum + f64::from(k) * system.nominal_number(&Series::symbol(symbol)))
}

fn wrapped(angle: f64) -> f64 {
    let turn = core::f64::consts::TAU;
    let rest = angle.rem_euclid(turn);
    if rest > turn / 2.0 + 1e-12 { rest - turn } else { rest }
}
