//! Random planar bar systems, each written down twice: as a declaration and as the oracle's data.
//!
//! A specification (names, expressions with their values, who is hinged to whom) is drawn from a
//! seed; `declare` writes it in the syntax of the derive macro, `assemble` in numbers. What the
//! generator is to work out, the sides of contacts, the signs of angles, the values of expressions,
//! is worked out here from the spec.

mod actions;
mod asked;
mod assemble;
mod assemble_parts;
mod attributes;
mod beams;
mod builder;
mod contacts;
mod declare;
mod declare_parts;
mod expression;
mod guides;
mod mirror;
mod parameters;
mod parts;
mod quantity;
mod spec;
mod splitmix;
mod symmetry;
mod vocabulary;

use std::collections::BTreeMap;

pub use asked::Asked;
use nalgebra::Vector2;
use proc_macro2::{LexError, TokenStream};

use crate::oracle::{Anchor, Assembly, Coordinate, Mark, Place, State};
use spec::{Declared, Spec};
pub use splitmix::Source;
use symmetry::Symmetry;
pub use vocabulary::Vocabulary;

/// A drawn system in both forms.
#[derive(Clone, Debug)]
pub struct Sample {
    /// A complete item `#[derive(BarSystem)] … pub struct Sample { … }`.
    pub declaration: String,
    /// Fields and their values, in order.
    pub parameters: Vec<(String, f64)>,
    /// The same for the oracle.
    pub assembly: Assembly,
    /// Every named point.
    pub points: BTreeMap<String, Place>,
    /// Its quantities by name; of joints only those at points where nothing else acts.
    pub asked: Vec<(String, Asked)>,
    /// Restitution of each support, and whether it relates impulses.
    pub restitution: Vec<(f64, bool)>,
    declared: BTreeMap<String, Coordinate>,
    figure: Vec<f64>,
    bases: Vec<Place>,
    loops: bool,
    /// Whether random angles have to be settled.
    bound: bool,
    symmetry: Option<Symmetry>,
}

/// Pivots below this leave fewer than the digits that comparisons want; such systems are drawn
/// again.
const LEAST_PIVOT: f64 = 1e-6;

/// The system of a seed out of bars, hinges, pins, masses and straight supports.
pub fn sample(seed: u64) -> Sample {
    sample_of(seed, Vocabulary::BARS)
}

/// The system of a seed: one that can move, without redundant joints or idle supports, and with
/// definite accelerations.
pub fn sample_of(seed: u64, vocabulary: Vocabulary) -> Sample {
    let mut source = Source::new(seed);
    loop {
        let candidate = Sample::from_spec(&attributes::spec(&mut source, vocabulary));
        if candidate.is_sound(&mut source) {
            return candidate;
        }
    }
}

impl Sample {
    fn from_spec(spec: &Spec) -> Self {
        let (assembly, points) = assemble::assembly(spec);
        let bases = bases(&assembly);
        let bound = !(assembly.ties.is_empty() && assembly.sliders.is_empty() && assembly.drives.is_empty());
        let symmetry = Symmetry::detect(spec, &points);
        let free = if symmetry.is_some() { 1 } else { bases.len() };
        let particles = bases.iter().filter(|base| matches!(base, Place::Particle(_))).count();
        let declared = spec.coordinates.iter().map(|declared| {
            let (Declared::Angle { name, .. } | Declared::Position { name, .. }) = declared;
            (name.clone(), assemble::coordinate(spec, declared, &points))
        });
        Self {
            declaration: declare::declaration(spec),
            parameters: spec.parameters.fields.clone(),
            declared: declared.collect(),
            figure: spec.bars.iter().map(|bar| bar.heading.angle()).collect(),
            loops: assembly.bodies.len() < assembly.hinges.len() + assembly.pins.len() + free - particles,
            asked: asked::asked(spec, &points),
            restitution: restitution(spec),
            symmetry,
            bound,
            bases,
            points,
            assembly,
        }
    }

    fn is_sound(&self, source: &mut Source) -> bool {
        (0..2).all(|_| {
            self.state(source).is_some_and(|state| {
                let (free, redundant) = match &self.symmetry {
                    Some(symmetry) => symmetry.mobility(&self.assembly, &state),
                    None => self.assembly.mobility(&state, &[]),
                };
                let motion = self.assembly.solve(&state, &[]);
                let mut supports = 0..self.assembly.supports.len();
                let moves = supports.all(|index| self.assembly.gap(&state, index)[1].abs() > 1e-9);
                moves && free > 0 && redundant == 0 && motion.is_ok_and(|m| m.pivots > LEAST_PIVOT)
            })
        })
    }

