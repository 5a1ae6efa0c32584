//! What acts beside the constraints: weight, springs, dampers, loads.

use super::Builder;
use crate::tape::Node;
use liftoff_codegen::system::{LoadKind, Spring, Torsion};
use liftoff_core::scalar::Scalar;

impl<S: Scalar> Builder<'_, S> {
    pub(super) fn loads(&mut self) {
        let system = self.system;
        self.weights();
        system.springs.iter().for_each(|spring| self.spring(spring));
        system.torsions.iter().for_each(|torsion| self.torsion(torsion));
        for load in &system.loads {
            match &load.kind {
                LoadKind::Force { point, frame, value } => {
                    let mut force = value.each_ref().map(|formula| self.formula(formula));
                    if let Some(body) = frame {
                        let [first, second] = self.axes(*body);
                        force = [0, 1].map(|axis| self.tape.dot(force, [first[axis], second[axis]]));
                    }
                    for axis in 0..2 {
                        self.push(self.points[*point][axis], force[axis]);
                    }
                }
                LoadKind::Couple { body, from, value } => {
                    let couple = self.formula(value);
                    self.turn(*body, *from, couple);
                }
            }
        }
    }

    /// A force along what grows with positions.
    fn push(&mut self, along: Node, force: Node) {
        for (i, slope) in self.tape.gradient(along) {
            let part = self.tape.multiply(slope, force);
            self.forces[i] = self.tape.add(self.forces[i], part);
        }
    }

    fn turn(&mut self, on: usize, from: Option<usize>, couple: Node) {
        self.push(self.direction(on), couple);
        if let Some(from) = from {
            let opposite = self.tape.negate(couple);
            self.push(self.direction(from), opposite);
        }
    }

    fn weights(&mut self) {
        let Some(gravity) = &self.system.gravity else { return };
        let gravity = self.values.pair(gravity);
        let bodies = self.system.bodies.iter().enumerate().map(|(i, body)| (3 * i, &body.mass));
        let particles = self.system.particles.iter().zip(&self.carriers);
        let particles = particles.map(|(particle, &at)| (at, &particle.mass));
        let all: Vec<_> = bodies.chain(particles).collect();
        for (at, mass) in all {
            let mass = self.values.number(mass);
            for axis in 0..2 {
                let weight = self.tape.number(mass * gravity[axis]);
                self.forces[at + axis] = self.tape.add(self.forces[at + axis], weight);
                let work = self.tape.multiply(weight, self.tape.position(at + axis));
                self.potential = self.tape.subtract(self.potential, work);
            }
        }
    }

    /// Of natural length 0 the tension k r is along r as such: no root.
    fn spring(&mut self, spring: &Spring) {
        let [a, b] = spring.ends.map(|point| self.held(point).0);
        let square = self.square(a, b);
        let length = self.formula(&spring.length);
        let half = self.tape.number(S::ratio(1, 2));
        if let Some(stiffness) = &spring.stiffness {
            let stiffness = self.formula(stiffness);
            if length == Self::NOTHING {
                let bulge = self.tape.multiply(half, square);
                let pull = self.tape.negate(stiffness);
                self.push(bulge, pull);
                self.store(stiffness, square);
            } else {
                let distance = self.tape.root(square);
                let stretch = self.tape.subtract(distance, length);
                let tension = self.tape.multiply(stiffness, stretch);
                let pull = self.tape.negate(tension);
                self.push(distance, pull);
                let squared = self.tape.multiply(stretch, stretch);
                self.store(stiffness, squared);
            }
        }
        if let Some(damping) = &spring.damping {
            let damping = self.formula(damping);
            let distance = self.tape.root(square);
            let rate = self.tape.rate(distance);
            let tension = self.tape.multiply(damping, rate);
            let pull = self.tape.negate(tension);
            self.push(distance, pull);
        }
    }

    /// ½ k s.
    fn store(&mut self, stiffness: Node, square: Node) {
        let half = self.tape.number(S::ratio(1, 2));
        let energy = self.tape.multiply(stiffness, square);
        let energy = self.tape.multiply(half, energy);
        self.potential = self.tape.add(self.potential, energy);
    }

    fn torsion(&mut self, torsion: &Torsion) {
        let turned = self.angle_between(torsion.from, torsion.body);
        if let Some(stiffness) = &torsion.stiffness {
            let (stiffness, angle) = (self.formula(stiffness), self.formula(&torsion.angle));
            let twist = self.tape.subtract(turned, angle);
            let torque = self.tape.multiply(stiffness, twist);
            let back = self.tape.negate(torque);
            self.turn(torsion.body, torsion.from, back);
            let squared = self.tape.multiply(twist, twist);
            self.store(stiffness, squared);
        }
        if let Some(damping) = &torsion.damping {
            let (damping, rate) = (self.formula(damping), self.tape.rate(turned));
            let torque = self.tape.multiply(damping, rate);
            let back = self.tape.negate(torque);
            self.turn(torsion.body, torsion.from, back);
        }
    }
}
