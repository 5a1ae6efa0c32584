//! What the paper prints beside what is computed.

use super::{Page, dash, minus};
use crate::paper::quantity::Value;
use crate::paper::table::reproduced;
use crate::paper::table1::{self, Entry, Table1};
use liftoff_studio::html::escaped;
use std::fmt::Write;

impl Page<'_> {
    pub(super) fn printed(&self) -> String {
        let (count, others) = reproduced(self.rows, self.tables);
        let total = count + others.len();
        let others: String = others.iter().map(|other| format!("<li>{}", minus(&escaped(other)))).collect();
        format!(
            "{}{}<p>{count} of the {total} numbers are reproduced to the last digit that is printed. The others:</p>\n\
             <ul>{others}</ul>\n",
            self.table1(),
            self.others()
        )
    }

    /// In the paper's layout, print above computation.
    fn table1(&self) -> String {
        let table = Table1::from_rows(self.rows, self.tables);
        let mut html = String::from(
            "<div class=table><table>\n<caption>Table 1. Values of the angles φ*, φ₁, φ₂ and of μ(φ*, λ): the least total reaction, \
             lift-off, B and D on the floor. In grey as printed.</caption>\n<thead><tr><th class=word>λ",
        );
        table.ratios.iter().for_each(|ratio| html += &format!("<th>{ratio}"));
        html += "</tr></thead>\n<tbody>\n";
        for (name, entries) in &table.lines {
            let printed: String =
                entries.iter().map(|entry| format!("<td class=print>{}", minus(&entry.printed))).collect();
            let computed: String = entries.iter().map(computed).collect();
            let _ = writeln!(
                html,
                "<tr class=first><td class=word rowspan=2>{name}{printed}</tr>\n<tr>{computed}</tr>"
            );
        }
        html + "</tbody></table></div>\n<p>At λ = 0 N only touches zero: φ₁ = φ₂, no flight. λ = 1 has no sense, as the paper \
                says (its inner bars have no mass).</p>\n"
    }

    fn others(&self) -> String {
        let mut html = String::from(
            "<div class=table><table>\n<caption>Printed in text and figures.</caption>\n<thead><tr><th class=word>quantity\
             <th class=word>unit<th>printed<th>computed<th class=word>where</tr></thead>\n<tbody>\n",
        );
        for row in self.rows.iter().filter(|row| !table1::holds(&row.id)) {
            let Some(printed) = self.tables.published(&row.id) else { continue };
            let value = match row.computed {
                Some(Value::Number(value)) => Some(value),
                _ => None,
            };
            let text = value.map_or_else(dash, |value| minus(&format!("{:.8}", printed.in_its_unit(value))));
            let class = if value.is_some_and(|value| printed.is_reproduced_by(value)) {
                ""
            } else {
                " class=differs"
            };
            let what = row.name_as(printed.what.as_deref());
            let _ = writeln!(
                html,
                "<tr><td class=\"word wide\">{what}<td class=word>{}<td class=print>{}<td{class}>{text}<td class=word>{}</tr>",
                printed.unit,
                minus(printed.text()),
                escaped(&printed.source),
            );
        }
        html + "</tbody></table></div>\n"
    }
}

fn computed(entry: &Entry) -> String {
    let class = if entry.reproduced { "" } else { " class=differs" };
    format!("<td{class}>{}", entry.computed.map_or_else(dash, |value| minus(&format!("{value:.10}"))))
}
