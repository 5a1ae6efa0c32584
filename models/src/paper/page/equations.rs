//! The equations as derived from the declarations, beside those of the paper.

use crate::systems::{FallingPair, ZigzagPublished};
use liftoff::prelude::BarSystem;
use liftoff_core::model::Layout;
use liftoff_studio::equations;
use liftoff_studio::explain::conditions::{Piece, Request, conditions};
use liftoff_studio::html::escaped;
use std::f64::consts::FRAC_PI_2;

/// A contact set, with a start from rest if it has one, and the paper's equations for it; those of
/// the paper are for one bar of mass 1 in Fig. 1a.
struct Set {
    layout: &'static Layout,
    title: &'static str,
    closed: &'static [&'static str],
    start: Option<f64>,
    paper: &'static str,
}

const SETS: [Set; 4] = [
    Set {
        layout: FallingPair::LAYOUT,
        title: "Fig. 1a, both corners touch",
        closed: &["P, Q"],
        start: Some(0.0),
        paper: "(3.1)  T = (l²/8) (4/3 + 1/cos⁴ φ − 2/cos φ) φ̇²   (one bar, m = 1)\n\
                (3.2)  φ̇² = (4 g/l) (1 − cos φ) tan φ / (4/3 + 1/cos⁴ φ − 2/cos φ)\n\
                (3.3)  φ̈ = ½ dφ̇²/dφ\n\
                (3.4)  N = (g − ÿ)/cos φ, ÿ of a bar's centre:\n       ÿ = (l/2) [(sin φ + 2 sin φ/cos³ φ) φ̇² + (1/cos² φ − cos φ) φ̈]",
    },
    Set {
        layout: FallingPair::LAYOUT,
        title: "Fig. 1a, free",
        closed: &[],
        start: None,
        paper: "(3.5)  T = ⅓ l² φ̇² + ẏ² − ẏ l φ̇ cos φ   (m = 1)\n\
                (3.6)  ⅔ l² φ̈ − ÿ l cos φ = −g l cos φ\n       2 ÿ − l φ̈ cos φ + l φ̇² sin φ = 2 g\n\
                (3.7)  φ̈ (⅔ − ½ cos² φ) + ½ φ̇² sin φ cos φ = 0\n\
                (3.8)  φ̇(φ) = φ̇(φ₁) √[(⅔ − ½ cos² φ₁)/(⅔ − ½ cos² φ)]",
    },
    Set {
        layout: ZigzagPublished::LAYOUT,
        title: "Fig. 1b as published, on A, C, E",
        closed: &["A, C, E"],
        start: Some(FRAC_PI_2),
        paper: "(3.9)  ẋ_K = −(3 l/2) sin φ φ̇,  ẏ_K = (l/2) cos φ φ̇   (K the centre of DE)\n\
                (3.10) v_K² = (l²/4) (1 + 8 sin² φ) φ̇²\n\
                (3.11) T = (m₁ + m₂) (⅓ + 2 λ sin² φ) l² φ̇²\n\
                (3.12) A(mg) = 2 (m₁ + m₂) g (l/2) (sin φ(0) − sin φ)\n\
                (3.13) φ̇² = (g/l) (sin φ(0) − sin φ) / (⅓ + 2 λ sin² φ)\n\
                (3.14) φ̈ = −(g/l) (1/6 + 2 λ sin φ(0) sin φ − λ sin² φ) cos φ / (⅓ + 2 λ sin² φ)²\n\
                (3.15) 2 (m₁ + m₂) (l/2) (φ̇² sin φ − φ̈ cos φ) = 2 (m₁ + m₂) g − N\n\
                (3.16) N = 2 (m₁ + m₂) g [1 − (l/2g) (φ̇² sin φ − φ̈ cos φ)] > 0\n\
                (3.17) φ̇² sin φ − φ̈ cos φ < 2 g/l\n\
                (3.18) [(sin φ(0) − sin φ)/(⅓ + 2 λ sin² φ)] sin φ + (1/6 + 2 λ sin φ(0) sin φ − λ sin² φ) cos² φ/(⅓ + 2 λ sin² φ)² < 2\n\
                (3.19) μ(φ, λ) = [(1 − sin φ)/(⅓ + 2 λ sin² φ)] sin φ + (1/6 + 2 λ sin φ − λ sin² φ) cos² φ/(⅓ + 2 λ sin² φ)² < 2",
    },
    Set {
        layout: ZigzagPublished::LAYOUT,
        title: "Fig. 1b as published, free",
        closed: &[],
        start: None,
        paper: "(3.20) T = (m₁ + m₂) [ẏ² − ẏ φ̇ l cos φ + (⅓ + 2 λ sin² φ) l² φ̇²]\n\
                (3.21) −ÿ cos φ + 2 l φ̈ (⅓ + 2 λ sin² φ) + 4 λ l φ̇² sin φ cos φ = −g cos φ\n       ÿ = g + (l/2) (φ̈ cos φ − φ̇² sin φ)\n       φ̇² [1/12 + (¼ + 2 λ) sin² φ] = h = const\n\
                (3.22) ÿ = g − ½ h l (⅓ + 2 λ) sin φ / [1/12 + (¼ + 2 λ) sin² φ]²",
    },
];

