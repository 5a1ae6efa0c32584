//! Error against run time of the default run.

use super::Subject;
use crate::html::{escaped, fitting};
use crate::registry::{MethodId, MotionError, PrecisionSpec};
use crate::work_precision::{DISTURBED_NOTE, WorkPrecisionRow, figure_so_wide, rows};
use core::convert::Infallible;
use core::fmt::Write;
use std::time::Duration;

/// Fewer tolerances and shorter times than those of `precision`, which is for measuring.
const TOLERANCES: [f64; 5] = [1e-4, 1e-6, 1e-8, 1e-10, 1e-12];
const MEASURING: Duration = Duration::from_millis(2);

pub fn html(subject: &Subject) -> Result<String, MotionError> {
    let request = PrecisionSpec {
        methods: MethodId::ALL.to_vec(),
        tolerances: TOLERANCES.to_vec(),
        measuring: MEASURING,
    };
    let rows = rows(subject.model, &subject.spec, &request)?;
    Ok(drawn(&rows) + &table(&rows))
}

fn drawn(rows: &[WorkPrecisionRow]) -> String {
    if rows.iter().all(|row| row.state_error.is_none()) {
        return String::new();
    }
    let Ok(drawn) = fitting(|width| Ok::<_, Infallible>(figure_so_wide(rows, width)));
    format!("<div class=figures>{drawn}</div>\n")
}

fn table(rows: &[WorkPrecisionRow]) -> String {
    let mut html = String::from(
        "<details><summary>In numbers</summary>\n<div class=table><table>\n<thead><tr><th class=word>method<th>tolerance\
         <th>error over the run<th>of the final state<th>of event times<th>steps<th>least µs<th class=word>reference<th class=word>remark</tr></thead>\n<tbody>\n",
    );
    let error =
        |error: Option<f64>| error.map_or("–".into(), |error| format!("{error:.1e}").replace('-', "−"));
    for row in rows {
        let _ = writeln!(
            html,
            "<tr><td class=word>{}<td>{}<td>{}<td>{}<td>{}<td>{}<td>{:.1}{}<td class=word>{}<td class=word>{}</tr>",
            row.method,
            format!("{:e}", row.tolerance).replace('-', "−"),
            error(row.run_error),
            error(row.state_error),
            error(row.event_error),
            row.steps.unwrap_or_default(),
            row.microseconds,
            row.mark_disturbed(),
            row.reference.as_deref().unwrap_or(if row.is_not_judged() { "not judged" } else { "–" }),
            escaped(row.reason.as_deref().unwrap_or_default()),
        );
    }
    html + &format!("</tbody></table></div>\n<p>{DISTURBED_NOTE}</p></details>\n")
}
