//! Equations as a LaTeX document.

use core::fmt::Write;
use liftoff_codegen::math::Equation;
use liftoff_codegen::text::{Equations, PhaseEquations};

pub(super) const HEAD: &str = "\\documentclass[a4paper]{article}\n\
    \\usepackage[margin=2cm]{geometry}\n\
    \\usepackage{amsmath}\n\
    \\allowdisplaybreaks\n\
    \\begin{document}\n";

/// A document that LaTeX sets with `amsmath`; long equations are broken before signs.
pub fn latex(equations: &Equations) -> String {
    let mut text = HEAD.to_owned();
    let _ = writeln!(text, "\\section*{{{}}}", escaped(&equations.name));
    if !equations.summary.is_empty() {
        let _ = writeln!(text, "{}", prose(&equations.summary));
    }
    text += "\\begin{description}\n";
    for coordinate in &equations.coordinates {
        let symbol = coordinate.symbol.latex();
        let _ = writeln!(text, "\\item[${symbol}$] {}", escaped(&coordinate.meaning));
    }
    text += "\\end{description}\n";
    let named = equations.energies.iter().chain(&equations.mass).chain(&equations.velocity_terms);
    let named = named.chain(&equations.forces).chain(&equations.definitions).chain(&equations.gaps);
    text += &aligned(&named.collect::<Vec<_>>());
    for (name, constraint) in &equations.joints {
        let equation = Equation::new(liftoff_codegen::math::Math::ZERO, constraint.clone());
        let _ = writeln!(text, "{}:\n{}", escaped(name), aligned(&[&equation]));
    }
    equations.sections().for_each(|each| text += &phase(each));
    text + "\\end{document}\n"
}

/// The equations of the phases in display mode, for what sets LaTeX without documents: a notebook.
pub fn latex_display(equations: &Equations) -> String {
    let of = |phase: &PhaseEquations| {
        let title = format!("&\\textbf{{{}}}", escaped(&capital(&phase.title())));
        let rows = rows(phase).into_iter().map(Equation::aligned);
        let rows: Vec<String> = [title].into_iter().chain(rows).collect();
        format!("$$\\begin{{aligned}}\n  {}\n\\end{{aligned}}$$\n", rows.join(" \\\\\n  "))
    };
    equations.sections().map(of).collect()
}

/// The same for one of its phases.
pub fn phase_latex(equations: &PhaseEquations) -> String {
    format!("{HEAD}{}\\end{{document}}\n", phase(equations))
}

fn phase(phase: &PhaseEquations) -> String {
    format!("\\subsection*{{{}}}\n{}", capital(&escaped(&phase.title())), aligned(&rows(phase)))
}

fn rows(phase: &PhaseEquations) -> Vec<&Equation> {
    let equations = phase.eliminated.iter().chain(&phase.energies).chain(&phase.motion);
    equations.chain(&phase.reactions).collect()
}

fn aligned(equations: &[&Equation]) -> String {
    if equations.is_empty() {
        return String::new();
    }
    let rows: Vec<String> = equations.iter().map(|equation| equation.aligned()).collect();
    format!("\\begin{{align*}}\n  {}\n\\end{{align*}}\n", rows.join(" \\\\\n  "))
}

fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

/// A line of documentation; what stands between backticks is code.
fn prose(text: &str) -> String {
    let parts = text.split('`').enumerate();
    let set = |(i, part): (usize, &str)| match i % 2 {
        0 => escaped(part),
        _ => format!("\\texttt{{{}}}", escaped(part)),
    };
    parts.map(set).collect()
}

/// Text as LaTeX reads it.
pub(super) fn escaped(text: &str) -> String {
    let mut out = String::new();
    for c in text.chars() {
        match c {
            '\\' => out += "\\textbackslash{}",
            '~' => out += "\\textasciitilde{}",
            '^' => out += "\\textasciicircum{}",
            '&' | '%' | '$' | '#' | '_' | '{' | '}' => out.extend(['\\', c]),
            _ => out.push(c),
        }
    }
    out
}
