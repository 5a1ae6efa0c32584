//! Figs. 2, 4 and 5 of the paper.

use super::FallingPairRuns;
use crate::paper::ReportError;
use crate::paper::figure::{CaptionedFigure, against_phi, decimals};
use crate::paper::reading::evaluate_output;
use liftoff_studio::picture::curve;
use liftoff_studio::plot::{Axis, Chart, Colour, Curve, Figure, Mark};
use std::f64::consts::FRAC_PI_3;

impl FallingPairRuns {
    /// Figs. 2 to 6; those of the flight only if there is one.
    pub fn figures(&self) -> Result<Vec<CaptionedFigure>, ReportError> {
        let mut figures = vec![self.reaction()?];
        if let Some(open) = self.opening() {
            let flight = [open, self.fall.interval()[1]];
            figures.extend([
                self.lift_off(open)?,
                self.angular(flight)?,
                self.hinge(flight)?,
                self.motion(flight)?,
            ]);
        }
        Ok(figures)
    }

    fn reaction(&self) -> Result<CaptionedFigure, ReportError> {
        let points = curve(&self.held, ["phi", "N(P)"], self.held.interval())?;
        let phi = self.opening().map(|t| evaluate_output(&self.fall, "phi", t)).transpose()?;
        let mark = |phi: f64| Mark { at: [phi, 0.0], label: format!("φ₁ = {phi:.6}") };
        let chart = Chart {
            x: Axis::linear("φ, rad", [0.0, FRAC_PI_3]).with_ticks([0.0, 0.25, 0.5, 0.75, 1.0]),
            y: Axis::holding("reaction of one corner, newtons", points.iter().map(|p| p[1])),
            curves: vec![Curve::solid("", Colour::Blue, points)],
            marks: phi.map(mark).into_iter().collect(),
        };
        let description = "Reaction of one corner against the angle of the bars, past its zero";
        Ok(CaptionedFigure {
            anchor: "fig2",
            title: "Fig. 2",
            caption: format!(
                "Reaction of one corner against the angle, the corners held past its zero. Figs. 2, 4 and 5: \
                 <i>m</i> = 1 kg, <i>l</i> = {} m, <i>g</i> = {} m/s².",
                self.l, self.g
            ),
            svg: Figure { description: description.into(), size: (560, 480) }.charts(&[chart]),
        })
    }

    fn angular(&self, flight: [f64; 2]) -> Result<CaptionedFigure, ReportError> {
        let outputs = [("φ̇, rad/s", "phi'"), ("φ̈, rad/s²", "phi''")];
        Ok(CaptionedFigure {
            anchor: "fig4",
            title: "Fig. 4",
            caption: format!(
                "Angular velocity and angular acceleration of a bar in free fall: {} rad/s and {} rad/s² at φ₁.",
                decimals(evaluate_output(&self.fall, "phi'", flight[0])?, 4),
                decimals(evaluate_output(&self.fall, "phi''", flight[0])?, 4),
            ),
            svg: self.falling(flight, outputs)?,
        })
    }

    fn hinge(&self, flight: [f64; 2]) -> Result<CaptionedFigure, ReportError> {
        let outputs = [("velocity of D, m/s", "-vy(D)"), ("acceleration of D, m/s²", "-ay(D)")];
        Ok(CaptionedFigure {
            anchor: "fig5",
            title: "Fig. 5",
            caption: format!(
                "Velocity and acceleration of the hinge D in free fall, downward: {} m/s and {} m/s² at φ₁.",
                decimals(evaluate_output(&self.fall, "-vy(D)", flight[0])?, 4),
                decimals(evaluate_output(&self.fall, "-ay(D)", flight[0])?, 4),
            ),
            svg: self.falling(flight, outputs)?,
        })
    }

    fn falling(&self, flight: [f64; 2], outputs: [(&str, &str); 2]) -> Result<String, ReportError> {
        let ticks = [0.9, 1.0, 1.1, 1.2, 1.3, 1.4, 1.5];
        against_phi(&self.fall, flight, outputs, &ticks, ["φ₁", "π/2"])
    }
}
