//! The coordinates of the nominal figure.

use super::ParameterProgram;
use crate::Analysis;
use crate::program::Id;
use crate::system::{self, CoordinateKind};

/// How the coordinates follow from the places of the points.
#[derive(Clone, Debug)]
pub struct Nominal {
    /// What they are made of.
    pub numbers: ParameterProgram,
    /// One by one.
    pub readings: Vec<NominalReading>,
}

/// What a coordinate reads, opposite where it is counted the other way.
#[derive(Clone, Copy, Debug)]
pub enum NominalReading {
    /// A number.
    Position {
        /// Which.
        number: usize,
        /// Whether it is counted the other way.
        is_opposite: bool,
    },
    /// The angle between two directions.
    Angle {
        /// From where.
        from: NominalReference,
        /// To where.
        to: NominalDirection,
        /// Whether it is counted the other way.
        is_opposite: bool,
    },
}

/// Where an angle begins.
#[derive(Clone, Copy, Debug)]
pub enum NominalReference {
    /// At a number.
    Ground(usize),
    /// At the direction of a body.
    Body(NominalDirection),
}

/// The direction of a body: between two points, less that of an own line of the body which they are
/// on.
#[derive(Clone, Copy, Debug)]
pub struct NominalDirection {
    /// The numbers of the two points, x and y of each.
    pub seen: [[usize; 2]; 2],
    /// Those of the same points in the body's own frame, where it is oblique.
    pub own: Option<[[usize; 2]; 2]>,
}

impl Nominal {
    pub(super) fn lower(analysis: &Analysis) -> Self {
        let system = &analysis.system;
        let frames: Vec<usize> =
            (0..system.bodies.len()).filter(|&body| system.oblique(body).is_some()).collect();
        let numbers = ParameterProgram::lower(system, |lowering| {
            let mut ids: Vec<Id> = system.figure.iter().flatten().map(|s| lowering.series(s)).collect();
            for body in &frames {
                let of = system.local(*body, system.bodies[*body].from);
                let to = system.local(*body, system.bodies[*body].to);
                ids.extend(of.iter().chain(&to).map(|s| lowering.series(s)));
            }
            for coordinate in &analysis.kinematics.coordinates {
                ids.push(match &coordinate.reading {
                    CoordinateKind::Angle { reference: system::Reference::Ground(angle), .. } => {
                        lowering.angle(angle)
                    }
                    _ => lowering.program().integer(0),
                });
            }
            ids
        });
        let locals = 2 * system.figure.len();
        let references = locals + 4 * frames.len();
        let direction = |body: usize| {
            let place = |point: usize| [2 * point, 2 * point + 1];
            let frame = frames.iter().position(|&frame| frame == body).map(|at| locals + 4 * at);
            NominalDirection {
                seen: [place(system.bodies[body].from), place(system.bodies[body].to)],
                own: frame.map(|k| [[k, k + 1], [k + 2, k + 3]]),
            }
        };
        let readings =
            analysis.kinematics.coordinates.iter().zip(references..).map(|(coordinate, constant)| {
                match &coordinate.reading {
                    CoordinateKind::Position { point, axis, sign } => {
                        NominalReading::Position { number: 2 * point + axis, is_opposite: *sign < 0 }
                    }
                    CoordinateKind::Angle { body, reference, sign } => {
                        let from = match reference {
                            system::Reference::Ground(_) => NominalReference::Ground(constant),
                            system::Reference::Body(other) => NominalReference::Body(direction(*other)),
                        };
                        NominalReading::Angle { from, to: direction(*body), is_opposite: *sign < 0 }
                    }
                }
            });
        Self { readings: readings.collect(), numbers }
    }
}
