//! Where a sequence of flights ends, and a sequence of such sequences: a block that rocks on two
//! feet bounces on one, then on the other, and each foot's fastest flights are a sequence of their
//! own.

/// The flights of one contact since it began to bounce, or the fastest flights of sequences that
/// follow one another.
#[derive(Debug, Clone, Default)]
pub(crate) struct Sequence {
    /// Start and speed of the last one.
    last: Option<(f64, f64)>,
    /// Whether it is slower than the one before.
    slows: bool,
    /// The end as told by the last two flights.
    end: Option<f64>,
    /// The end least changed from one flight to the next, and that change.
    best: Option<(f64, f64)>,
    /// The flights that were faster than those before and behind.
    fastest: Option<Box<Sequence>>,
}

impl Sequence {
    pub(in crate::simulation) fn begin(&mut self, t: f64, speed: f64) {
        let slows = self.last.is_some_and(|(_, before)| speed < before);
        if slows {
            self.tell_fastest();
        }
        let before = self.last.replace((t, speed));
        self.slows = slows;
        let end = before.filter(|_| slows).map(|(since, v)| {
            let q = speed / v;
            t + q * (t - since) / (1.0 - q)
        });
        let change = self.end.zip(end).map(|(earlier, now)| (now, (now - earlier).abs()));
        // A flight that begins after the end is of another sequence.
        self.best = self.best.filter(|(end, error)| t <= end + error);
        let better = |(_, error): &(f64, f64)| self.best.is_none_or(|(_, least)| *error <= least);
        self.best = change.filter(better).or(self.best);
        self.end = end;
    }

    /// Gives the last flight to the sequence of the fastest ones, if it was not slower than the one
    /// before.
    fn tell_fastest(&mut self) {
        if let Some((t, speed)) = self.last.filter(|_| !self.slows) {
            self.fastest.get_or_insert_default().begin(t, speed);
        }
    }

    /// Whether the last flight is slower than the one before.
    pub(in crate::simulation) fn slows(&self) -> bool {
        self.slows
    }

    /// The end and its error, as told by the flights themselves.
    pub(in crate::simulation) fn best(&self) -> Option<(f64, f64)> {
        self.best
    }

    /// The same by the fastest flights, by the fastest of these, and so on.
    pub(in crate::simulation) fn of_fastest(&self) -> impl Iterator<Item = (f64, f64)> {
        let levels = core::iter::successors(self.fastest.as_deref(), |level| level.fastest.as_deref());
        levels.filter_map(|level| level.best)
    }

    /// The flights are over, and what others follow begins anew.
    pub(in crate::simulation) fn finish(&mut self) {
        self.tell_fastest();
        *self = Self { fastest: self.fastest.take(), ..Self::default() };
    }
}

#[cfg(test)]
mod tests {
    use super::Sequence;

    /// A ball with e = 1/2 whose first flight, from t = `start`, takes a second.
    fn bounce(sequence: &mut Sequence, start: f64) {
        for k in 0..20 {
            let shrunk = 0.5_f64.powi(k);
            sequence.begin(start + 2.0 * (1.0 - shrunk), shrunk);
        }
    }

    #[test]
    fn the_end_of_a_geometric_sequence_is_found_and_forgotten_after_it() {
        let mut sequence = Sequence::default();
        bounce(&mut sequence, 0.0);
        let (end, error) = sequence.best().unwrap();
        // Rounding of the times.
        assert!((end - 2.0).abs() < 1e-14 && error < 1e-14, "{end} {error}");
        sequence.begin(5.0, 1.0);
        assert_eq!(sequence.best(), None);
        bounce(&mut sequence, 5.0);
        let (end, error) = sequence.best().unwrap();
        assert!((end - 7.0).abs() < 1e-14 && error < 1e-14, "{end} {error}");
    }

    /// Two feet that take turns: each flight in its turn is a tenth as fast as the one before, and
    /// the first flights of the turns are a sequence of their own, here with q = 1/4 and an end at
    /// t = 4.
    #[test]
    fn the_fastest_flights_are_a_sequence_of_their_own() {
        let mut sequence = Sequence::default();
        for turn in 0..12 {
            let left = 3.0 * 0.25_f64.powi(turn);
            for k in 0..2 {
                let begun = 4.0 - left + 0.25 * left * f64::from(k);
                sequence.begin(begun, left * 0.1_f64.powi(k));
            }
        }
        let (end, error) = sequence.of_fastest().next().unwrap();
        assert!((end - 4.0).abs() < 1e-6 && error < 1e-6, "{end} {error}");
        // The last turn counts once it is over.
        let known = sequence.clone().of_fastest().next();
        sequence.finish();
        assert!(!sequence.slows() && sequence.best().is_none() && sequence.of_fastest().next() == known);
    }
}
