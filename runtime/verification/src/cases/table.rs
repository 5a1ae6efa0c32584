//! The table on standard output.

use super::verdict::Verdict;

/// One line for each case: verdict, id, method, what was expected and what was measured.
pub fn text(verdicts: &[Verdict]) -> String {
    let width = |of: fn(&Verdict) -> &str| verdicts.iter().map(|v| of(v).chars().count()).max().unwrap_or(0);
    let [id, expected] = [width(|v| &v.id), width(|v| &v.expected)];
    let line = |v: &Verdict| {
        let mark = if v.pass { "pass" } else { "FAIL" };
        let judge = v.judge.as_ref().map_or_else(String::new, |judge| format!("  (judge: {judge})"));
        let Verdict { id: name, method, expected: wanted, measured, seconds, .. } = v;
        format!("{mark}  {name:<id$}  {method:<6} {seconds:>6.2} s  {wanted:<expected$}  {measured}{judge}\n")
    };
    verdicts.iter().map(line).collect()
}

/// How many pass.
pub fn summary(verdicts: &[Verdict]) -> String {
    let passed = verdicts.iter().filter(|verdict| verdict.pass).count();
    format!("{passed} of {} cases pass", verdicts.len())
}
