//! The equations as derived from the declarations, beside those of the paper.

use crate::systems::{FallingPair, ZigzagPublished};
use liftoff::model::Layout;
use liftoff::prelude::BarSystem;
use liftoff_studio::equations;
use liftoff_studio::html::escaped;

/// A contact set with the paper's equations for it; those of the paper are for one bar of mass 1 in Fig. 1a.
struct Set {
    layout: &'static Layout,
    title: &'static str,
    closed: &'static [&'static str],
    paper: &'static str,
}

const SETS: [Set; 4] = [
    Set {
        layout: FallingPair::LAYOUT,
        title: "Fig. 1a, both corners touch",
        closed: &["P, Q"],
        paper: "(3.1)  T = (l²/8) (4/3 + 1/cos⁴ φ − 2/cos φ) φ̇²   (one bar, m = 1)\n\
                (3.2)  φ̇² = (4 g/l) (1 − cos φ) tan φ / (4/3 + 1/cos⁴ φ − 2/cos φ)\n\
                (3.4)  N = (g − ÿ)/cos φ, ÿ of a bar's centre:\n       ÿ = (l/2) [(sin φ + 2 sin φ/cos³ φ) φ̇² + (1/cos² φ − cos φ) φ̈]",
    },
    Set {
        layout: FallingPair::LAYOUT,
        title: "Fig. 1a, free",
        closed: &[],
        paper: "(3.5)  T = ⅓ l² φ̇² + ẏ² − ẏ l φ̇ cos φ   (m = 1)\n\
                (3.6)  ⅔ l² φ̈ − ÿ l cos φ = −g l cos φ\n       2 ÿ − l φ̈ cos φ + l φ̇² sin φ = 2 g\n\
                (3.8)  φ̇² (⅔ − ½ cos² φ) = const",
    },
    Set {
        layout: ZigzagPublished::LAYOUT,
        title: "Fig. 1b as published, on A, C, E",
        closed: &["A, C, E"],
        paper: "(3.11) T = (m₁ + m₂) (⅓ + 2 λ sin² φ) l² φ̇²\n\
                (3.13) φ̇² = (g/l) (sin φ(0) − sin φ) / (⅓ + 2 λ sin² φ)\n\
                (3.16) N = 2 (m₁ + m₂) g [1 − (l/2g) (φ̇² sin φ − φ̈ cos φ)]",
    },
    Set {
        layout: ZigzagPublished::LAYOUT,
        title: "Fig. 1b as published, free",
        closed: &[],
        paper: "(3.20) T = (m₁ + m₂) [ẏ² − ẏ φ̇ l cos φ + (⅓ + 2 λ sin² φ) l² φ̇²]   (y downward)\n\
                (3.21) −ÿ cos φ + 2 l φ̈ (⅓ + 2 λ sin² φ) + 4 λ l φ̇² sin φ cos φ = −g cos φ\n       ÿ = g + (l/2) (φ̈ cos φ − φ̇² sin φ)\n       φ̇² [1/12 + (¼ + 2 λ) sin² φ] = h = const\n\
                (3.22) ÿ = g − ½ h l (⅓ + 2 λ) sin φ / [1/12 + (¼ + 2 λ) sin² φ]²",
    },
];

/// Each contact set: what was derived, then the paper.
pub(super) fn html() -> String {
    let sets: String = SETS.iter().map(set).collect();
    format!(
        "<p>Derived by the compiler from the declarations alone, for each contact set; below them the paper's, of which the \
         tests check that both agree at random states. T is of all bars here; the drop <i>y</i> of Fig. 1a is downward, that of C in \
         Fig. 1b upward.</p>\n<div class=equations>\n{sets}</div>\n"
    )
}

fn set(Set { layout, title, closed, paper }: &Set) -> String {
    let derived = equations(layout);
    let phase = derived.phases.iter().find(|phase| phase.closed == *closed);
    let text = phase.map(ToString::to_string).unwrap_or_default();
    let lines = text.lines().skip(1).filter(|line| !line.trim_start().starts_with("cost:"));
    let lines: String = lines.map(|line| format!("{}\n", line.trim_start())).collect();
    format!(
        "<h3>{title}</h3>\n<pre>{}</pre>\n<details open><summary>The paper</summary><pre>{}</pre></details>\n",
        escaped(&lines),
        escaped(paper)
    )
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
}