/// Each contact set: what was derived, then the paper.
pub(super) fn html() -> String {
    let sets: String = SETS.iter().map(set).collect();
    format!(
        "<p>Derived by the compiler from the declarations alone, for each contact set; below them the paper's, of which the \
         tests check that both agree at random states. T and N are those of all bars and of both corners here, the paper's (3.1) to \
         (3.5) those of one bar and one corner. <i>y</i> is downward, the drop of D in Fig. 1a and that of C in Fig. 1b.</p>\n\
         <div class=equations>\n{sets}</div>\n"
    )
}

fn set(set: &Set) -> String {
    let lines: String = derive_lines(set).iter().map(|line| format!("{line}\n")).collect();
    format!(
        "<h3>{}</h3>\n<pre>{}</pre>\n<details open><summary>The paper</summary><pre>{}</pre></details>\n",
        set.title,
        escaped(&lines),
        escaped(set.paper)
    )
}

/// The equations of a contact set; on the way from rest φ̇², φ̈ and N as functions of the angle
/// too.
fn derive_lines(Set { layout, closed, start, .. }: &Set) -> Vec<String> {
    let derived = equations(layout);
    let mut lines: Vec<String> = Vec::new();
    // A set without constraints has the energies of the whole system.
    if closed.is_empty() {
        lines.extend(derived.energies.iter().map(ToString::to_string));
    }
    if let Some(phase) = derived.phases.iter().find(|phase| phase.closed == *closed) {
        let text = phase.to_string();
        let equations = text.lines().skip(1).map(str::trim_start);
        lines.extend(equations.filter(|line| !line.starts_with("cost:")).map(str::to_owned));
    }
    if let Some(start) = start {
        // The formulas hold for any parameters.
        let parameters = layout.parameters.iter().map(|parameter| (parameter.to_string(), 1.0)).collect();
        let request = Request { start: vec![("phi".into(), *start)], parameters };
        let sections = conditions(layout, Some(&closed.join(", ")), &request).unwrap_or_default();
        let statements = sections.iter().flat_map(|section| &section.statements);
        let formulas = statements.filter(|it| it.0.iter().any(|piece| matches!(piece, Piece::Equation(_))));
        lines.extend(formulas.map(ToString::to_string));
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_contact_set_is_derived() {
        for Set { layout, title, closed, .. } in SETS {
            assert!(equations(layout).phases.iter().any(|phase| phase.closed == closed), "{title}");
        }
    }

    /// φ̇², φ̈, N and where it vanishes, as functions of the angle, beside the equations of motion.
    #[test]
    fn what_leads_from_rest_has_its_closed_forms() {
        for set in SETS.iter().filter(|set| set.start.is_some()) {
            let lines = derive_lines(set);
            for begin in ["φ̇² = ", "φ̈ = ", "N("] {
                assert!(lines.iter().any(|line| line.starts_with(begin)), "{}: {lines:?}", set.title);
            }
            assert!(lines.iter().any(|line| line.contains("vanishes where 0 = ")), "{}", set.title);
        }
    }
}
