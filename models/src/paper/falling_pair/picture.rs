//! The project in one picture: the pair on its corners and in free fall, and the reaction through
//! its zero.

use super::FallingPairRuns;
use super::positions::BARS;
use crate::paper::ReportError;
use crate::paper::figure::decimals;
use crate::paper::reading::{evaluate_output, places, time_of};
use liftoff_studio::picture::curve;
use liftoff_studio::plot::{Axis, Chart, Colour, Curve, Figure, Label, Mark, Stroke, Superposition};

const DEGREES: &str = "phi * 180 / pi";
const SHARE: &str = "N(P) / (m * g)";

impl FallingPairRuns {
    /// The picture as SVG text; none without lift-off.
    pub fn picture(&self) -> Result<Option<String>, ReportError> {
        let Some(open) = self.opening() else {
            return Ok(None);
        };
        let sheet = Figure {
            description: "Two bars fall through a gap: positions on the corners and in free fall, and the \
                          reaction of a corner through its zero"
                .into(),
            size: (860, 420),
        };
        Ok(Some(sheet.beside(390, &self.fallen(open)?, &self.through_zero(open)?)))
    }

    /// Superposed positions, that at lift-off in black.
    fn fallen(&self, open: f64) -> Result<Superposition, ReportError> {
        let mut superposition = self.positions([open, self.fall.interval()[1]])?;
        let bars = places(&self.fall, &BARS, open)?;
        let text = format!("lift-off at φ₁ = {}°", decimals(evaluate_output(&self.fall, DEGREES, open)?, 2));
        superposition.labels = vec![Label { at: [0.0, bars[2][1]], text, offset: (0, -8) }];
        superposition.strokes.push(Stroke::solid(bars, Colour::Black, 1.0, 3));
        Ok(superposition)
    }

    /// The reaction until lift-off and then none, against that of corners which hold.
    fn through_zero(&self, open: f64) -> Result<Chart, ReportError> {
        let held = &self.held;
        let [start, end] = held.interval();
        let phi = evaluate_output(&self.fall, DEGREES, open)?;
        let zero = time_of(held, DEGREES, phi, [start, end])?;
        let last = evaluate_output(held, DEGREES, end)?;
        let pushing = curve(held, [DEGREES, SHARE], [start, zero])?;
        let pulling = curve(held, [DEGREES, SHARE], [zero, end])?;
        let label = format!("lift-off: N = 0 at φ₁ = {}°", decimals(phi, 2));
        Ok(Chart {
            x: Axis::linear("angle of the bars φ, degrees", [0.0, last])
                .with_ticks([0.0, 15.0, 30.0, 45.0, 60.0]),
            y: Axis::holding("reaction of a corner N / mg", pushing.iter().chain(&pulling).map(|p| p[1])),
            curves: vec![
                Curve::solid("a corner pushes", Colour::Blue, pushing),
                Curve::solid("it would have to pull", Colour::Blue, pulling).dashed(),
                Curve::solid("", Colour::Vermilion, vec![[phi, 0.0], [last, 0.0]]),
            ],
            marks: vec![Mark { at: [phi, 0.0], label }],
        })
    }
}
