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
        RestitutionScaled, StartPenetrates,
    };
    matches!(
        decision,
        ConditionHolds(_)
            | ConditionUndecided
            | GuardUnresolved
            | ImpulsesNotUnique
            | ReactionsNotUnique
            | RestitutionScaled(_)
            | StartPenetrates(_)
    )
}
