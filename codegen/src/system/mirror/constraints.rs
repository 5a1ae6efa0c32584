//! Welds, sliders and drives against their mirror images. Where the image of direction δ is H − δ, a weld by a has
//! the image H' − H − a, a drive by f the image H − f; across the mirror x = c the image of x is 2c − x.

use proc_macro2::Span;

use super::images::{Images, Reflect};
use super::motion;
use super::shapes::height;
use crate::algebra::{Angle, Rational};
use crate::system::{Drive, Formula, Guide, Operator, Reading, Slider, Weld};

impl Reflect for Weld {
    const KIND: &'static str = "weld";

    fn named(&self, images: &Images) -> (String, Span) {
        let [body, to] = [Some(self.body), self.to].map(|body| body.map(|body| images.body_name(body)));
        ([to, body].into_iter().flatten().collect::<Vec<_>>().join(", "), self.span)
    }

    fn image(&self, images: &Images) -> Self {
        let turns = [Some(self.body), self.to].into_iter().flatten().filter(|&body| images.half_turn(body));
        Self {
            body: images.bodies[self.body].0,
            to: self.to.map(|to| images.bodies[to].0),
            angle: &Angle::quarters(2 * turns.count() as i64) - &self.angle,
            span: self.span,
        }
    }

    fn meets(&self, other: &Self) -> bool {
        (self.body, self.to) == (other.body, other.to) || self.exchanged(other)
    }

    fn same(&self, other: &Self, _: &Images) -> bool {
        let angle = if self.exchanged(other) { -&self.angle } else { self.angle.clone() };
        angle == other.angle
    }

    fn place(&self, images: &Images) -> String {
        joined(images, self.body, self.to)
    }
}

impl Weld {
    fn exchanged(&self, other: &Self) -> bool {
        (Some(self.body), self.to) == (other.to, Some(other.body))
    }
}

/// Bodies as they are named in a message.
pub(super) fn joined(images: &Images, body: usize, other: Option<usize>) -> String {
    let name = images.body_name(body);
    match other {
        Some(other) => format!("`{}` and `{name}`", images.body_name(other)),
        None => format!("`{name}`"),
    }
}

impl Reflect for Slider {
    const KIND: &'static str = "slider";

    fn named(&self, _: &Images) -> (String, Span) {
        (self.name.clone(), self.span)
    }

    fn image(&self, images: &Images) -> Self {
        let guide = match &self.guide {
            Guide::Line { through, direction } => {
                Guide::Line { through: images.pairing.line.image(through), direction: -direction }
            }
            Guide::Axis(body) => Guide::Axis(images.bodies[*body].0),
        };
        Self { point: images.pairing.points[self.point], guide, ..self.clone() }
    }

    fn meets(&self, other: &Self) -> bool {
        self.point == other.point
    }

    fn same(&self, other: &Self, images: &Images) -> bool {
        match (&self.guide, &other.guide) {
            (Guide::Axis(a), Guide::Axis(b)) => a == b,
            (Guide::Line { through: a, direction }, Guide::Line { through: b, direction: other }) => {
                // A guide has no sense: directions half a turn apart are one.
                let parallel = (direction - other).scale(2) == Angle::zero();
                parallel && images.pairing.same(&height(a, other), &height(b, other))
            }
            _ => false,
        }
    }

    fn place(&self, images: &Images) -> String {
        format!("point `{}`", images.pairing.name(self.point))
    }
}

impl Reflect for Drive {
    const KIND: &'static str = "drive";

    fn named(&self, _: &Images) -> (String, Span) {
        (self.name.clone(), self.span)
    }

    fn image(&self, images: &Images) -> Self {
        let line = images.pairing.line;
        let negative = || motion::negated(&self.value);
        let (reading, value) = match self.reading {
            Reading::Coordinate(_) => (self.reading, self.value.clone()),
            Reading::Direction(body) => (Reading::Direction(images.bodies[body].0), negative()),
            Reading::Position(point, axis) if axis == line.axis => {
                let twice = Box::new(Formula::Constant(line.at.scale(Rational::integer(2))));
                let value = Formula::Join(Operator::Subtract, twice, Box::new(self.value.clone()));
                (Reading::Position(images.pairing.points[point], axis), value)
            }
            Reading::Position(point, axis) => {
                (Reading::Position(images.pairing.points[point], axis), self.value.clone())
            }
        };
        Self { reading, value, ..self.clone() }
    }

    fn meets(&self, other: &Self) -> bool {
        self.reading == other.reading
    }

    fn same(&self, other: &Self, images: &Images) -> bool {
        match self.reading {
            Reading::Direction(body) => {
                motion::same_angle(images, [&self.value, &other.value], images.half_turn(body))
            }
            _ => motion::same(images, &self.value, &other.value),
        }
    }

    fn place(&self, images: &Images) -> String {
        match self.reading {
            Reading::Direction(body) => format!("`angle({})`", images.body_name(body)),
            Reading::Position(point, axis) => {
                format!("`{}({})`", ["x", "y"][axis], images.pairing.name(point))
            }
            Reading::Coordinate(_) => format!("`{}`", self.name),
        }
    }
}
