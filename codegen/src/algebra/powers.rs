//! Sparse integer vectors over the symbols: the exponents of a monomial, the multipliers of an
//! angle.
//!
//! They form an ordered group: sums are entry by entry, and the lexicographic order of the dense
//! vectors satisfies a < b ⇔ a + c < b + c. Products by a monomial therefore keep a series sorted,
//! and leading terms multiply.

use super::Symbol;
use std::cmp::Ordering;
use std::ops::Deref;

type Entry = (Symbol, i16);

/// Entries up to this number need no allocation: m l² φ̇ ψ̇ has four.
const INLINE: usize = 4;
const VACANT: Entry = (Symbol::Parameter(0), 0);

/// Sorted pairs (symbol, non-zero integer); dereferences to the slice of them.
#[derive(Clone, Debug)]
pub struct Powers(Storage);

#[derive(Clone, Debug)]
enum Storage {
    Inline(u8, [Entry; INLINE]),
    Heap(Vec<Entry>),
}

impl Powers {
    /// The zero vector.
    pub const ZERO: Self = Self(Storage::Inline(0, [VACANT; INLINE]));

    /// `k` at `symbol`, zero elsewhere.
    pub fn single(symbol: Symbol, k: i16) -> Self {
        let mut powers = Self::ZERO;
        powers.push(symbol, k);
        powers
    }

    /// The entry at `symbol`.
    pub fn get(&self, symbol: Symbol) -> i16 {
        for &(candidate, k) in self.iter() {
            if candidate == symbol {
                return k;
            }
        }
        0
    }

    /// self + other; `None` where an entry leaves the 16 bits.
    pub(super) fn plus(&self, other: &Self) -> Option<Self> {
        self.combined(other, 1)
    }

    /// self − other; `None` where an entry leaves the 16 bits.
    pub(super) fn minus(&self, other: &Self) -> Option<Self> {
        self.combined(other, -1)
    }

    /// factor · self; `None` where an entry leaves the 16 bits.
    pub(super) fn times(&self, factor: i32) -> Option<Self> {
        let mut product = Self::ZERO;
        for &(symbol, k) in self.iter() {
            product.push(symbol, bounded(i32::from(k).checked_mul(factor)?)?);
        }
        Some(product)
    }

    /// The same vector with 0 at `symbol`.
    pub(super) fn without(&self, symbol: Symbol) -> Self {
        let mut rest = Self::ZERO;
        for &(candidate, k) in self.iter() {
            if candidate != symbol {
                rest.push(candidate, k);
            }
        }
        rest
    }

    /// The vector over the greatest common divisor of its entries.
    pub(super) fn primitive(&self) -> Self {
        let divisor = self.iter().fold(0, |g, (_, k)| gcd(g, k.abs()));
        let mut primitive = Self::ZERO;
        for &(symbol, k) in self.iter() {
            primitive.push(symbol, k / divisor);
        }
        primitive
    }

    /// The lesser entry at every symbol.
    pub(super) fn minimum(&self, other: &Self) -> Self {
        let mut least = Self::ZERO;
        let (mut i, mut j) = (0, 0);
        while let Some((symbol, a, b)) = next_pair(self, other, &mut i, &mut j) {
            least.push(symbol, a.min(b));
        }
        least
    }

    fn combined(&self, other: &Self, sign: i32) -> Option<Self> {
        if other.is_empty() {
            return Some(self.clone());
        }
        let mut sum = Self::ZERO;
        let (mut i, mut j) = (0, 0);
        while let Some((symbol, a, b)) = next_pair(self, other, &mut i, &mut j) {
            sum.push(symbol, bounded(i32::from(a) + sign * i32::from(b))?);
        }
        Some(sum)
    }

    /// Appends an entry with the largest symbol; zero is dropped.
    pub(super) fn push(&mut self, symbol: Symbol, k: i16) {
        if k == 0 {
            return;
        }
        match &mut self.0 {
            Storage::Inline(length, entries) => {
                let at = usize::from(*length);
                if at < INLINE {
                    entries[at] = (symbol, k);
                    *length += 1;
                } else {
                    let mut heap = entries.to_vec();
                    heap.push((symbol, k));
                    self.0 = Storage::Heap(heap);
                }
            }
            Storage::Heap(entries) => entries.push((symbol, k)),
        }
    }
}

fn gcd(a: i16, b: i16) -> i16 {
    if b == 0 { a } else { gcd(b, a % b) }
}

/// ±32767, so that negation never overflows.
fn bounded(k: i32) -> Option<i16> {
    i16::try_from(k).ok().filter(|&k| k != i16::MIN)
}

/// The next symbol present in either of two sorted slices, with both entries.
fn next_pair(left: &[Entry], right: &[Entry], i: &mut usize, j: &mut usize) -> Option<(Symbol, i16, i16)> {
    let (symbol, a, b) = match (left.get(*i), right.get(*j)) {
        (None, None) => return None,
        (Some(&(s, a)), None) => (s, a, 0),
        (None, Some(&(s, b))) => (s, 0, b),
        (Some(&(s, a)), Some(&(t, b))) => match s.cmp(&t) {
            Ordering::Less => (s, a, 0),
            Ordering::Equal => (s, a, b),
            Ordering::Greater => (t, 0, b),
        },
    };
    *i += usize::from(a != 0);
    *j += usize::from(b != 0);
    Some((symbol, a, b))
}

impl Deref for Powers {
    type Target = [(Symbol, i16)];
    fn deref(&self) -> &[(Symbol, i16)] {
        match &self.0 {
            Storage::Inline(length, entries) => &entries[..usize::from(*length)],
            Storage::Heap(entries) => entries,
        }
    }
}

impl<'a> IntoIterator for &'a Powers {
    type Item = &'a (Symbol, i16);
    type IntoIter = std::slice::Iter<'a, (Symbol, i16)>;
    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

impl PartialEq for Powers {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Powers {}

impl PartialOrd for Powers {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Powers {
    fn cmp(&self, other: &Self) -> Ordering {
        let (left, right): (&[Entry], &[Entry]) = (self, other);
        let mut i = 0;
        loop {
            match (left.get(i), right.get(i)) {
                (None, None) => return Ordering::Equal,
                (Some((_, a)), None) => return a.cmp(&0),
                (None, Some((_, b))) => return 0.cmp(b),
                (Some((s, a)), Some((t, b))) => match s.cmp(t) {
                    Ordering::Less => return a.cmp(&0),
                    Ordering::Greater => return 0.cmp(b),
                    Ordering::Equal if a != b => return a.cmp(b),
                    Ordering::Equal => i += 1,
                },
            }
        }
    }
}
