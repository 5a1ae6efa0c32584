//! Which contacts are closed, and how those with friction slip.

/// Bits of a word.
const BITS: usize = u64::BITS as usize;
const WORDS: usize = ContactSet::CAPACITY / BITS;

/// A set of closed contacts, one bit per entry of [`Layout::contacts`](super::Layout::contacts). A
/// closed contact with friction sticks, or slides forward or backward along its tangent; a guide
/// with friction presses to one side or to the other.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Default)]
pub struct ContactSet {
    words: [u64; WORDS],
    /// Those of them that stick, of the contacts with friction.
    stick: [u64; WORDS],
    /// Those of them that slide backward.
    backward: [u64; WORDS],
    /// Those of the guides with friction whose reaction is negative; guides are among the first
    /// contacts.
    negative: u64,
}

/// How a closed contact with friction slips.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Slip {
    /// Not at all.
    Stick,
    /// Along its tangent.
    Forward,
    /// Against its tangent.
    Backward,
}

impl Slip {
    /// The sign σ of the slip velocity.
    pub const fn sign(self) -> i8 {
        match self {
            Self::Stick => 0,
            Self::Forward => 1,
            Self::Backward => -1,
        }
    }
}

/// The sign of the reaction of a contact that holds both ways.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Default)]
pub enum Side {
    /// N ≥ 0, as of every other contact.
    #[default]
    Positive,
    /// N ≤ 0.
    Negative,
}

impl Side {
    /// The sign s of the reaction.
    pub const fn sign(self) -> i8 {
        match self {
            Self::Positive => 1,
            Self::Negative => -1,
        }
    }
}

impl ContactSet {
    /// How many contacts a model has at most; the derive macro refuses more.
    pub const CAPACITY: usize = 256;

    /// No contact closed: free motion.
    pub const EMPTY: Self = Self::from_words([0; WORDS]);

    /// All contacts closed.
    pub const ALL: Self = Self::from_words([u64::MAX; WORDS]);

    const fn from_words(words: [u64; WORDS]) -> Self {
        Self { words, stick: [0; WORDS], backward: [0; WORDS], negative: 0 }
    }

    /// The set of those of the first 64 contacts whose bits are set.
    pub const fn from_bits(bits: u64) -> Self {
        let mut words = [0; WORDS];
        words[0] = bits;
        Self::from_words(words)
    }

    /// Those bits, if no other contact is closed.
    pub fn bits(self) -> Option<u64> {
        let [first, others @ ..] = self.words;
        others.iter().all(|word| *word == 0).then_some(first)
    }

    /// Those bits with those of the contacts that stick.
    pub fn bits_and_stick(self) -> Option<(u64, u64)> {
        self.bits().map(|bits| (bits, self.stick[0]))
    }

    /// The set of those of the first 64 contacts whose bits are set, some of which stick.
    pub const fn from_bits_and_stick(bits: u64, stick: u64) -> Self {
        let mut set = Self::from_bits(bits);
        set.stick[0] = stick;
        set
    }

    /// Whether contact `i` is closed.
    pub const fn contains(&self, i: usize) -> bool {
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
        let mask = !(1 << (i % BITS));
        self.words[i / BITS] &= mask;
        self.stick[i / BITS] &= mask;
        self.backward[i / BITS] &= mask;
        self.pressing(i, Side::Positive)
    }

    /// The set with contact `i`, which has friction, closed and slipping so.
    #[must_use]
    pub const fn slipping(self, i: usize, slip: Slip) -> Self {
        let side = self.side(i);
        let mut set = self.without(i).with(i).pressing(i, side);
        let bit = 1 << (i % BITS);
        match slip {
            Slip::Stick => set.stick[i / BITS] |= bit,
            Slip::Backward => set.backward[i / BITS] |= bit,
            Slip::Forward => {}
        }
        set
    }

    /// How many guides with friction a model has at most; the derive macro refuses more.
    pub const GUIDES: usize = BITS;

    /// The set with contact `i`, a guide with friction, pressing to a side.
    #[must_use]
    pub const fn pressing(mut self, i: usize, side: Side) -> Self {
        if i < BITS {
            let bit = 1 << i;
            match side {
                Side::Negative => self.negative |= bit,
                Side::Positive => self.negative &= !bit,
            }
        }
        self
    }

    /// The side that contact `i` presses to.
    pub const fn side(&self, i: usize) -> Side {
        if i < BITS && self.negative >> i & 1 == 1 { Side::Negative } else { Side::Positive }
    }

    /// How contact `i` slips, if it is closed and has friction.
    pub const fn slip(&self, i: usize) -> Slip {
        let bit = 1 << (i % BITS);
        if self.stick[i / BITS] & bit != 0 {
            Slip::Stick
        } else if self.backward[i / BITS] & bit != 0 {
            Slip::Backward
        } else {
            Slip::Forward
        }
    }

    /// The σ of R = −σ μ N at contact `i`, which has friction: the sign of its slip velocity, times
    /// that of N at a guide; 0 where it is open or sticks.
    pub const fn sense(&self, i: usize) -> i64 {
        if self.contains(i) { (self.slip(i).sign() * self.side(i).sign()) as i64 } else { 0 }
    }

    /// The closed contacts alone.
    #[must_use]
    pub const fn closed(self) -> Self {
        Self::from_words(self.words)
    }

    /// The contacts closed in either set; each slips as in the set that it is closed in, as in this
    /// one if in both.
    #[must_use]
    pub fn union(self, other: Self) -> Self {
        let other = other.difference(self);
        Self {
            words: each(self.words, other.words, |a, b| a | b),
            stick: each(self.stick, other.stick, |a, b| a | b),
            backward: each(self.backward, other.backward, |a, b| a | b),
            negative: self.negative | other.negative,
        }
    }

    /// The contacts closed in both sets; each slips as in this one.
    #[must_use]
    pub fn intersection(self, other: Self) -> Self {
        self.masked(other, |a, b| a & b)
    }

    /// The contacts closed in this set and open in the other.
    #[must_use]
    pub fn difference(self, other: Self) -> Self {
        self.masked(other, |a, b| a & !b)
    }

    fn masked(self, other: Self, bits: fn(u64, u64) -> u64) -> Self {
        Self {
            words: each(self.words, other.words, bits),
            stick: each(self.stick, other.words, bits),
            backward: each(self.backward, other.words, bits),
            negative: bits(self.negative, other.words[0]),
        }
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
        self.words == [0; WORDS]
    }
}

fn each(a: [u64; WORDS], b: [u64; WORDS], bits: fn(u64, u64) -> u64) -> [u64; WORDS] {
    core::array::from_fn(|k| bits(a[k], b[k]))
}

impl FromIterator<usize> for ContactSet {
    fn from_iter<I: IntoIterator<Item = usize>>(contacts: I) -> Self {
        contacts.into_iter().fold(Self::EMPTY, Self::with)
    }
}
