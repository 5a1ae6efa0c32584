//! The resolved system: points, bodies, supports, coordinates and the mirror by index, every number
//! a series in the parameters. Made only by [`System::resolve`]; what it contains has been checked.

mod beams;
mod bodies;
mod body;
mod checks;
mod circles;
mod constants;
mod constraints;
mod contact_law;
mod coordinates;
mod digits;
mod discs;
mod drives;
mod edges;
mod equal;
mod expression;
mod figure;
mod fold;
mod forces;
mod formula;
mod free;
mod hinges;
mod joint_limits;
mod literal;
mod loads;
mod mass_properties;
mod measure;
mod mirror;
mod mirror_line;
mod names;
mod one_sided;
mod outline;
mod particles;
mod parts;
mod resolve;
mod roots;
mod scope;
mod sections;
mod sides;
mod signals;
mod sliders;
mod springs;
mod supports;
#[cfg(test)]
mod tests;
mod threads;
mod value;
mod welds;

use proc_macro2::Span;
use syn::{Ident, Path, Visibility};

use crate::algebra::{Angle, Series};
use bodies::Structure;

pub use crate::elementary::Elementary;
pub use crate::syntax::ImpactLaw as Law;
pub use crate::syntax::{DefaultValue, RunDeclaration, StartValue};
pub use constants::Definition;
pub use constraints::{Drive, Driven, Guide, Slider, Weld};
pub use loads::{Formula, Function, Load, LoadKind, Operator, Reading, Section, Spring, Switch, Torsion};
pub use names::ParameterNames;
pub use one_sided::{Centre, Edge, Friction, OneSided, Support};
pub use outline::describe_crossing;
pub use signals::Signal;
pub use value::ParameterValues;

pub(crate) use coordinates::measures_the_same;
pub(crate) use expression::whole;
pub(crate) use figure::NEAR;

/// A resolved bar system.
#[derive(Clone, Debug)]
pub struct System {
    /// The struct's name.
    pub ident: Ident,
    /// Where the runtime crate is found.
    pub runtime: Path,
    /// How far the constants with its names are seen; none if there are to be none.
    pub name_constants: Option<Visibility>,
    /// The item's tokens as text.
    pub declaration: String,
    /// The first paragraph of its documentation.
    pub summary: String,
    /// The struct's fields; `Symbol::parameter(i)` is the `i`-th.
    pub parameters: Vec<Ident>,
    /// What each of them means, from its documentation.
    pub meanings: Vec<String>,
    /// Of each the value where nothing else is said.
    pub values: Vec<DefaultValue>,
    /// The run where nothing else is said.
    pub run: RunDeclaration,
    /// Constants derived from parameters; `Symbol::parameter(parameters.len() + i)` is the `i`-th.
    /// Each depends only on those before it.
    pub constants: Vec<Definition>,
    /// Named points.
    pub points: Vec<Point>,
    /// Bars.
    pub bodies: Vec<Body>,
    /// Point masses.
    pub particles: Vec<Particle>,
    /// Discs about points.
    pub discs: Vec<Disc>,
    /// Points held by the ground.
    pub pins: Vec<Pin>,
    /// Directions that keep their difference.
    pub welds: Vec<Weld>,
    /// Points kept on guides.
    pub sliders: Vec<Slider>,
    /// Prescribed motions.
    pub drives: Vec<Drive>,
    /// Springs and dampers between points.
    pub springs: Vec<Spring>,
    /// Springs and dampers between directions.
    pub torsions: Vec<Torsion>,
    /// Applied forces and couples.
    pub loads: Vec<Load>,
    /// What springs and loads act by that do not always.
    pub switches: Vec<Switch>,
    /// What loads and drives follow that is no polynomial of time and motion.
    pub signals: Vec<Signal>,
    /// Sections of bars.
    pub sections: Vec<Section>,
    /// The acceleration of free fall.
    pub gravity: Option<[Series; 2]>,
    /// One-sided constraints: supports and threads.
    pub supports: Vec<Support>,
    /// Coordinates chosen by the user.
    pub coordinates: Vec<Declared>,
    /// Angles kept equal, in pairs.
    pub equal: Vec<Equal>,
    /// Mirror symmetry.
    pub mirror: Option<Mirror>,
    /// Nominal position of every point.
    pub figure: Vec<[Series; 2]>,
    /// What the figure settled, to be checked with a model's own parameters.
    pub settled: Vec<Settled>,
    /// Values of the parameters with which the figure can be drawn; the first are all 1 if it can
    /// be there.
    pub samples: Vec<ParameterValues>,
    /// The most contact sets that get own code.
    pub sets: usize,
}

