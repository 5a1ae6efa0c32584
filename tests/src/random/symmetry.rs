//! States of mirror-symmetric samples, and what can move without leaving the symmetry.

use nalgebra::Vector2;

use super::assemble::Places;
use super::spec::{Mirror, Spec};
use super::splitmix::Source;
use crate::oracle::{Anchor, Assembly, Contact, Mark, Place, State, Support};

/// The mirror in numbers.
#[derive(Clone, Debug)]
pub struct Symmetry {
    mirror: Mirror,
    root: Mark,
    pinned: bool,
}

impl Symmetry {
    /// The symmetry of a spec, if it has one.
    pub fn detect(spec: &Spec, places: &Places) -> Option<Self> {
        let mirror = spec.mirror.clone()?;
        let Place::Body(root) = places[&mirror.root] else { return None };
        let pinned = spec.pins.contains(&mirror.root);
        Some(Self { mirror, root, pinned })
    }

    /// Makes the angles of the images those of the images.
    pub fn complete(&self, angles: &mut [f64], spins: &mut [f64]) {
        for body in 0..self.mirror.half {
            angles[body + self.mirror.half] = self.mirror.angle(angles[body]);
            spins[body + self.mirror.half] = -spins[body];
        }
    }

    /// The root on the line, moving along it.
    pub fn anchor(&self, source: &mut Source) -> Anchor {
        let mut random = || {
            let mut along = Vector2::zeros();
            along[1 - self.mirror.axis] = source.range(-1.0, 1.0);
            along
        };
        let (mut position, velocity) = (random(), random());
        position[self.mirror.axis] = self.mirror.at.value;
        Anchor { at: self.root.into(), position, velocity }
    }

    /// Whether a state is symmetric: Newton's method far from a solution makes rounding errors
    /// grow.
    pub fn holds(&self, assembly: &Assembly, state: &State) -> bool {
        let (mirror, root) = (&self.mirror, self.root);
        let images = (0..mirror.half).flat_map(|body| {
            let turn = state.angle(body + mirror.half) - mirror.angle(state.angle(body));
            [turn.sin(), 1.0 - turn.cos(), state.spin(body + mirror.half) + state.spin(body)]
        });
        let off = assembly.position(state, root)[mirror.axis] - mirror.at.value;
        let mut errors = images.chain([off, assembly.velocity(state, root)[mirror.axis]]);
        errors.all(|error| error.abs() < 1e-11)
    }

    /// Degrees of freedom and redundant joints of one half, its root held on the line.
    pub fn mobility(&self, assembly: &Assembly, state: &State) -> (usize, usize) {
        let half = self.mirror.half;
        let within = |mark: &Mark| mark.body < half;
        let mut normal = Vector2::zeros();
        normal[self.mirror.axis] = 1.0;
        let line = Contact::Point { point: self.root.into(), through: normal * self.mirror.at.value, normal };
        let hinges = assembly.hinges.iter();
        let ties = assembly.ties.iter();
        let one = Assembly {
            bodies: assembly.bodies[..half].to_vec(),
            hinges: hinges.filter(|h| within(&h.first) && within(&h.second)).cloned().collect(),
            pins: assembly.pins.iter().filter(|pin| within(&pin.at)).cloned().collect(),
            ties: ties.filter(|tie| tie.terms.iter().all(|t| t.0 < half)).cloned().collect(),
            supports: vec![Support { name: String::new(), contact: line, rough: false }],
            ..Assembly::default()
        };
        let state = State {
            positions: state.positions.rows(0, 3 * half).into_owned(),
            rates: state.rates.rows(0, 3 * half).into_owned(),
            time: state.time,
        };
        one.mobility(&state, if self.pinned { &[] } else { &[0] })
    }
}
