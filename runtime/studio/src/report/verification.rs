//! What the stability suite asks of any model's default run.

use super::Subject;
use crate::checks::{Effort, GENERAL, Verdict, summary, verdict_table};
use crate::html::escaped;
use crate::registry::MotionError;
use std::time::Duration;

/// A case that has not answered by then never will.
const PATIENCE: Duration = Duration::from_secs(60);

pub fn html(subject: &Subject) -> Result<String, MotionError> {
    let mut html = String::new();
    let mut all: Vec<Verdict> = Vec::new();
    for group in GENERAL {
        let cases = (group.cases)(subject.model, Effort::Short).into_iter();
        let verdicts: Vec<_> = cases.map(|case| case.judge(PATIENCE)).collect();
        if !verdicts.is_empty() {
            html += &format!("<h3>{}</h3>\n{}", escaped(group.title), verdict_table(&verdicts));
        }
        all.extend(verdicts);
    }
    Ok(format!("<p>{}.</p>\n{html}", summary(&all)))
}
