//! What is read off the motion: coordinates, directions, positions.

use super::{Builder, Row, SceneError};
use crate::tape::{Node, Tape, whole};
use liftoff_codegen::algebra::{Angle, Series};
use liftoff_codegen::system::{ConstrainedAngle, CoordinateKind, Reading, Reference};
use liftoff_core::scalar::Scalar;

impl<S: Scalar> Builder<'_, S> {
    /// A coordinate of the public state: a declared one, or `theta_AB`, `x_A`, `y_A`.
    pub(super) fn public(&mut self, name: &str) -> Result<Row, SceneError> {
        let declared = self.system.coordinates.iter().position(|c| c.name == name);
        let value = match declared {
            Some(i) => Some(self.coordinate(i)),
            None => self.unnamed(name),
        };
        let value = value.ok_or_else(|| SceneError::Coordinate(name.to_owned()))?;
        Ok(self.row(value))
    }

    fn unnamed(&mut self, name: &str) -> Option<Node> {
        let (kind, of) = name.split_once('_')?;
        let point = |builder: &Self| builder.system.points.iter().position(|point| point.name == of);
        match kind {
            "theta" => {
                let body = self.system.bodies.iter().position(|body| body.name == of)?;
                Some(self.direction(body))
            }
            "x" => point(self).map(|point| self.points[point][0]),
            "y" => point(self).map(|point| self.points[point][1]),
            _ => None,
        }
    }

    fn coordinate(&mut self, i: usize) -> Node {
        let signed = |builder: &mut Self, value: Node, sign: i8| {
            let sign = builder.tape.number(whole(sign.into()));
            builder.tape.multiply(sign, value)
        };
        match self.system.coordinates[i].kind {
            CoordinateKind::Angle { body, ref reference, sign } => {
                let from = match reference {
                    Reference::Ground(angle) => {
                        let angle = self.values.angle(angle);
                        self.tape.number(angle)
                    }
                    Reference::Body(other) => self.direction(*other),
                };
                let turned = self.tape.subtract(self.direction(body), from);
                signed(self, turned, sign)
            }
            CoordinateKind::Position { point, axis, sign } => signed(self, self.points[point][axis], sign),
        }
    }

    pub(super) fn reading(&mut self, reading: Reading) -> Node {
        match reading {
            Reading::Coordinate(i) => self.coordinate(i),
            Reading::Direction(body) => self.angle_between(None, body),
            Reading::Position(point, axis) => self.points[point][axis],
        }
    }

    /// The direction of a body, or its angle from another, within half a turn at the figure.
    pub(super) fn angle_between(&mut self, from: Option<usize>, to: usize) -> Node {
        let to = self.direction(to);
        let turned = from.map_or(to, |from| self.tape.subtract(to, self.direction(from)));
        let turns = self.tape.adjustable();
        self.turned.push((turned, turns));
        self.tape.subtract(turned, turns)
    }

    pub(super) fn angle_of(&mut self, direction: &ConstrainedAngle) -> Node {
        match *direction {
            ConstrainedAngle::Body(body) => self.direction(body),
            ConstrainedAngle::Coordinate(i) => self.coordinate(i),
        }
    }

    /// n · (P − O), n a quarter turn counter-clockwise from a direction.
    pub(super) fn height(&mut self, point: usize, through: &[Series; 2], direction: &Angle) -> Node {
        let through = self.constants(through);
        let reach = self.difference(self.points[point], through);
        let [_, normal] = self.unit(direction);
        self.tape.dot(normal, reach)
    }

    /// A constant direction and its left normal; exact along the axes.
    pub(super) fn unit(&mut self, direction: &Angle) -> [[Node; 2]; 2] {
        let (mut sin, mut cos) = self.values.angle(direction).sin_cos();
        if direction.terms().is_empty() {
            let quarter: (i64, i64) =
                [(0, 1), (1, 0), (0, -1), (-1, 0)][usize::from(direction.quarter_turns() % 4)];
            (sin, cos) = (whole(quarter.0), whole(quarter.1));
        }
        let [sin, cos] = [sin, cos].map(|x| self.tape.number(x));
        [[cos, sin], [self.tape.negate(sin), cos]]
    }

    /// |b − a|².
    pub(super) fn square(&mut self, a: [Node; 2], b: [Node; 2]) -> Node {
        let reach = self.difference(b, a);
        self.tape.dot(reach, reach)
    }

    pub(super) const NOTHING: Node = Tape::<S>::ZERO;
}
