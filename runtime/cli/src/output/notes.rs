//! What a run decided that its reader should know.

use crate::output::print::tell;
use crate::output::style::{LABEL, styled};
use liftoff::{LogEntry, LoggedDecision, Trajectory};

/// Tells a note.
pub fn note(text: &str) {
    tell(&format!("{} {text}", styled(LABEL, "note:")));
}

/// The decisions that bear on what is printed, each once, with the time it was first taken.
pub fn decisions(record: &Trajectory) -> Vec<String> {
    let mut found: Vec<(String, f64, usize)> = Vec::new();
    for LogEntry { t, decision } in record.log().iter().filter(|entry| matters(&entry.decision)) {
        let text = decision.to_string();
        match found.iter_mut().find(|(known, ..)| *known == text) {
            Some((.., count)) => *count += 1,
            None => found.push((text, *t, 1)),
        }
    }
    found.into_iter().map(|(text, t, count)| told(&text, t, count)).collect()
}

fn told(text: &str, t: f64, count: usize) -> String {
    match count - 1 {
        0 => format!("at t = {t:.4}: {text}"),
        1 => format!("at t = {t:.4}, and once more: {text}"),
        more => format!("at t = {t:.4}, and {more} times more: {text}"),
    }
}

/// Whether it bears on the numbers or on the end of a run, and not only on how they were computed.
fn matters(decision: &LoggedDecision) -> bool {
    use LoggedDecision::{
        ConditionHolds, ConditionUndecided, GuardUnresolved, ImpulsesNotUnique, ReactionsNotUnique,
        RestitutionScaled, StartMoves, StartPenetrates,
    };
    matches!(
        decision,
        ConditionHolds(_)
            | ConditionUndecided
            | GuardUnresolved
            | ImpulsesNotUnique
            | ReactionsNotUnique
            | RestitutionScaled(_)
            | StartMoves(_)
            | StartPenetrates(_)
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use liftoff::prelude::*;

    /// A level rod on three supports, which share its weight in any of many ways.
    #[derive(BarSystem)]
    #[gravity(g)]
    #[bar(AB, mass = m, length = l)]
    #[point(C = AB, at = l / 2)]
    #[support(A = floor)]
    #[support(C = floor)]
    #[support(B = floor)]
    #[figure(A = (-l / 2, 0), B = (l / 2, 0))]
    #[coordinate(phi = angle(AB))]
    #[coordinate(x = x(C))]
    #[coordinate(y = y(C))]
    struct Rod {
        m: f64,
        l: f64,
        g: f64,
    }

    #[test]
    fn reactions_that_are_not_unique_are_told_once() {
        let rod = Simulation::new(&Rod { m: 1.0, l: 1.0, g: 1.0 }).unwrap().release("C", 0.5).unwrap();
        let told = decisions(&rod.limit(1.0).run().unwrap());
        assert_eq!(told.len(), 1, "{told:?}");
        assert!(told[0].contains("the reactions are not unique; the least-norm ones are given"), "{told:?}");
        assert_eq!(super::told("a", 0.5, 1), "at t = 0.5000: a");
        assert_eq!(super::told("a", 0.5, 3), "at t = 0.5000, and 2 times more: a");
    }
}
