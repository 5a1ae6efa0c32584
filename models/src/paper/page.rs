//! `index.html`: one page that needs nothing beside itself.

use super::figure::CaptionedFigure;
use super::quantity::{Row, Value};
use super::reference::References;
use super::strict::comparison::Line;
use super::table::{long, short};
use liftoff_studio::html::{escaped, page};
use liftoff_studio::work_precision::WorkPrecisionRow as Measured;
use std::fmt::Write;

/// What the page shows.
pub struct Page<'a> {
    /// Tolerance of the runs.
    pub tolerance: f64,
    /// The results.
    pub rows: &'a [Row],
    /// Where the published numbers stand in the paper.
    pub tables: &'a References,
    /// Figs. 2 to 10.
    pub figures: &'a [CaptionedFigure],
    /// As published against strict, in two sentences.
    pub difference: Option<String>,
    /// As published against strict, in numbers.
    pub lines: Vec<Line>,
    /// As published against strict, drawn.
    pub comparison: Option<CaptionedFigure>,
    /// Error against run time, drawn.
    pub precision: Vec<CaptionedFigure>,
    /// Error against run time, in numbers.
    pub measured: &'a [Measured],
}

impl Page<'_> {
    /// The page.
    pub fn html(&self) -> String {
        let figures: String = self.figures.iter().map(figure).collect();
        let body = format!(
            "<h1>Bar systems that leave their supports</h1>\n\
             <p>The two systems of Rozenblat and Grishakin (<i>Rus. J. Nonlin. Dyn.</i> 2023, 19(2), 187–200), declared, \
             derived, integrated and compared with the published numbers. Everything under “computed” was read off \
             simulations at a relative tolerance of {tolerance:e}; references have 25 digits and come from closed forms, \
             quadrature and a Taylor integrator of 200 bits.</p>\n\
             <nav><a href=#numbers>Numbers</a><a href=#figures>Figures</a><a href=#both>As published and strict</a>\
             <a href=#time>Error against run time</a></nav>\n\
             <h2 id=numbers>Numbers</h2>\n{numbers}\
             <h2 id=figures>Figures of the paper, redrawn</h2>\n<div class=figures>\n{figures}</div>\n\
             <h2 id=both>Fig. 1b as published and strict</h2>\n{both}\
             <h2 id=time>Error against run time</h2>\n<div class=figures>\n{precision}</div>\n{measured}",
            tolerance = self.tolerance,
            numbers = self.numbers(),
            both = self.both(),
            precision = self.precision.iter().map(wide).collect::<String>(),
            measured = self.measured(),
        );
        page("Bar systems that leave their supports", "", &body)
    }

    fn numbers(&self) -> String {
        let mut html = String::from(
            "<div class=table><table>\n<thead><tr><th class=word>id<th class=word>quantity<th class=word>unit\
             <th>published<th>computed<th>reference<th>relative error</tr></thead>\n<tbody>\n",
        );
        let mut group = "";
        for row in self.rows {
            let prefix = row.id.split('.').next().unwrap_or_default();
            let class = if prefix == group { "" } else { " class=first" };
            group = prefix;
            let source = self.tables.published(&row.id).map_or("", |printed| &printed.source);
            let published = row.published.map_or_else(dash, |value| {
                format!("<span title=\"{}\">{}</span>", escaped(source), minus(&short(value)))
            });
            let _ = writeln!(
                html,
                "<tr{class}><td class=word>{}<td class=\"word wide\">{}<td class=word>{}<td>{published}<td>{}<td>{}<td>{}</tr>",
                escaped(&row.id),
                row.quantity,
                row.unit,
                value(row.computed.as_ref()),
                value(row.reference.as_ref()),
                row.relative_error.map_or_else(dash, |error| minus(&format!("{error:.1e}"))),
            );
        }
        html + "</tbody></table></div>\n<p>Relative to the larger of |reference| and 0.1. A dash: the paper prints nothing, \
                or the motion has no such event.</p>\n"
    }

    fn both(&self) -> String {
        let mut html = String::new();
        if let Some(difference) = &self.difference {
            let _ = writeln!(html, "<p id=difference>{difference}</p>");
        }
        html += "<div class=table><table>\n<caption>Angles in rad. λ = m₂/(m₁ + m₂); inner and outer angle where they differ.</caption>\n\
                 <thead><tr><th>λ<th>published: lift-off<th>B, D touch<th class=word>strict: first<th>at\
                 <th class=word>then<th>inner<th>outer<th>B, D touch: inner<th>outer</tr></thead>\n<tbody>\n";
        for line in &self.lines {
            let (first, at) = line
                .first
                .as_ref()
                .map_or((dash(), dash()), |(names, phi)| (names.clone(), angle(Some(*phi))));
            let (then, [inner, outer]) = line
                .second
                .as_ref()
                .map_or((dash(), [None, None]), |(names, pair)| (names.clone(), pair.map(Some)));
            let touch = line.touch.map_or([None, None], |pair| pair.map(Some));
            let _ = writeln!(
                html,
                "<tr><td>{}<td>{}<td>{}<td class=word>{first}<td>{at}<td class=word>{then}<td>{}<td>{}<td>{}<td>{}</tr>",
                line.ratio,
                angle(line.published[0]),
                angle(line.published[1]),
                angle(inner),
                angle(outer),
                angle(touch[0]),
                angle(touch[1]),
            );
        }
        html += "</tbody></table></div>\n";
        let drawn = self.comparison.as_ref().map(wide).unwrap_or_default();
        let _ = writeln!(html, "<div class=figures style=\"margin-top:1.25rem\">\n{drawn}</div>");
        html
    }

    fn measured(&self) -> String {
        let mut html = String::from(
            "<details style=\"margin-top:1.25rem\"><summary>In numbers</summary>\n<div class=table><table>\n<thead><tr>\
             <th class=word>system<th class=word>method<th>tolerance<th>steps<th>evaluations<th>Jacobians<th>least, µs\
             <th>median, µs<th>state error<th>event error<th class=word>remark</tr></thead>\n<tbody>\n",
        );
        let count = |count: Option<u64>| count.map_or_else(dash, |count| count.to_string());
        let error = |error: Option<f64>| error.map_or_else(dash, |error| minus(&format!("{error:.1e}")));
        let mut last = "";
        for row in self.measured {
            let class = if row.method == last { "" } else { " class=first" };
            last = &row.method;
            let _ = writeln!(
                html,
                "<tr{class}><td class=word>{}<td class=word>{}<td>{}<td>{}<td>{}<td>{}<td>{:.1}<td>{}<td>{}<td>{}\
                 <td class=word>{}</tr>",
                escaped(&row.model),
                escaped(&row.method),
                minus(&format!("{:e}", row.tolerance)),
                count(row.steps),
                count(row.evaluations),
                count(row.jacobians),
                row.microseconds,
                row.median_microseconds.map_or_else(dash, |median| format!("{median:.1}")),
                error(row.state_error),
                error(row.event_error),
                escaped(row.reason.as_deref().unwrap_or_default()),
            );
        }
        html + "</tbody></table></div></details>\n"
    }
}

fn figure(figure: &CaptionedFigure) -> String {
    framed(figure, if figure.svg.contains("width=\"860\"") { " class=wide" } else { "" })
}

fn wide(figure: &CaptionedFigure) -> String {
    framed(figure, " class=wide")
}

fn framed(figure: &CaptionedFigure, class: &str) -> String {
    let CaptionedFigure { anchor, title, caption, svg } = figure;
    let anchor = if anchor.is_empty() { String::new() } else { format!(" id={anchor}") };
    format!("<figure{anchor}{class}>\n{svg}<figcaption><b>{title}.</b> {caption}</figcaption></figure>\n")
}

fn value(value: Option<&Value>) -> String {
    value.map_or_else(dash, |value| minus(&long(value)))
}

fn angle(value: Option<f64>) -> String {
    value.map_or_else(dash, |value| minus(&format!("{value:.10}")))
}

fn dash() -> String {
    "–".into()
}

fn minus(text: &str) -> String {
    text.replace('-', "−")
}
