//! How a search goes on behind a zero that does not count.

/// At least this far behind it, twice as far each time: nearer it would find the same zero again.
pub(super) struct Advance(f64);

impl Advance {
    pub(super) const BEGUN: Self = Self(f64::EPSILON);

    /// Where a search from `from` that has found `theta` goes on.
    pub(super) fn behind(&mut self, theta: f64, from: f64) -> f64 {
        let next = theta.max(from + self.0);
        self.0 *= 2.0;
        next
    }
}

#[cfg(test)]
mod tests {
    use super::Advance;

    #[test]
    fn a_search_that_finds_the_same_zero_again_leaves_it() {
        let (mut advance, mut from) = (Advance::BEGUN, 0.5);
        for k in 0..8 {
            let next = advance.behind(0.5, from);
            assert_eq!(next - from, f64::from(1 << k) * f64::EPSILON);
            from = next;
        }
        assert_eq!(advance.behind(0.75, from), 0.75);
    }
}
