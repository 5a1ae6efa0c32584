//! Lift-off conditions in closed form and first integrals, as text, as LaTeX and as a page.

use core::fmt::Write;

pub use liftoff_conditions::{Piece, Request, Section};
use liftoff_conditions::{Statement, sections as of_analysis};
use liftoff_core::model::Layout;

use super::derived;
use super::latex::{HEAD, escaped as in_latex};
use crate::html::{escaped, page as skeleton};

const STYLE: &str = "p { padding-left: 2em; text-indent: -2em; line-height: 2 }\n";

/// The conditions and first integrals of a model, contact set by contact set, or of the set with
/// these supports closed.
///
/// # Errors
/// The mistakes of a declaration that has any; what the contact set, or the start, has that a
/// condition in closed form cannot have.
pub fn conditions(
    layout: &Layout,
    supports: Option<&str>,
    request: &Request,
) -> Result<Vec<Section>, String> {
    derived(layout, |analysis| Ok(of_analysis(analysis, supports, request)))?
        .map_err(|error| error.to_string())
}

/// As text, under the model's name.
pub fn text(name: &str, sections: &[Section]) -> String {
    let sections = sections.iter().map(|section| format!("\n{section}"));
    format!("{name}\n{}", sections.collect::<String>())
}

/// A document that LaTeX sets with `amsmath`; long equations are broken before signs.
pub fn latex(name: &str, sections: &[Section]) -> String {
    let mut text = format!("{HEAD}\\section*{{{}}}\n", in_latex(name));
    for section in sections {
        let _ = writeln!(text, "\\subsection*{{{}}}", in_latex(&section.title));
        section.statements.iter().for_each(|statement| text += &paragraph(statement));
    }
    text + "\\end{document}\n"
}

fn paragraph(statement: &Statement) -> String {
    let pieces = statement.0.iter().map(|piece| match piece {
        Piece::Words(words) => in_latex(words),
        Piece::Formula(formula) => format!("${}$", formula.latex()),
        Piece::Equation(equation) => format!("\\begin{{align*}}\n  {}\n\\end{{align*}}", equation.aligned()),
    });
    format!("\\noindent {}\n\n", pieces.collect::<Vec<_>>().join("\n"))
}

/// A page whose formulas browsers set without scripts.
pub fn page(name: &str, sections: &[Section]) -> String {
    let mut body = format!("<h1>{}</h1>\n", escaped(name));
    for section in sections {
        let _ = writeln!(body, "<h2>{}</h2>", escaped(&section.title));
        for statement in &section.statements {
            let pieces = statement.0.iter().map(|piece| match piece {
                Piece::Words(words) => escaped(words),
                Piece::Formula(formula) => formula.mathml(),
                Piece::Equation(equation) => equation.mathml(),
            });
            let _ = writeln!(body, "<p>{}</p>", pieces.collect::<Vec<_>>().join(" "));
        }
    }
    skeleton(&format!("{name}: conditions of lift-off"), STYLE, &body)
}
