//! The page that leads to all others.

use super::Report;
use crate::html::{escaped, page};

const STYLE: &str = ".figures { grid-template-columns: repeat(auto-fill, minmax(15rem, 1fr)); }\n\
                     figure a { display: block; text-decoration: none; }\n\
                     figure svg { height: 11rem; width: auto; max-width: 100%; margin-bottom: .6rem; }\n";

/// An index of these reports, each in a file of its model's name beside it.
pub fn index(title: &str, reports: &[Report]) -> String {
    let body = format!(
        "<h1>{}</h1>\n<div class=figures>\n{}</div>\n",
        escaped(title),
        reports.iter().map(card).collect::<String>(),
    );
    page(title, STYLE, &body)
}

fn card(report: &Report) -> String {
    let Report { name, summary, drawing, missing, .. } = report;
    let missing = match missing.len() {
        0 => String::new(),
        _ => format!(" <span class=vermilion>Missing: {}.</span>", escaped(&missing.join("; "))),
    };
    format!(
        "<figure><a href=\"{name}.html\">{drawing}<b>{name}</b></a><figcaption>{summary}{missing}</figcaption></figure>\n",
        name = escaped(name),
        drawing = drawing.as_deref().unwrap_or_default(),
        summary = escaped(summary),
    )
}
