//! Two-sided constraints.

use super::{Builder, Row};
use crate::tape::{Node, whole};
use liftoff_codegen::system::{Driven, Guide};
use liftoff_core::scalar::Scalar;

impl<S: Scalar> Builder<'_, S> {
    pub(super) fn ties(&mut self) {
        let values: Vec<Node> = [
            self.hinges(),
            self.pins(),
            self.carried(),
            self.welds(),
            self.equal(),
            self.sliders(),
            self.drives(),
        ]
        .concat();
        self.joints = values.into_iter().map(|value| self.row(value)).collect();
    }

    fn hinges(&mut self) -> Vec<Node> {
        let mut all = Vec::new();
        for point in 0..self.system.points.len() {
            for (body, local) in self.system.points[point].on.iter().skip(1) {
                let other = self.on_body(*body, local);
                all.extend(self.difference(other, self.points[point]));
            }
        }
        all
    }

    fn pins(&mut self) -> Vec<Node> {
        let mut all = Vec::new();
        for pin in &self.system.pins {
            let at = self.constants(&pin.at);
            all.extend(self.difference(self.points[pin.point], at));
        }
        all
    }

    /// Particles are where their points are.
    fn carried(&mut self) -> Vec<Node> {
        let mut all = Vec::new();
        for (i, particle) in self.system.particles.iter().enumerate() {
            let at = self.carriers[i];
            let own = [self.tape.position(at), self.tape.position(at + 1)];
            if own != self.points[particle.point] {
                all.extend(self.difference(own, self.points[particle.point]));
            }
        }
        all
    }

    fn welds(&mut self) -> Vec<Node> {
        let welds = self.system.welds.iter();
        welds
            .map(|weld| {
                let angle = self.values.angle(&weld.angle);
                let angle = self.tape.number(angle);
                let turned = self.tape.subtract(self.direction(weld.body), angle);
                weld.to.map_or(turned, |to| self.tape.subtract(turned, self.direction(to)))
            })
            .collect()
    }

    fn equal(&mut self) -> Vec<Node> {
        let system = self.system;
        let pairs = system.equal.iter();
        pairs
            .map(|equal| {
                let [left, right] = [0, 1].map(|k| {
                    let angle = self.angle_of([&equal.left, &equal.right][k]);
                    let factor = self.tape.number(whole(equal.factors[k].into()));
                    self.tape.multiply(factor, angle)
                });
                self.tape.subtract(left, right)
            })
            .collect()
    }

    fn sliders(&mut self) -> Vec<Node> {
        let system = self.system;
        let sliders = system.sliders.iter();
        sliders
            .map(|slider| match &slider.guide {
                Guide::Line { through, direction } => self.height(slider.point, through, direction),
                Guide::Circle { centre, radius, .. } => {
                    let (centre, radius) = (self.constants(centre), self.constant(radius));
                    let square = self.square(centre, self.points[slider.point]);
                    let distance = self.tape.root(square);
                    self.tape.subtract(radius, distance)
                }
                Guide::Axis(body) => {
                    let first = self.points[system.bodies[*body].from];
                    let reach = self.difference(self.points[slider.point], first);
                    let [_, across] = self.axes(*body);
                    self.tape.dot(across, reach)
                }
            })
            .collect()
    }

    fn drives(&mut self) -> Vec<Node> {
        let system = self.system;
        let drives = system.drives.iter();
        drives
            .map(|drive| {
                let value = self.formula(&drive.value);
                let driven = self.driven(&drive.driven);
                self.tape.subtract(driven, value)
            })
            .collect()
    }

    pub(super) fn driven(&mut self, driven: &Driven) -> Node {
        match *driven {
            Driven::Reading(reading) => self.reading(reading),
            Driven::Distance { ends: [a, b], .. } => {
                let square = self.square(self.points[a], self.points[b]);
                self.tape.root(square)
            }
            Driven::Turn { from, body } => self.angle_between(Some(from), body),
            Driven::Along { point, body } => {
                let first = self.points[self.system.bodies[body].from];
                let reach = self.difference(self.points[point], first);
                let [along, _] = self.axes(body);
                self.tape.dot(along, reach)
            }
        }
    }

    /// Reflection of places, and of directions: δ to π − δ or −δ; exchanged ends add π.
    pub(super) fn images(&mut self) -> Vec<Row> {
        let Some(mirror) = &self.system.mirror else { return Vec::new() };
        let mut values = Vec::new();
        let at = self.values.number(&mirror.at);
        let twice = self.tape.number(at + at);
        for (point, &image) in mirror.points.iter().enumerate().filter(|(point, image)| point <= image) {
            let [own, other] = [point, image].map(|point| self.points[point]);
            let (across, along) = (mirror.axis, 1 - mirror.axis);
            let sum = self.tape.add(own[across], other[across]);
            values.push(self.tape.subtract(sum, twice));
            values.push(self.tape.subtract(own[along], other[along]));
        }
        for (body, &(image, reversed)) in mirror.bodies.iter().enumerate() {
            let half_turns = i64::from((mirror.axis == 0) != reversed);
            let sum = self.tape.add(self.direction(body), self.direction(image));
            let turn = self.tape.number(S::pi() * whole(half_turns));
            if body <= image {
                values.push(self.tape.subtract(sum, turn));
            }
        }
        values
            .into_iter()
            .filter(|&value| self.tape.fixed(value).is_none())
            .collect::<Vec<_>>()
            .into_iter()
            .map(|value| self.row(value))
            .collect()
    }
}
