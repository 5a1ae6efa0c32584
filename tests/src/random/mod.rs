//! Random planar bar systems, each written down twice: as a declaration and as the oracle's data.
//!
//! A scheme (names, expressions with their values, who is hinged to whom) is drawn from a seed; `declare`
//! writes it in the syntax of the derive macro, `assemble` in numbers. What the generator is to work out, the
//! sides of contacts, the signs of angles, the values of expressions, is worked out here from the scheme.

mod assemble;
mod beams;
mod builder;
mod contacts;
mod declare;
mod dress;
mod mirror;
mod parameters;
mod quantity;
mod scheme;
mod splitmix;
mod symmetry;

use std::collections::BTreeMap;

use nalgebra::Vector2;
use proc_macro2::{LexError, TokenStream};

use crate::oracle::{Anchor, Assembly, Coordinate, Mark, State};
use scheme::{Declared, Scheme};
pub use splitmix::Source;
use symmetry::Symmetry;

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
    pub points: BTreeMap<String, Mark>,
    declared: BTreeMap<String, Coordinate>,
    figure: Vec<f64>,
    bases: Vec<Mark>,
    loops: bool,
    symmetry: Option<Symmetry>,
}

/// Pivots below this leave fewer than the digits that comparisons want; such systems are drawn again.
const LEAST_PIVOT: f64 = 1e-6;

/// The system of a seed: one that can move, without redundant joints or idle supports, and with definite
/// accelerations.
pub fn sample(seed: u64) -> Sample {
    let mut source = Source::new(seed);
    loop {
        let candidate = Sample::of(&dress::scheme(&mut source));
        if candidate.is_sound(&mut source) {
            return candidate;
        }
    }
}

impl Sample {
    fn of(scheme: &Scheme) -> Self {
        let (assembly, points) = assemble::assembly(scheme);
        let bases = bases(&assembly);
        let symmetry = Symmetry::of(scheme, |point| points[point]);
        let free = if symmetry.is_some() { 1 } else { bases.len() };
        let declared = scheme.coordinates.iter().map(|declared| {
            let (Declared::Angle { name, .. } | Declared::Position { name, .. }) = declared;
            (name.clone(), assemble::coordinate(scheme, declared, &points))
        });
        Self {
            declaration: declare::declaration(scheme),
            parameters: scheme.parameters.fields.clone(),
            declared: declared.collect(),
            figure: scheme.bars.iter().map(|bar| bar.heading.angle()).collect(),
            loops: assembly.bodies.len() < assembly.hinges.len() + assembly.pins.len() + free,
            symmetry,
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

    /// The declaration as tokens.
    ///
    /// # Errors
    /// None, as long as what is written here is Rust.
    pub fn tokens(&self) -> Result<TokenStream, LexError> {
        self.declaration.parse()
    }

    /// A random state on all joints and equal angles: anywhere for trees, near the figure with closed loops.
    /// `None` where a loop does not close.
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
        let state = self.assembly.state(&angles, &spins, &anchors)?;
        let settled = !self.loops && self.assembly.ties.is_empty();
        if settled { Some(state) } else { self.assembly.settle(state, &[]) }
    }

    /// A coordinate by name: a declared one, `theta_BAR` (direction of a bar), `x_P` or `y_P` (a point).
    pub fn coordinate(&self, name: &str) -> Option<Coordinate> {
        if let Some(declared) = self.declared.get(name) {
            return Some(declared.clone());
        }
        let (kind, of) = name.split_once('_')?;
        let position = |axis| {
            let at = *self.points.get(of)?;
            Some(Coordinate::Position { at: at.into(), axis, sign: 1.0 })
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
fn anchor(at: Mark, source: &mut Source) -> Anchor {
    let mut vector = || Vector2::new(source.range(-1.0, 1.0), source.range(-1.0, 1.0));
    Anchor { at: at.into(), position: vector(), velocity: vector() }
}

/// The first point of the first bar of each component without a pin.
fn bases(assembly: &Assembly) -> Vec<Mark> {
    let mut component: Vec<usize> = (0..assembly.bodies.len()).collect();
    for hinge in &assembly.hinges {
        let (a, b) = (component[hinge.first.body], component[hinge.second.body]);
        component.iter_mut().filter(|c| **c == a.max(b)).for_each(|c| *c = a.min(b));
    }
    let pinned = |c: usize| assembly.pins.iter().any(|pin| component[pin.at.body] == c);
    let firsts = (0..component.len()).filter(|&body| component[body] == body && !pinned(body));
    firsts.map(|body| Mark::along(body, 0.0)).collect()
}