impl System {
    /// Whether the declaration says nothing of a run.
    pub fn is_without_defaults(&self) -> bool {
        self.values.iter().all(|known| known.value.is_none()) && self.run.is_empty()
    }

    /// Whether springs, dampers or loads that follow the motion act.
    pub fn is_compliant(&self) -> bool {
        let follows = |load: &Load| load.kind.values().iter().any(Formula::reads_motion);
        !self.springs.is_empty() || !self.torsions.is_empty() || self.loads.iter().any(follows)
    }

    /// Whether loads act, or what comes and goes, whose work is no part of the energy.
    pub fn is_loaded(&self) -> bool {
        !self.loads.is_empty() || !self.switches.is_empty()
    }

    /// Whether what a drive prescribes is an angle.
    pub fn is_angle(&self, driven: &Driven) -> bool {
        match *driven {
            Driven::Reading(Reading::Coordinate(i)) => {
                matches!(self.coordinates[i].kind, CoordinateKind::Angle { .. })
            }
            Driven::Reading(Reading::Direction(_)) | Driven::Turn { .. } => true,
            Driven::Reading(Reading::Position(..)) | Driven::Distance { .. } | Driven::Along { .. } => false,
        }
    }

    /// Where a point is in the frame of a body that it belongs to; the frame's origin for any
    /// other.
    pub fn local(&self, body: usize, point: usize) -> [Series; 2] {
        let on = self.points[point].on.iter().find(|(other, _)| *other == body);
        on.map_or_else(|| [Series::zero(), Series::zero()], |(_, local)| local.clone())
    }

    /// The step from the first point of a body to its last in the body's frame, if it is not along
    /// the first axis.
    pub fn oblique(&self, body: usize) -> Option<[Series; 2]> {
        let declared = &self.bodies[body];
        let [from, to] = [declared.from, declared.to].map(|point| self.local(body, point));
        let step = [&to[0] - &from[0], &to[1] - &from[1]];
        (!step[1].is_zero() || step[0] != declared.length).then_some(step)
    }
}

/// Names in a sentence.
pub(crate) fn listed<'a>(names: impl Iterator<Item = &'a String>) -> String {
    names.map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ")
}

/// A named point.
#[derive(Clone, Debug)]
pub struct Point {
    /// Its name.
    pub name: String,
    /// Where it is declared.
    pub span: Span,
    /// The bodies it belongs to, and where on each, in the body's frame: for a bar along and across
    /// (to the left) from its first point.
    pub on: Vec<(usize, [Series; 2])>,
    /// Where the ground holds it, if it is a fixed point and belongs to no body.
    pub ground: Option<[Series; 2]>,
}

/// A rigid body; for a bar the origin of its frame is the first point, the first axis points to the
/// last.
#[derive(Clone, Debug)]
pub struct Body {
    /// Its name.
    pub name: String,
    /// Where it is declared.
    pub span: Span,
    /// Its first point.
    pub from: usize,
    /// Its last point.
    pub to: usize,
    /// Mass.
    pub mass: Series,
    /// Distance between its first and last point.
    pub length: Series,
    /// Distances of its first point from those after the second: a body may be much longer that
    /// way.
    pub extents: Vec<Series>,
    /// Moment of inertia about the centre of mass.
    pub inertia: Series,
    /// The centre of mass in the body's frame: for a bar along and across (to the left) from its
    /// first point.
    pub centre: [Series; 2],
    /// Whether its mass is spread evenly along a bar.
    pub uniform: bool,
    /// Its points in the order declared: a polygon, for a bar its two ends.
    pub outline: Vec<usize>,
}

