//! The default run before the audit and the independent judge.

use super::Subject;
use crate::html::escaped;
use crate::registry::MotionError;
use liftoff_verification::judgement::judge;

pub fn html(subject: &Subject) -> Result<String, MotionError> {
    let record = subject.record()?;
    let held: Vec<&str> = subject.spec.hold.iter().map(String::as_str).collect();
    let audit = record.audit();
    let findings: Vec<String> =
        audit.violations().map(|finding| format!("<li>{}</li>\n", escaped(&finding.to_string()))).collect();
    let audited = match findings.is_empty() {
        true => "<p>Audit: no finding.</p>\n".to_owned(),
        false => format!("<p class=vermilion>Audit:</p>\n<ul>\n{}</ul>\n", findings.concat()),
    };
    Ok(format!("{audited}<p>Judge: {}.</p>\n", escaped(&judge(record, &held).to_string())))
}
