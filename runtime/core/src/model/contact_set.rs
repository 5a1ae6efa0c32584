//! Which contacts are closed.

/// Bits of a word.
const BITS: usize = u64::BITS as usize;
const WORDS: usize = ContactSet::CAPACITY / BITS;

/// A set of closed contacts, one bit per entry of [`Layout::contacts`](super::Layout::contacts).
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Default)]
pub struct ContactSet {
    words: [u64; WORDS],
}

impl ContactSet {
    /// How many contacts a model has at most; the derive macro refuses more.
    pub const CAPACITY: usize = 256;

    /// No contact closed: free motion.
    pub const EMPTY: Self = Self { words: [0; WORDS] };

    /// All contacts closed.
    pub const ALL: Self = Self { words: [u64::MAX; WORDS] };

    /// The set of those of the first 64 contacts whose bits are set.
    pub const fn from_bits(bits: u64) -> Self {
        let mut words = [0; WORDS];
        words[0] = bits;
        Self { words }
    }

    /// Those bits, if no other contact is closed.
    pub fn bits(self) -> Option<u64> {
        let [first, others @ ..] = self.words;
        others.iter().all(|word| *word == 0).then_some(first)
    }

    /// Whether contact `i` is closed.
    pub const fn contains(self, i: usize) -> bool {
        self.words[i / BITS] >> (i % BITS) & 1 == 1
    }

    /// The set with contact `i` closed.
    #[must_use]
    pub const fn with(mut self, i: usize) -> Self {
        self.words[i / BITS] |= 1 << (i % BITS);
        self
    }

    /// The set with contact `i` open.
    #[must_use]
    pub const fn without(mut self, i: usize) -> Self {
        self.words[i / BITS] &= !(1 << (i % BITS));
        self
    }

    /// The contacts closed in either set.
    #[must_use]
    pub fn union(self, other: Self) -> Self {
        self.combine(other, |a, b| a | b)
    }

    /// The contacts closed in both sets.
    #[must_use]
    pub fn intersection(self, other: Self) -> Self {
        self.combine(other, |a, b| a & b)
    }

    /// The contacts closed in this set and open in the other.
    #[must_use]
    pub fn difference(self, other: Self) -> Self {
        self.combine(other, |a, b| a & !b)
    }

    fn combine(self, other: Self, bits: impl Fn(u64, u64) -> u64) -> Self {
        Self { words: core::array::from_fn(|k| bits(self.words[k], other.words[k])) }
    }

    /// The closed contacts in ascending order.
    pub fn iter(self) -> impl Iterator<Item = usize> {
        self.words.into_iter().enumerate().flat_map(|(k, mut word)| {
            core::iter::from_fn(move || {
                let lowest = (word != 0).then(|| word.trailing_zeros() as usize)?;
                word &= word - 1;
                Some(k * BITS + lowest)
            })
        })
    }

    /// How many contacts are closed.
    pub fn len(self) -> usize {
        self.words.iter().map(|word| word.count_ones() as usize).sum()
    }

    /// Whether no contact is closed.
    pub fn is_empty(self) -> bool {
        self == Self::EMPTY
    }
}

impl FromIterator<usize> for ContactSet {
    fn from_iter<I: IntoIterator<Item = usize>>(contacts: I) -> Self {
        contacts.into_iter().fold(Self::EMPTY, Self::with)
    }
}
