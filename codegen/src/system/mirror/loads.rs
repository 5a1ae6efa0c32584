//! Springs and applied loads against their mirror images. A couple c has the image −c; of a force
//! the component across the mirror changes its sign, and so does, of one along and across a bar,
//! the component along the bar if the image of the bar is named from its other end, else the
//! component across it.

use proc_macro2::Span;

use super::constraints::joined;
use super::images::{Images, Reflect};
use super::motion::{self, negated};
use crate::algebra::Series;
use crate::system::{Formula, Load, LoadKind, Spring, Torsion};

fn same_resistance(images: &Images, a: [&Option<Formula>; 2], b: [&Option<Formula>; 2]) -> bool {
    let value = |of: &Option<Formula>| of.clone().unwrap_or_else(|| Formula::Constant(Series::zero()));
    a.iter().zip(&b).all(|(a, b)| motion::same(images, &value(a), &value(b)))
}

impl Reflect for Spring {
    const KIND: &'static str = "spring";

    fn named(&self, _: &Images) -> (String, Span) {
        (self.name.clone(), self.span)
    }

    fn image(&self, images: &Images) -> Self {
        Self { ends: self.ends.map(|end| images.pairing.points[end]), ..self.clone() }
    }

    fn meets(&self, other: &Self) -> bool {
        let [a, b] = other.ends;
        [[a, b], [b, a]].contains(&self.ends)
    }

    fn same(&self, other: &Self, images: &Images) -> bool {
        let [a, b] = [self, other].map(|spring| [&spring.stiffness, &spring.damping]);
        self.switch == other.switch
            && same_resistance(images, a, b)
            && motion::same(images, &self.length, &other.length)
    }

    fn describe_location(&self, images: &Images) -> String {
        let [a, b] = self.ends.map(|end| images.pairing.name(end));
        format!("`{a}` and `{b}`")
    }
}

impl Reflect for Torsion {
    const KIND: &'static str = "torsion";

    fn named(&self, _: &Images) -> (String, Span) {
        (self.name.clone(), self.span)
    }

    fn image(&self, images: &Images) -> Self {
        Self {
            body: images.bodies[self.body].0,
            from: self.from.map(|from| images.bodies[from].0),
            angle: negated(&self.angle),
            ..self.clone()
        }
    }

    fn meets(&self, other: &Self) -> bool {
        let [a, b] = [self, other].map(|torsion| (Some(torsion.body), torsion.from));
        a == b || (a.1, a.0) == b
    }

    fn same(&self, other: &Self, images: &Images) -> bool {
        let exchanged = self.body != other.body;
        let angle = if exchanged { negated(&self.angle) } else { self.angle.clone() };
        let turns = [Some(self.body), self.from].into_iter().flatten().filter(|&b| images.half_turn(b));
        let [a, b] = [self, other].map(|torsion| [&torsion.stiffness, &torsion.damping]);
        self.switch == other.switch
            && same_resistance(images, a, b)
            && motion::same_angle(images, [&angle, &other.angle], turns.count() % 2 == 1)
    }

    fn describe_location(&self, images: &Images) -> String {
        joined(images, self.body, self.from)
    }
}

impl Reflect for Load {
    const KIND: &'static str = "load";

    fn named(&self, _: &Images) -> (String, Span) {
        (self.name.clone(), self.span)
    }

    fn image(&self, images: &Images) -> Self {
        let kind = match &self.kind {
            LoadKind::Force { point, frame, value: [x, y] } => {
                let first = match frame {
                    Some(body) => images.bodies[*body].1,
                    None => images.pairing.line.axis == 0,
                };
                let value = if first { [negated(x), y.clone()] } else { [x.clone(), negated(y)] };
                let frame = frame.map(|body| images.bodies[body].0);
                LoadKind::Force { point: images.pairing.points[*point], frame, value }
            }
            LoadKind::Couple { body, from, value } => LoadKind::Couple {
                body: images.bodies[*body].0,
                from: from.map(|from| images.bodies[from].0),
                value: negated(value),
            },
        };
        Self { kind, ..self.clone() }
    }

    fn meets(&self, other: &Self) -> bool {
        match (&self.kind, &other.kind) {
            (LoadKind::Force { point: a, .. }, LoadKind::Force { point: b, .. }) => a == b,
            (LoadKind::Couple { body: a, from, .. }, LoadKind::Couple { body: b, from: other, .. }) => {
                (a, from) == (b, other) || (Some(*a), *from) == (*other, Some(*b))
            }
            _ => false,
        }
    }

    fn same(&self, other: &Self, images: &Images) -> bool {
        match (&self.kind, &other.kind) {
            (
                LoadKind::Force { value: [x, y], frame, .. },
                LoadKind::Force { value: [u, v], frame: other, .. },
            ) => frame == other && motion::same(images, x, u) && motion::same(images, y, v),
            (LoadKind::Couple { body, value, .. }, LoadKind::Couple { body: other, value: there, .. }) => {
                let value = if body == other { value.clone() } else { negated(value) };
                motion::same(images, &value, there)
            }
            _ => false,
        }
    }

    fn describe_location(&self, images: &Images) -> String {
        match &self.kind {
            LoadKind::Force { point, .. } => format!("point `{}`", images.pairing.name(*point)),
            LoadKind::Couple { body, from, .. } => joined(images, *body, *from),
        }
    }
}
