//! Figs. 7 to 10 of the paper.

use super::{PublishedRuns, REACTION};
use crate::paper::ReportError;
use crate::paper::figure::{CaptionedFigure, against_phi, decimals, superposed};
use crate::paper::printed::GRAVITY;
use crate::paper::reading::{equal_steps, evaluate_output, range};
use liftoff_studio::picture::curve;
use liftoff_studio::plot::{Axis, Chart, Colour, Curve, Figure, Mark, Stroke, Superposition};
use std::f64::consts::FRAC_PI_2;

const BARS: [&str; 5] = ["A", "B", "C", "D", "E"];

/// Fig. 7: the total reaction without outer bars, and with the masses that the other figures show.
pub fn reactions(runs: &[PublishedRuns]) -> Result<CaptionedFigure, ReportError> {
    let chosen = runs.iter().filter(|run| run.ratio.1 == 0.0 || run.is_shown());
    let panels: Result<Vec<_>, _> = chosen.map(PublishedRuns::reaction).collect();
    let description = "Total reaction of the floor against the angle, for two mass ratios";
    Ok(CaptionedFigure {
        anchor: "fig7",
        title: "Fig. 7",
        caption: "Total reaction of the floor against the angle, for λ = 0 and λ = 0.5, with the supports held past \
                  its zero, in weights of all bars. At λ = 0 it touches zero and comes back."
            .into(),
        svg: Figure { description: description.into(), size: (560, 560) }.charts(&panels?),
    })
}

impl PublishedRuns {
    fn reaction(&self) -> Result<Chart, ReportError> {
        let points = curve(&self.held, ["phi", REACTION], self.held.interval())?;
        let mark = |phi: f64| Mark { at: [phi, 0.0], label: format!("φ₁ = {phi:.6}") };
        let name = format!("λ = {}", self.ratio.1);
        Ok(Chart {
            x: Axis::linear("φ, rad", [FRAC_PI_2, 0.0]).with_ticks([1.5, 1.25, 1.0, 0.75, 0.5, 0.25, 0.0]),
            y: Axis::holding("N / (2 (m₁ + m₂) g)", points.iter().map(|p| p[1])),
            curves: vec![Curve::solid(&name, Colour::Blue, points)],
            marks: self.lift_off().map(mark).into_iter().collect(),
        })
    }

    /// Figs. 8 to 10, of the flight if there is one.
    pub fn figures(&self) -> Result<Vec<CaptionedFigure>, ReportError> {
        match self.interval() {
            Some(flight) => Ok(vec![self.angular(flight)?, self.joint(flight)?, self.motion(flight)?]),
            None => Ok(Vec::new()),
        }
    }

    fn angular(&self, flight: [f64; 2]) -> Result<CaptionedFigure, ReportError> {
        let rate = format!("-phi' * sqrt({GRAVITY})");
        let acceleration = format!("phi'' * {GRAVITY}");
        let level = self.level.interval()[1];
        Ok(CaptionedFigure {
            anchor: "fig8",
            title: "Fig. 8",
            caption: format!(
                "Modulus of the angular velocity, and angular acceleration in flight, λ = {}, <i>l</i> = 1 m, \
                 <i>g</i> = {GRAVITY} m/s²: {} rad/s as all bars lie level (printed, ten times it: 63.798), least angular \
                 acceleration {} rad/s² (printed: −50.618).",
                self.ratio.1,
                decimals(evaluate_output(&self.level, &rate, level)?, 4),
                decimals(range(&self.flight, &acceleration, flight)?[0], 3),
            ),
            svg: self.in_flight(flight, [("|φ̇|, rad/s", &rate), ("φ̈, rad/s²", &acceleration)])?,
        })
    }

    fn joint(&self, flight: [f64; 2]) -> Result<CaptionedFigure, ReportError> {
        let velocity = format!("-vy(C) * sqrt({GRAVITY})");
        let acceleration = format!("-ay(C) * {GRAVITY}");
        Ok(CaptionedFigure {
            anchor: "fig9",
            title: "Fig. 9",
            caption: format!(
                "Velocity and acceleration of C in flight, downward, λ = {}, <i>l</i> = 1 m, \
                 <i>g</i> = {GRAVITY} m/s²: {} m/s² as B and D reach the floor (printed: 20.321).",
                self.ratio.1,
                decimals(evaluate_output(&self.flight, &acceleration, flight[1])?, 3),
            ),
            svg: self.in_flight(flight, [("v of C, m/s", &velocity), ("a of C, m/s²", &acceleration)])?,
        })
    }

    fn in_flight(&self, flight: [f64; 2], outputs: [(&str, &str); 2]) -> Result<String, ReportError> {
        against_phi(&self.flight, flight, outputs, &[0.4, 0.3, 0.2, 0.1, 0.0], ["φ₁", "φ₂"])
    }

    fn motion(&self, flight: [f64; 2]) -> Result<CaptionedFigure, ReportError> {
        let times = equal_steps(&self.flight, "phi", flight, 6)?;
        let mut strokes = vec![Stroke::solid(vec![[-2.2, 0.0], [2.2, 0.0]], Colour::Grey, 1.0, 4)];
        strokes.extend(superposed(&self.flight, &BARS, &times, Colour::Vermilion)?);
        let superposition = Superposition {
            x: Axis::linear("x / l", [-2.2, 2.2]),
            y: Axis::linear("y / l", [-0.1, 0.6]).with_ticks([0.0, 0.25, 0.5]),
            strokes,
            dots: Vec::new(),
            labels: Vec::new(),
            legend: Vec::new(),
        };
        let sheet = Figure {
            description: "Superposed positions of the four bars in flight, and the height of C".into(),
            size: (860, 240),
        };
        Ok(CaptionedFigure {
            anchor: "fig10",
            title: "Fig. 10",
            caption: format!(
                "Left: superposed positions in flight, λ = {}, at equal steps of the angle from lift-off until B and D reach \
                 the floor. Right: the rise of C, and of A and E with it: {} <i>l</i> as all bars lie level (printed: 0.03 <i>l</i>), \
                 {} <i>l</i> at most (printed: 0.033 <i>l</i>).",
                self.ratio.1,
                decimals(evaluate_output(&self.flight, "y(C)", self.level.interval()[1])?, 4),
                decimals(range(&self.flight, "y(C)", flight)?[1], 4),
            ),
            svg: sheet.beside(560, &superposition, &self.rise(flight)?),
        })
    }

    fn rise(&self, flight: [f64; 2]) -> Result<Chart, ReportError> {
        let points = curve(&self.flight, ["phi", "y(C)"], flight)?;
        let [level, touch] = [self.level.interval()[1], flight[1]];
        let mark = |t: f64| -> Result<Mark, ReportError> {
            let [phi, rise] =
                [evaluate_output(&self.flight, "phi", t)?, evaluate_output(&self.flight, "y(C)", t)?];
            Ok(Mark { at: [phi, rise], label: format!("{} l", decimals(rise, 4)) })
        };
        Ok(Chart {
            x: Axis::linear("φ, rad", [points[0][0], points[points.len() - 1][0]])
                .with_ticks([0.4, 0.2, 0.0]),
            y: Axis::holding("rise of C / l", points.iter().map(|p| p[1])),
            curves: vec![Curve::solid("", Colour::Vermilion, points)],
            marks: vec![mark(level)?, mark(touch)?],
        })
    }
}
