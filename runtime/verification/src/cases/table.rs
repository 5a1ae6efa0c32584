//! The table on standard output.

use super::verdict::{Outcome, Verdict};

/// One line for each case: outcome, id, method, what was expected and what was measured, what the judge finds.
pub fn text(verdicts: &[Verdict]) -> String {
    let width = |of: fn(&Verdict) -> &str| verdicts.iter().map(|v| of(v).chars().count()).max().unwrap_or(0);
    let [id, expected] = [width(|v| &v.id), width(|v| &v.expected)];
    let line = |v: &Verdict| {
        let audit = v.audit.as_ref().map_or_else(String::new, |audit| format!("  (audit: {audit})"));
        let Verdict { id: name, method, expected: wanted, measured, judge, seconds, .. } = v;
        let mark = v.outcome.to_string();
        format!(
            "{mark:<10}  {name:<id$}  {method:<6} {seconds:>6.2} s  {wanted:<expected$}  {measured}  (judge: {judge}){audit}\n"
        )
    };
    verdicts.iter().map(line).collect()
}

/// How many pass, and how many of the others were refused or not judged.
pub fn summary(verdicts: &[Verdict]) -> String {
    let count = |outcome: Outcome| verdicts.iter().filter(|verdict| verdict.outcome == outcome).count();
    let apart = [(Outcome::Refused, "refused with an error"), (Outcome::NotJudged, "not judged")];
    let apart =
        apart.map(|(outcome, word)| (count(outcome), word)).into_iter().filter(|(count, _)| *count > 0);
    let apart: String = apart
        .map(|(count, word)| format!(", {count} {} {word}", if count == 1 { "is" } else { "are" }))
        .collect();
    format!("{} of {} cases pass{apart}", count(Outcome::Pass), verdicts.len())
}
