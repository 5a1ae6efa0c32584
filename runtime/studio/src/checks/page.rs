//! `stability.html`: one page that needs nothing beside itself.

use crate::html::{escaped, page};
use liftoff_verification::cases::GroupResult;
use liftoff_verification::cases::Verdict;
use liftoff_verification::cases::summary;
use std::fmt::Write;

/// The page.
pub fn html(groups: &[GroupResult]) -> String {
    let groups: Vec<_> = groups.iter().filter(|group| !group.verdicts.is_empty()).collect();
    let links = groups.iter().map(|group| format!("<a href=#{0}>{0}</a>", group.name));
    let sections = groups.iter().map(|&GroupResult { name, title, verdicts }| {
        format!("<h2 id={name}>{}</h2>\n{}", escaped(title), table(verdicts))
    });
    let verdicts: Vec<_> = groups.iter().flat_map(|group| group.verdicts.iter().cloned()).collect();
    let body = format!(
        "<h1>Numerical stability</h1>\n\
         <p>Stiff, extreme and degenerate scenes, and the same run computed in other ways. What is expected comes from \
         closed forms, quadrature or Taylor series in 40 digits, integration in double-double, or mechanics; never from the \
         run that is judged. An independent judge and an audit look at each recorded run: what they refute fails, and what there \
         is nothing independent to compare with is not judged. {summary}.</p>\n<nav>{links}</nav>\n{sections}",
        summary = summary(&verdicts),
        links = links.collect::<String>(),
        sections = sections.collect::<String>(),
    );
    page("Numerical stability", STYLE, &body)
}

/// What the tables ask of a page that has them.
pub(crate) const STYLE: &str = include_str!("page.css");

/// Verdicts as a table.
pub(crate) fn table(verdicts: &[Verdict]) -> String {
    let mut html = String::from(
        "<div class=table><table class=cases>\n<thead><tr><th class=word>verdict<th class=word>case<th class=word>scene\
         <th class=word>expected<th class=word>measured<th class=word>judge<th class=word>from<th class=word>method<th>s\
         </tr></thead>\n<tbody>\n",
    );
    for verdict in verdicts {
        let name = verdict.id.split_once('.').map_or(verdict.id.as_str(), |(_, name)| name);
        let style = if verdict.fails() { "\"word vermilion\"" } else { "word" };
        let audit = verdict.audit.as_ref().map_or_else(String::new, |audit| format!("; audit: {audit}"));
        let _ = writeln!(
            html,
            "<tr><td class={style}>{}<td class=word>{}<td class=\"word long\">{}<td class=\"word long\">{}\
             <td class=\"word long\">{}<td class=\"word long\">{}<td class=word>{}<td class=word>{}<td>{:.2}</tr>",
            verdict.outcome,
            escaped(name),
            escaped(&verdict.scene),
            escaped(&verdict.expected),
            escaped(&verdict.measured),
            escaped(&(verdict.judge.clone() + &audit)),
            verdict.source,
            verdict.method,
            verdict.seconds,
        );
    }
    html + "</tbody></table></div>\n"
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_group_without_cases_is_left_out() {
        let empty = GroupResult { name: "forms", title: "Other forms", verdicts: Vec::new() };
        let html = html(&[empty]);
        assert!(!html.contains("Other forms") && !html.contains("<table") && !html.contains("#forms"));
    }
}
