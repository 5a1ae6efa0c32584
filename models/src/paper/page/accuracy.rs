//! Tables of computed values against references of 25 digits, and of error against run time.

use super::{Page, dash, figures, minus};
use crate::paper::precision::explain_norm;
use crate::paper::quantity::Value;
use crate::paper::table::long;
use liftoff_studio::html::escaped;
use liftoff_studio::work_precision::DISTURBED_NOTE;
use std::fmt::Write;

impl Page<'_> {
    pub(super) fn accuracy(&self) -> String {
        let mut html = String::from(
            "<p>References have 25 digits and come from closed forms, quadrature and a Taylor integrator of 200 bits; that of the starts of Fig. 1a that fall in has 13. Errors are \
             relative to the larger of |reference| and 0.1. A dash: the motion has no such event.</p>\n\
             <details><summary>All quantities</summary>\n<div class=table><table>\n<thead><tr><th class=word>quantity\
             <th class=word>unit<th>computed<th>reference<th>relative error</tr></thead>\n<tbody>\n",
        );
        for row in self.rows {
            let _ = writeln!(
                html,
                "<tr><td class=\"word wide\">{}<td class=word>{}<td>{}<td>{}<td>{}</tr>",
                row.name(),
                row.unit,
                value(row.computed.as_ref()),
                value(row.reference.as_ref()),
                row.relative_error.map_or_else(dash, |error| minus(&format!("{error:.1e}"))),
            );
        }
        html + "</tbody></table></div></details>\n"
    }

    pub(super) fn time(&self) -> String {
        format!("<p>{}</p>\n", explain_norm()) + &figures(&self.precision) + &self.measured()
    }

    fn measured(&self) -> String {
        let mut html = String::from(
            "<details style=\"margin-top:1.25rem\"><summary>In numbers</summary>\n<div class=table><table>\n<thead><tr>\
             <th class=word>system<th class=word>method<th>tolerance<th>steps<th>evaluations<th>Jacobians<th>least, µs\
             <th>median, µs<th>error over the run<th>of the final state<th>of event times<th class=word>remark</tr></thead>\n<tbody>\n",
        );
        let count = |count: Option<u64>| count.map_or_else(dash, |count| count.to_string());
        let error = |error: Option<f64>| error.map_or_else(dash, |error| minus(&format!("{error:.1e}")));
        let mut last = "";
        for row in self.measured {
            let class = if row.method == last { "" } else { " class=first" };
            last = &row.method;
            let _ = writeln!(
                html,
                "<tr{class}><td class=word>{}<td class=word>{}<td>{}<td>{}<td>{}<td>{}<td>{:.1}<td>{}<td>{}<td>{}<td>{}\
                 <td class=word>{}</tr>",
                escaped(&row.model),
                escaped(&row.method),
                minus(&format!("{:e}", row.tolerance)),
                count(row.steps),
                count(row.evaluations),
                count(row.jacobians),
                row.microseconds,
                row.median_microseconds
                    .map_or_else(dash, |median| { format!("{median:.1}{}", row.mark_disturbed()) }),
                error(row.run_error),
                error(row.state_error),
                error(row.event_error),
                escaped(row.reason.as_deref().unwrap_or_default()),
            );
        }
        html + &format!("</tbody></table></div>\n<p>{DISTURBED_NOTE}</p></details>\n")
    }
}

fn value(value: Option<&Value>) -> String {
    value.map_or_else(dash, |value| minus(&long(value)))
}
