//! Welds, sliders and drives against their mirror images. Where the image of direction δ is H − δ,
//! a weld by a has the image H' − H − a, a drive by f the image H − f; across the mirror x = c the
//! image of x is 2c − x.

use proc_macro2::Span;

use super::images::{Images, Reflect};
use super::motion;
use super::shapes::height;
use crate::algebra::{Angle, Rational, Series};
use crate::system::{Drive, Driven, Formula, Guide, Operator, Reading, Slider, Weld};

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

    fn describe_location(&self, images: &Images) -> String {
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
            Guide::Circle { centre, radius, inverse } => Guide::Circle {
                centre: images.pairing.line.image(centre),
                radius: radius.clone(),
                inverse: inverse.clone(),
            },
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
            (Guide::Circle { centre: a, radius: r, .. }, Guide::Circle { centre: b, radius: s, .. }) => {
                let same = |a, b| images.pairing.same(a, b);
                same(&a[0], &b[0]) && same(&a[1], &b[1]) && same(r, s)
            }
            (Guide::Line { through: a, direction }, Guide::Line { through: b, direction: other }) => {
                // A guide has no sense: directions half a turn apart are one.
                let parallel = (direction - other).scale(2) == Angle::zero();
                parallel && images.pairing.same(&height(a, other), &height(b, other))
            }
            _ => false,
        }
    }

    fn describe_location(&self, images: &Images) -> String {
        format!("point `{}`", images.pairing.name(self.point))
    }
}

impl Reflect for Drive {
    const KIND: &'static str = "drive";

    fn named(&self, _: &Images) -> (String, Span) {
        (self.name.clone(), self.span)
    }

    fn image(&self, images: &Images) -> Self {
        let (driven, value) = match self.driven {
            Driven::Reading(reading) => {
                let (reading, value) = self.reflected(images, reading);
                (Driven::Reading(reading), value)
            }
            Driven::Distance { ends, ref inverse } => {
                let [a, b] = ends.map(|end| images.pairing.points[end]);
                let ends = [a.min(b), a.max(b)];
                (Driven::Distance { ends, inverse: inverse.clone() }, self.value.clone())
            }
            Driven::Turn { from, body } => {
                let [from, body] = [from, body].map(|body| images.bodies[body].0);
                (Driven::Turn { from, body }, motion::negated(&self.value))
            }
            Driven::Along { point, body } => {
                let (image, reversed) = images.bodies[body];
                let value = if reversed {
                    self.less_than(&images.pairing.structure.bodies[body].length)
                } else {
                    self.value.clone()
                };
                (Driven::Along { point: images.pairing.points[point], body: image }, value)
            }
        };
        Self { driven, value, ..self.clone() }
    }

    fn meets(&self, other: &Self) -> bool {
        match (&self.driven, &other.driven) {
            (Driven::Distance { ends: a, .. }, Driven::Distance { ends: b, .. }) => a == b,
            (a, b) => a == b,
        }
    }

    fn same(&self, other: &Self, images: &Images) -> bool {
        let half_turn = match self.driven {
            Driven::Reading(Reading::Direction(body)) => images.half_turn(body),
            Driven::Turn { from, body } => images.half_turn(from) != images.half_turn(body),
            _ => return motion::same(images, &self.value, &other.value),
        };
        motion::same_angle(images, [&self.value, &other.value], half_turn)
    }

    fn describe_location(&self, images: &Images) -> String {
        let point = |point: usize| images.pairing.name(point);
        match self.driven {
            Driven::Reading(Reading::Direction(body)) => format!("`angle({})`", images.body_name(body)),
            Driven::Reading(Reading::Position(at, axis)) => format!("`{}({})`", ["x", "y"][axis], point(at)),
            Driven::Reading(Reading::Coordinate(_)) => format!("`{}`", self.name),
            Driven::Distance { ends: [a, b], .. } => format!("`distance({}, {})`", point(a), point(b)),
            Driven::Turn { from, body } => {
                format!("`angle({}, {})`", images.body_name(from), images.body_name(body))
            }
            Driven::Along { point: at, body } => {
                format!("`along({}, {})`", point(at), images.body_name(body))
            }
        }
    }
}

impl Drive {
    /// What is read in the mirror, and its value there.
    fn reflected(&self, images: &Images, reading: Reading) -> (Reading, Formula) {
        let line = images.pairing.line;
        match reading {
            Reading::Coordinate(_) => (reading, self.value.clone()),
            Reading::Direction(body) => {
                (Reading::Direction(images.bodies[body].0), motion::negated(&self.value))
            }
            Reading::Position(point, axis) => {
                let image = Reading::Position(images.pairing.points[point], axis);
                let across = axis == line.axis;
                let twice = || line.at.scale(Rational::integer(2));
                (image, if across { self.less_than(&twice()) } else { self.value.clone() })
            }
        }
    }

    fn less_than(&self, whole: &Series) -> Formula {
        let whole = Box::new(Formula::Constant(whole.clone()));
        Formula::Join(Operator::Subtract, whole, Box::new(self.value.clone()))
    }
}
