//! The symmetric motion of Fig. 1b is unstable: near the upright a difference between left and
//! right grows faster than the fall. With the feet on the floor, linearised at φ = π/2,
//!
//! ```text
//! σₐ/σₛ = √[(1/3 + 2λ)/(1/12 + λ − λ²)]
//! ```
//!
//! for the rates of growth of the antisymmetric and the symmetric departure.

use super::Ratio;
use crate::models;
use crate::paper::ReportError;
use crate::paper::figure::CaptionedFigure;
use crate::paper::published::normalised;
use crate::paper::reading::events_of;
use liftoff::prelude::*;
use liftoff_studio::RunSpec;
use liftoff_studio::picture::curve;
use liftoff_studio::plot::{Axis, Chart, Colour, Curve, Figure, Mark};

const MODEL: &str = "zigzag-full";
/// Angles of the bars on the left and on the right at the start.
const START: [f64; 2] = [1.5, 1.4993];

/// σₐ/σₛ at this λ.
pub fn growth(ratio: f64) -> f64 {
    ((1.0 / 3.0 + 2.0 * ratio) / (1.0 / 12.0 + ratio - ratio * ratio)).sqrt()
}

/// The whole chain with a start that is not quite symmetric, λ = ½.
fn run(tolerance: f64) -> Result<Trajectory, ReportError> {
    let [left, right] = START;
    let start = [("phi_ab", left), ("phi_bc", left), ("phi_cd", right), ("phi_de", right)];
    let spec = normalised(RunSpec::default().start(&start).tolerance(tolerance), 0.5);
    Ok(models().find(MODEL)?.run(&spec)?)
}

/// How the difference between left and right grows until the first support opens.
pub fn figure(tolerance: f64, ratios: &[Ratio]) -> Result<Option<CaptionedFigure>, ReportError> {
    let run = run(tolerance)?;
    let Some(open) = events_of(&run, EventKind::Open).next() else { return Ok(None) };
    let until = [0.0, open.t];
    let [left, right] = ["phi_bc", "phi_cd"].map(|angle| curve(&run, ["t", angle], until));
    let difference = curve(&run, ["t", "phi_bc - phi_cd"], until)?;
    let [(_, last), first] = [(open.t, difference[difference.len() - 1][1]), (0.0, difference[0][1])];
    let (left, right) = (left?, right?);
    let ends = [left[left.len() - 1][1], right[right.len() - 1][1]];
    let mark = |value: f64| Mark { at: [open.t, value], label: format!("{value:.5}") };
    let angles = Chart {
        x: Axis::linear("time, √(l/g)", until),
        y: Axis::holding("angle of the inner bars, rad", left.iter().chain(&right).map(|p| p[1])),
        curves: vec![
            Curve::solid("BC (left)", Colour::Blue, left),
            Curve::solid("CD (right)", Colour::Vermilion, right),
        ],
        marks: vec![mark(ends[0]), mark(ends[1])],
    };
    let apart = Chart {
        x: Axis::linear("time, √(l/g)", until),
        y: Axis::decades("left − right, rad", difference.iter().map(|p| p[1])),
        curves: vec![Curve::solid("", Colour::Green, difference)],
        marks: Vec::new(),
    };
    let rates: Vec<String> =
        ratios.iter().map(|(name, ratio)| format!("{:.2} (λ = {name})", growth(*ratio))).collect();
    let sheet = Figure { description: "A small asymmetry of Fig. 1b grows".into(), size: (860, 620) };
    Ok(Some(CaptionedFigure {
        anchor: "asymmetry",
        title: "Fig. 1b, not quite symmetric",
        caption: format!(
            "The whole chain, λ = ½, from rest with {} rad on the left and {} on the right: {:.1} mrad of difference become \
             {:.2} rad when the first support ({}) opens, at {:.5} and {:.5}. Near the upright a difference grows \
             σₐ/σₛ = √[(⅓ + 2λ)/(1/12 + λ − λ²)] times as fast as the fall itself: {}.",
            START[0],
            START[1],
            1e3 * first.1,
            last,
            open.supports.join(", "),
            ends[0],
            ends[1],
            rates.join(", "),
        ),
        svg: sheet.charts(&[angles, apart]),
    }))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// As the book has it: from 0.7 mrad of difference the first opening is at angles 0.23 rad
    /// apart.
    #[test]
    fn the_symmetric_motion_is_not_what_a_small_difference_leads_to() {
        let run = run(1e-13).expect("a motion");
        let open = events_of(&run, EventKind::Open).next().expect("an opening");
        for (angle, expected) in [("phi_bc", 0.58567), ("phi_cd", 0.35193)] {
            let value = run.function(angle).expect("an output")(open.t);
            assert!((value - expected).abs() < 5e-6, "{angle} {value}");
        }
    }

    /// From rest a small departure grows as cosh σt: the symmetric one at 1e-4 of the upright, the
    /// antisymmetric one at 1e-6.
    #[test]
    fn differences_grow_as_linearised() {
        for ratio in [0.25, 0.5, 0.75] {
            let upright = std::f64::consts::FRAC_PI_2;
            let grown = |offsets: [f64; 2], output: &str| {
                let angles = offsets.map(|offset| upright - offset);
                let start = [
                    ("phi_ab", angles[0]),
                    ("phi_bc", angles[0]),
                    ("phi_cd", angles[1]),
                    ("phi_de", angles[1]),
                ];
                let spec = RunSpec::default().start(&start).until("t = 2").tolerance(1e-13);
                let run =
                    models().find(MODEL).expect("a model").run(&normalised(spec, ratio)).expect("a motion");
                let value = run.function(output).expect("an output");
                (value(2.0) / value(0.0)).acosh() / 2.0
            };
            let symmetric = grown([1e-4, 1e-4], "pi/2 - phi_bc");
            let antisymmetric = grown([1e-4 + 1e-6, 1e-4 - 1e-6], "phi_cd - phi_bc");
            let error = antisymmetric / symmetric - growth(ratio);
            assert!(error.abs() < 1e-4, "{ratio}: {error:e}");
        }
    }
}
