//! `stability.html`: one page that needs nothing beside itself.

use super::verdict::Verdict;
use super::{GROUPS, Group, summary};
use liftoff::html::{escaped, page};
use std::fmt::Write;

/// The page.
pub fn html(verdicts: &[Verdict]) -> String {
    let of = |group: &Group| {
        let prefix = format!("{}.", group.name);
        verdicts.iter().filter(|v| v.id.starts_with(&prefix)).collect::<Vec<_>>()
    };
    let groups: Vec<_> = GROUPS.iter().map(|g| (g, of(g))).filter(|(_, cases)| !cases.is_empty()).collect();
    let links = groups.iter().map(|(group, _)| format!("<a href=#{0}>{0}</a>", group.name));
    let sections = groups.iter().map(|(group, cases)| section(group, cases));
    let body = format!(
        "<h1>Numerical stability</h1>\n\
         <p>Stiff, extreme and degenerate scenes. What is expected comes from closed forms, quadrature or Taylor series in \
         40 digits, or mechanics; never from a run of the code that is judged. {summary}.</p>\n\
         <nav>{links}</nav>\n{sections}",
        summary = summary(verdicts),
        links = links.collect::<String>(),
        sections = sections.collect::<String>(),
    );
    page("Numerical stability", "td.word { white-space: normal; min-width: 9rem; }\n", &body)
}

fn section(group: &Group, cases: &[&Verdict]) -> String {
    let mut html = format!(
        "<h2 id={}>{}</h2>\n<div class=table><table>\n<thead><tr><th class=word>case<th class=word>scene\
         <th class=word>expected<th class=word>from<th class=word>measured<th class=word>method<th>s<th class=word>verdict\
         </tr></thead>\n<tbody>\n",
        group.name, group.title,
    );
    for verdict in cases {
        let name = verdict.id.split_once('.').map_or(verdict.id.as_str(), |(_, name)| name);
        let mark = if verdict.pass { "<td class=word>pass" } else { "<td class=\"word vermilion\">FAIL" };
        let _ = writeln!(
            html,
            "<tr><td class=word>{}<td class=word>{}<td class=word>{}<td class=word>{}<td class=word>{}<td class=word>{}<td>{:.2}{mark}</tr>",
            escaped(name),
            escaped(&verdict.scene),
            escaped(&verdict.expected),
            verdict.source,
            escaped(&verdict.measured),
            verdict.method,
            verdict.seconds,
        );
    }
    html + "</tbody></table></div>\n"
}
