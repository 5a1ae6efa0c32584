//! Equations as a page that needs nothing beside itself: KaTeX sets them where there is JavaScript,
//! and their LaTeX is read where there is none.

mod sections;
#[cfg(test)]
mod tests;

use liftoff_codegen::text::{Equations, PhaseEquations};

use crate::html::{escaped, page as skeleton};
use sections::Sections;

const KATEX: &str = include_str!("katex/katex.min.js");
const FONTS: &str = include_str!("katex/katex.css");
/// What equations ask of a page that has them, beside the fonts.
pub(crate) const STYLE: &str = include_str!("page.css");

/// KaTeX breaks a line before the signs of an equation where it has to, on any width.
const RENDER: &str = "for (const math of document.querySelectorAll('.tex')) \
    katex.render(math.textContent, math, { throwOnError: false });";

/// Drawings of a page, as SVG.
#[derive(Clone, Debug, Default)]
pub struct Drawings {
    /// The model.
    pub model: Option<String>,
    /// The graph of its [`modes`](fn@liftoff::modes).
    pub modes: Option<String>,
}

/// The page of a model.
pub fn page(equations: &Equations, drawings: &Drawings) -> String {
    let mut sections = Sections::default();
    sections.head(equations, drawings.modes.is_some());
    sections.model(equations, drawings.model.as_deref());
    sections.system(equations);
    for (i, phase) in equations.sections().enumerate() {
        sections.phase(i, phase);
    }
    sections.modes(drawings.modes.as_deref());
    sections.costs(&equations.phases);
    sections.left_out(&equations.left_out);
    set(&equations.name, &sections.body)
}

/// The page of one of its phases.
pub fn phase_page(name: &str, phase: &PhaseEquations) -> String {
    let mut sections = Sections::default();
    sections.title(name);
    sections.phase(0, phase);
    set(name, &sections.body)
}

/// The equations as a part of another page, with the fonts and the scripts that set them.
pub(crate) fn part(equations: &Equations) -> String {
    let mut sections = Sections::default();
    sections.system(equations);
    for (i, phase) in equations.sections().enumerate() {
        sections.phase(i, phase);
    }
    sections.costs(&equations.phases);
    sections.left_out(&equations.left_out);
    format!("<style>\n{FONTS}</style>\n<div class=part>\n{}</div>\n{}", sections.body, scripts())
}

fn scripts() -> String {
    format!("<script>{KATEX}</script>\n<script>{RENDER}</script>\n")
}

fn set(name: &str, body: &str) -> String {
    let body = format!("{body}{}", scripts());
    skeleton(&format!("{name}: equations of motion"), &format!("{FONTS}{STYLE}"), &body)
}

/// The place of a phase in the page.
fn anchor(index: usize) -> String {
    format!("phase-{index}")
}

fn word(text: &str) -> String {
    format!("<td class=word>{}</td>", escaped(text))
}
