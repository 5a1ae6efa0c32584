//! Equations as a page that needs nothing beside itself: KaTeX sets them where there is JavaScript, and their LaTeX is
//! read where there is none.

mod sections;
#[cfg(test)]
mod tests;

use liftoff_codegen::text::{Equations, PhaseEquations};

use crate::html::{escaped, page as skeleton};
use sections::Sections;

const KATEX: &str = include_str!("katex/katex.min.js");
const FONTS: &str = include_str!("katex/katex.css");
const STYLE: &str = include_str!("page.css");

/// KaTeX breaks a line before the signs of an equation where it has to, on any width.
const RENDER: &str = "for (const math of document.querySelectorAll('.tex')) \
    katex.render(math.textContent, math, { throwOnError: false });";

/// Drawings of a page, as SVG.
#[derive(Clone, Debug, Default)]
pub struct Drawings {
    /// The model.
    pub model: Option<String>,
    /// The graph of its [`modes`](crate::modes).
    pub modes: Option<String>,
}

/// The page of a model.
pub fn page(equations: &Equations, drawings: &Drawings) -> String {
    let mut sections = Sections::default();
    sections.head(equations, drawings.modes.is_some());
    sections.model(equations, drawings.model.as_deref());
    sections.system(equations);
    for (i, phase) in equations.phases.iter().enumerate() {
        sections.phase(i, phase);
    }
    sections.modes(drawings.modes.as_deref());
    sections.costs(&equations.phases);
    sections.left_out(&equations.left_out);
    set(&equations.name, &sections.body)
}

/// The equations alone, operations and what is left out, to stand in another page that has [`style`] and ends with
/// [`scripts`].
pub fn fragment(equations: &Equations) -> String {
    let mut sections = Sections::default();
    sections.system(equations);
    for (i, phase) in equations.phases.iter().enumerate() {
        sections.phase(i, phase);
    }
    sections.costs(&equations.phases);
    sections.left_out(&equations.left_out);
    sections.body
}

/// The style sheet of equations, fonts included.
pub fn style() -> String {
    format!("{FONTS}{STYLE}")
}

/// What sets the equations of a page, to stand at its end.
pub fn scripts() -> String {
    format!("<script>{KATEX}</script>\n<script>{RENDER}</script>\n")
}

/// The page of one of its phases.
pub fn phase_page(name: &str, phase: &PhaseEquations) -> String {
    let mut sections = Sections::default();
    sections.title(name);
    sections.phase(0, phase);
    set(name, &sections.body)
}

fn set(name: &str, body: &str) -> String {
    skeleton(&format!("{name}: equations of motion"), &style(), &format!("{body}{}", scripts()))
}

/// The place of a phase in the page.
fn anchor(index: usize) -> String {
    format!("phase-{index}")
}

fn word(text: &str) -> String {
    format!("<td class=word>{}</td>", escaped(text))
}
