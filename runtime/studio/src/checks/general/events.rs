//! Whether two runs have the same events: of impacts that follow ever more quickly and come to
//! their end, however many each run has counted before that end.

use super::Pair;

use crate::checks::event_summary::describe;
use liftoff::Trajectory;
use liftoff::{Event, EventKind};

/// Events of one kind and one set of supports that follow one another.
type Streak<'a> = &'a [Event];

fn streaks(record: &Trajectory) -> Vec<Streak<'_>> {
    record.events().chunk_by(alike).collect()
}

fn alike(a: &Event, b: &Event) -> bool {
    a.kind == b.kind && a.supports == b.supports
}

/// How the events differ, if they do.
pub(super) fn difference(one: &Trajectory, other: &Trajectory) -> Option<String> {
    let (a, b) = (streaks(one), streaks(other));
    let same = a.len() == b.len() && (0..a.len()).all(|k| agree((a[k], a.get(k + 1)), (b[k], b.get(k + 1))));
    (!same).then(|| format!("{} instead of {}", describe_all(&b), describe_all(&a)))
}

/// A streak with the one that follows.
fn agree((a, after): (Streak, Option<&Streak>), (b, _): (Streak, Option<&Streak>)) -> bool {
    let settles = after.is_some_and(|next| next[0].kind == EventKind::Settle);
    alike(&a[0], &b[0]) && (a.len() == b.len() || settles)
}

/// Pairs of events that both runs have.
pub(super) fn pairs<'a>(
    one: &'a Trajectory,
    other: &'a Trajectory,
) -> impl Iterator<Item = (&'a Event, &'a Event)> {
    streaks(one).into_iter().zip(streaks(other)).flat_map(|(a, b)| a.iter().zip(b))
}

fn describe_all(streaks: &[Streak]) -> String {
    let one = |streak: &Streak| match streak.len() {
        1 => describe(&streak[0]),
        times => format!("{} × {times}", describe(&streak[0])),
    };
    streaks.iter().skip(1).map(one).collect::<Vec<_>>().join("; ")
}

impl Pair<'_> {
    /// The largest difference of the times of two runs' events.
    pub(super) fn late(&self, one: &Trajectory, other: &Trajectory) -> f64 {
        let late =
            |(a, b): (&Event, &Event)| (b.t / self.units[1] - a.t).abs() / a.t.abs().max(self.natural[1]);
        super::largest(pairs(one, other).map(late))
    }
}
