//! Where points are: P = C + R(θ) (p − c), p and c in the frame of a body.

use super::{Builder, Values};
use crate::tape::{Node, Tape};
use liftoff_codegen::algebra::Series;
use liftoff_codegen::system::System;
use liftoff_core::scalar::Scalar;

impl<'a, S: Scalar> Builder<'a, S> {
    pub(super) fn new(system: &'a System, parameters: &[f64], n: usize) -> Self {
        let values = Values::new(system, parameters);
        let tape = Tape::new(n);
        let bodies = 3 * system.bodies.len();
        let carriers = (0..system.particles.len()).map(|i| bodies + 2 * i).collect();
        let mut builder = Self {
            system,
            values,
            tape,
            points: Vec::new(),
            carriers,
            joints: Vec::new(),
            forces: vec![Tape::<S>::ZERO; n],
            potential: Tape::<S>::ZERO,
            turned: Vec::new(),
        };
        builder.points = (0..system.points.len()).map(|point| builder.locate(point)).collect();
        builder
    }

    /// θ of a body.
    pub(super) fn direction(&self, body: usize) -> Node {
        self.tape.position(3 * body + 2)
    }

    /// The first axis of a body, and the second to its left.
    pub(super) fn axes(&mut self, body: usize) -> [[Node; 2]; 2] {
        let [sin, cos] = self.tape.sin_cos(self.direction(body));
        [[cos, sin], [self.tape.negate(sin), cos]]
    }

    /// Where a point of a body's frame is.
    pub(super) fn on_body(&mut self, body: usize, local: &[Series; 2]) -> [Node; 2] {
        let centre = &self.system.bodies[body].centre;
        let reach = [0, 1].map(|axis| self.values.number(&local[axis]) - self.values.number(&centre[axis]));
        let [along, across] = reach.map(|x| self.tape.number(x));
        let [first, second] = self.axes(body);
        [0, 1].map(|axis| {
            let step = self.tape.dot([along, across], [first[axis], second[axis]]);
            let centre = self.tape.position(3 * body + axis);
            self.tape.add(centre, step)
        })
    }

    /// The coordinates of the first particle at a point.
    pub(super) fn particle(&self, point: usize) -> Option<usize> {
        self.system.particles.iter().position(|particle| particle.point == point).map(|i| self.carriers[i])
    }

    fn locate(&mut self, point: usize) -> [Node; 2] {
        let declared = &self.system.points[point];
        if let Some(at) = &declared.ground {
            return self.constants(at);
        }
        if let Some((body, local)) = declared.on.first() {
            return self.on_body(*body, local);
        }
        let at = self.particle(point).unwrap_or(0);
        [self.tape.position(at), self.tape.position(at + 1)]
    }

    /// Where a point is held, if it is; else where it is.
    pub(super) fn held(&mut self, point: usize) -> ([Node; 2], bool) {
        let pin = self.system.pins.iter().find(|pin| pin.point == point);
        let ground = self.system.points[point].ground.as_ref();
        match pin.map(|pin| &pin.at).or(ground) {
            Some(at) => (self.constants(at), true),
            None => (self.points[point], false),
        }
    }

    pub(super) fn masses(&self) -> Vec<S> {
        let bodies = self.system.bodies.iter().flat_map(|body| {
            let mass = self.values.number(&body.mass);
            [mass, mass, self.values.number(&body.inertia)]
        });
        let particles = self.system.particles.iter().flat_map(|particle| {
            let mass = self.values.number(&particle.mass);
            [mass, mass]
        });
        bodies.chain(particles).collect()
    }

    pub(super) fn length(&self) -> f64 {
        let bodies = self.system.bodies.iter().map(|body| self.values.number(&body.length).to_f64());
        let largest = bodies.fold(0.0, f64::max);
        if largest > 0.0 {
            return largest;
        }
        let figure = self.system.figure.iter().flatten().map(|x| self.values.number(x).abs().to_f64());
        let extents = self.system.supports.iter().filter_map(|support| support.extent());
        let extents = extents.map(|(_, extent)| self.values.number(extent).to_f64());
        let largest = figure.chain(extents).fold(0.0, f64::max);
        if largest > 0.0 { largest } else { 1.0 }
    }

    /// Coordinates of the figure; angles to doubles only, as a first guess.
    pub(super) fn figure(&self) -> Vec<S> {
        let at = |point: usize| self.values.pair(&self.system.figure[point]);
        let mut all = Vec::new();
        for (i, body) in self.system.bodies.iter().enumerate() {
            let local = [body.from, body.to].map(|point| self.values.pair(&self.system.local(i, point)));
            let place = [body.from, body.to].map(at);
            let turned = |[a, b]: [[S; 2]; 2]| (b[1] - a[1]).to_f64().atan2((b[0] - a[0]).to_f64());
            let theta = S::from_f64(turned(place) - turned(local));
            let (sin, cos) = theta.sin_cos();
            let centre = self.values.pair(&body.centre);
            let [x, y] = [centre[0] - local[0][0], centre[1] - local[0][1]];
            all.extend([place[0][0] + cos * x - sin * y, place[0][1] + sin * x + cos * y, theta]);
        }
        all.extend(self.system.particles.iter().flat_map(|particle| at(particle.point)));
        all
    }
}
