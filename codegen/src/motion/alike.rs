//! Bodies that follow a coordinate alike: in a chain all that hang from a bar. What their masses
//! give is summed once for all coordinates that move the same of them.

use std::collections::BTreeMap;

use super::Inertia;
use crate::algebra::{Series, Symbol};

/// Bits of a word.
const BITS: usize = u64::BITS as usize;

/// Bodies by their indices.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug, Default)]
pub(super) struct Bodies(Vec<u64>);

impl Bodies {
    fn insert(&mut self, body: usize) {
        let word = body / BITS;
        self.0.resize(self.0.len().max(word + 1), 0);
        self.0[word] |= 1 << (body % BITS);
    }

    /// Those of both.
    pub fn common(&self, other: &Self) -> Self {
        let mut words: Vec<u64> = self.0.iter().zip(&other.0).map(|(a, b)| a & b).collect();
        words.truncate(words.iter().rposition(|&word| word != 0).map_or(0, |last| last + 1));
        Self(words)
    }

    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    fn len(&self) -> u32 {
        self.0.iter().map(|word| word.count_ones()).sum()
    }

    fn contains(&self, body: usize) -> bool {
        self.0.get(body / BITS).is_some_and(|word| word >> (body % BITS) & 1 == 1)
    }

    fn iter(&self) -> impl Iterator<Item = usize> {
        (0..self.0.len() * BITS).filter(|&body| self.contains(body))
    }
}

/// Bodies with the same partial velocity along a coordinate.
#[derive(Clone, Debug)]
pub(super) struct Class {
    /// ∂r/∂q of their centres.
    pub slope: [Series; 2],
    /// ∂ω/∂u.
    pub spin: Series,
    pub bodies: Bodies,
}

/// The classes that move with a coordinate.
pub(super) fn classes(inertias: &[Inertia], coordinate: usize) -> Vec<Class> {
    let mut classes: Vec<Class> = Vec::new();
    for (body, inertia) in inertias.iter().enumerate() {
        let slope = inertia.centre.each_ref().map(|x| x.derivative(Symbol::coordinate(coordinate)));
        let spin = inertia.spin.derivative(Symbol::rate(coordinate));
        if spin.is_zero() && slope.iter().all(Series::is_zero) {
            continue;
        }
        let known = classes.iter_mut().rev().find(|class| class.slope == slope && class.spin == spin);
        match known {
            Some(class) => class.bodies.insert(body),
            None => {
                let mut bodies = Bodies::default();
                bodies.insert(body);
                classes.push(Class { slope, spin, bodies });
            }
        }
    }
    classes
}

/// Sums of several values of each body over sets of bodies, each found from the largest that is
/// known within it.
pub(super) struct BodySums<const K: usize> {
    of: Vec<[Series; K]>,
    known: BTreeMap<Bodies, [Series; K]>,
}

impl<const K: usize> BodySums<K> {
    /// Of these values of each body.
    pub fn from_values(values: impl Iterator<Item = [Series; K]>) -> Self {
        Self { of: values.collect(), known: BTreeMap::new() }
    }

    /// The sums over `bodies`.
    pub fn over(&mut self, bodies: &Bodies) -> [Series; K] {
        if let Some(known) = self.known.get(bodies) {
            return known.clone();
        }
        let within = self.known.iter().filter(|(set, _)| set.common(bodies) == **set);
        let start = within.max_by_key(|(set, _)| set.len());
        let (known, mut sums) = match start {
            Some((set, sums)) => (set.clone(), sums.clone()),
            None => (Bodies::default(), core::array::from_fn(|_| Series::zero())),
        };
        for body in bodies.iter().filter(|&body| !known.contains(body)) {
            for (sum, value) in sums.iter_mut().zip(&self.of[body]) {
                *sum += value;
            }
        }
        self.known.insert(bodies.clone(), sums.clone());
        sums
    }
}