    /// Whether it is declared mirror-symmetric: its states are, and images act together.
    pub fn is_mirrored(&self) -> bool {
        self.symmetry.is_some()
    }

    /// The same with both halves, each of which moves by itself.
    #[must_use]
    pub fn unfolded(self) -> Self {
        Self { symmetry: None, ..self }
    }

    /// Whether a state is mirror-symmetric where it is to be.
    pub fn is_symmetric(&self, state: &State) -> bool {
        self.symmetry.as_ref().is_none_or(|symmetry| symmetry.holds(&self.assembly, state))
    }

    /// Whether time occurs in what it is told.
    fn is_timed(&self) -> bool {
        let Assembly { drives, loads, couples, .. } = &self.assembly;
        !(drives.is_empty() && loads.is_empty() && couples.is_empty())
    }

    /// The declaration as tokens.
    ///
    /// # Errors
    /// None, as long as what is written here is Rust.
    pub fn tokens(&self) -> Result<TokenStream, LexError> {
        self.declaration.parse()
    }

    /// A random state on all joints and equal angles: anywhere for trees, near the figure with
    /// closed loops. `None` where a loop does not close.
    pub fn state(&self, source: &mut Source) -> Option<State> {
        let spread = if self.loops { 0.4 } else { 3.0 };
        let mut angles: Vec<_> = self.figure.iter().map(|a| a + source.range(-spread, spread)).collect();
        let mut spins: Vec<_> = self.figure.iter().map(|_| source.range(-2.0, 2.0)).collect();
        let anchors = match &self.symmetry {
            Some(symmetry) => {
                symmetry.complete(&mut angles, &mut spins);
                vec![symmetry.anchor(source)]
            }
            None => self.bases.iter().map(|&at| anchor(at, source)).collect(),
        };
        let mut state = self.assembly.state(&angles, &spins, &anchors)?;
        if self.is_timed() {
            state.time = source.range(0.0, 2.0);
        }
        let settled = !self.loops && !self.bound;
        if settled { Some(state) } else { self.assembly.settle(state, &[]) }
    }

    /// A coordinate by name: a declared one, `theta_BAR` (direction of a bar), `x_P` or `y_P` (a
    /// point).
    pub fn coordinate(&self, name: &str) -> Option<Coordinate> {
        if let Some(declared) = self.declared.get(name) {
            return Some(declared.clone());
        }
        let (kind, of) = name.split_once('_')?;
        let position = |axis| {
            let at = *self.points.get(of)?;
            Some(Coordinate::Position { at, axis, sign: 1.0 })
        };
        match kind {
            "theta" => Some(Coordinate::Angle { terms: vec![(self.assembly.body(of)?, 1.0)], offset: 0.0 }),
            "x" => position(0),
            "y" => position(1),
            _ => None,
        }
    }
}

/// A point anywhere near the origin, moving.
fn anchor(at: Place, source: &mut Source) -> Anchor {
    let mut vector = || Vector2::new(source.range(-1.0, 1.0), source.range(-1.0, 1.0));
    Anchor { at, position: vector(), velocity: vector() }
}

/// Of each support and thread in the oracle's order: e, and whether it is Poisson's.
fn restitution(spec: &Spec) -> Vec<(f64, bool)> {
    let of = |manner: &parts::Manner| {
        (manner.restitution.as_ref().map_or(0.0, |restitution| restitution.value), manner.poisson)
    };
    let supports = spec.supports.iter().flat_map(|support| {
        let sides = if matches!(support.shape, spec::Shape::Slot { .. }) { 2 } else { 1 };
        std::iter::repeat_n(of(&support.manner), sides)
    });
    supports.chain(spec.parts.threads.iter().map(|thread| of(&thread.manner))).collect()
}

/// The first point of the first bar of each component without a pin, then the free particles.
fn bases(assembly: &Assembly) -> Vec<Place> {
    let mut component: Vec<usize> = (0..assembly.bodies.len()).collect();
    for hinge in &assembly.hinges {
        let (a, b) = (component[hinge.first.body], component[hinge.second.body]);
        component.iter_mut().filter(|c| **c == a.max(b)).for_each(|c| *c = a.min(b));
    }
    let pinned = |c: usize| assembly.pins.iter().any(|pin| component[pin.at.body] == c);
    let firsts = (0..component.len()).filter(|&body| component[body] == body && !pinned(body));
    let firsts = firsts.map(|body| Mark::along(body, 0.0).into());
    let particles = assembly.particles.iter().enumerate();
    let free = particles.filter(|(_, particle)| particle.carrier.is_none());
    firsts.chain(free.map(|(index, _)| Place::Particle(index))).collect()
}