impl Body {
    /// A bar, or a body of more points.
    pub fn kind(&self) -> &'static str {
        if self.outline.len() > 2 { "body" } else { "bar" }
    }
}

/// A mass at a point.
#[derive(Clone, Debug)]
pub struct Particle {
    /// The point.
    pub point: usize,
    /// Its mass.
    pub mass: Series,
    /// Where it is declared.
    pub span: Span,
}

/// What a body, or a particle, is about a point.
#[derive(Clone, Debug)]
pub struct Disc {
    /// The point.
    pub centre: usize,
    /// The body that it turns with; none of a particle and a fixed point.
    pub body: Option<usize>,
    /// Its radius.
    pub radius: Series,
    /// Where it is declared.
    pub span: Span,
}

/// A point held by the ground.
#[derive(Clone, Debug)]
pub struct Pin {
    /// The point.
    pub point: usize,
    /// Where it is held.
    pub at: [Series; 2],
    /// Where it is declared.
    pub span: Span,
}

/// A coordinate chosen by the user.
#[derive(Clone, Debug)]
pub struct Declared {
    /// Its name.
    pub name: Ident,
    /// What it measures.
    pub kind: CoordinateKind,
}

/// What a coordinate measures.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum CoordinateKind {
    /// direction(body) = reference + sign·q.
    Angle {
        /// The body whose direction it measures.
        body: usize,
        /// From what.
        reference: Reference,
        /// +1 counter-clockwise, −1 clockwise.
        sign: i8,
    },
    /// The position of the point along the axis is sign·q.
    Position {
        /// The point.
        point: usize,
        /// 0 for x, 1 for y.
        axis: usize,
        /// ±1.
        sign: i8,
    },
}

/// What an angle is measured from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Reference {
    /// A constant direction.
    Ground(Angle),
    /// The direction of a body.
    Body(usize),
}

/// What the figure settled for parameters of which only samples are known: with a model's own
/// `length / factor ≥ 0`, a length.
#[derive(Clone, Debug)]
pub struct Settled {
    /// What was settled.
    pub settles: Settles,
    /// Whose it is.
    pub name: String,
    /// Not negative if it holds.
    pub length: Series,
    /// Positive.
    pub factor: Series,
}

/// Kinds of [`Settled`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Settles {
    /// The sign of a coordinate and the end from which it is measured.
    Sign,
    /// The side of a one-sided support.
    Side,
    /// The direction of a body, or its angle with another.
    Direction,
}

/// `factors[0] · left = factors[1] · right`.
#[derive(Clone, Debug)]
pub struct Equal {
    /// How many times each counts; not 0.
    pub factors: [i32; 2],
    /// One angle.
    pub left: ConstrainedAngle,
    /// The other.
    pub right: ConstrainedAngle,
    /// Where the constraint is declared.
    pub span: Span,
}

/// An angle that a constraint names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ConstrainedAngle {
    /// The direction of a body.
    Body(usize),
    /// A declared coordinate, by its index.
    Coordinate(usize),
}

/// Mirror symmetry: the image of each point, body and support.
#[derive(Clone, Debug)]
pub struct Mirror {
    /// 0 for the line x = at, 1 for y = at.
    pub axis: usize,
    /// Where it lies.
    pub at: Series,
    /// Image of each point.
    pub points: Vec<usize>,
    /// Image of each body, and whether its ends are exchanged (the image of `from` is the image's
    /// `to`).
    pub bodies: Vec<(usize, bool)>,
    /// Image of each support.
    pub supports: Vec<usize>,
    /// Where it is declared.
    pub span: Span,
}

impl Mirror {
    /// The sum of the directions of a body and of its image in symmetric motions: π or 0.
    pub fn sum_of_directions(&self, body: usize) -> Angle {
        let half_turn = (self.axis == 0) != self.bodies[body].1;
        Angle::quarters(if half_turn { 2 } else { 0 })
    }
}
