//! The table on standard output.

use super::verdict::{Outcome, Verdict};

/// One line for each case: outcome, id, method, what was expected and what was measured, what the
/// judge finds.
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

/// How many pass, and how many of the others fail, were refused or not judged.
pub fn summary(verdicts: &[Verdict]) -> String {
    let count = |outcome: Outcome| verdicts.iter().filter(|verdict| verdict.outcome == outcome).count();
    let apart = [
        (Outcome::Fail, ["fails", "fail"]),
        (Outcome::Refused, ["is refused with an error", "are refused with an error"]),
        (Outcome::NotJudged, ["is not judged", "are not judged"]),
    ];
    let apart =
        apart.map(|(outcome, words)| (count(outcome), words)).into_iter().filter(|(count, _)| *count > 0);
    let apart: String = apart
        .map(|(count, [one, more])| match count {
            1 => format!(", 1 {one}"),
            _ => format!(", {count} {more}"),
        })
        .collect();
    format!("{} of {} cases pass{apart}", count(Outcome::Pass), verdicts.len())
}

#[cfg(test)]
mod tests {
    use super::super::{Case, Expected};
    use super::*;
    use std::time::Duration;

    #[test]
    fn the_summary_says_how_many_fail() {
        let verdict = |wanted: &str| {
            let expected = Expected::Refusal(wanted.to_owned());
            let measure = |_| Err(crate::MotionError::Input("the rates break slider L".to_owned()));
            Case::new("a.b", "", "mechanics", expected, measure).judge(Duration::from_secs(60))
        };
        let [good, bad] = ["slider L", "slider R"].map(verdict);
        assert_eq!(summary(&[good.clone(), bad.clone()]), "1 of 2 cases pass, 1 fails");
        assert_eq!(summary(&[bad.clone(), good, bad]), "1 of 3 cases pass, 2 fail");
    }
}
