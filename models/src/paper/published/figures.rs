//! Figs. 7 to 10 of the paper.

use super::{REACTION, Runs};
use crate::paper::ReportError;
use crate::paper::figure::{CaptionedFigure, against_phi, decimals, superposed};
use crate::paper::reading::{at, equal_steps, range};
use liftoff_studio::picture::curve;
use liftoff_studio::plot::{Axis, Chart, Colour, Curve, Figure, Mark, Stroke, Superposition};
use std::f64::consts::FRAC_PI_2;

const BARS: [&str; 5] = ["A", "B", "C", "D", "E"];

/// Fig. 7: the total reaction without outer bars, and with the masses that the other figures show.
pub fn reactions(runs: &[Runs]) -> Result<CaptionedFigure, ReportError> {
    let chosen = runs.iter().filter(|run| run.ratio.1 == 0.0 || run.is_shown());
    let panels: Result<Vec<_>, _> = chosen.map(Runs::reaction).collect();
    let description = "Total reaction of the floor against the angle, for two mass ratios";
    Ok(CaptionedFigure {
        anchor: "fig7",
        title: "Fig. 7",
        caption: "Total reaction of the floor against the angle, for λ = 0 and λ = 0.5, with the supports held past \
                  its zero. At λ = 0 it touches zero and comes back."
            .into(),
        svg: Figure { description: description.into(), size: (560, 560) }.charts(&panels?),
    })
}

impl Runs {
    fn reaction(&self) -> Result<Chart, ReportError> {
        let points = curve(&self.held, ["phi", REACTION], self.held.interval())?;
        let offset = if self.interval().is_some() { (10, -14) } else { (0, -30) };
        let mark = |phi: f64| Mark { at: [phi, 0.0], label: format!("φ₁ = {phi:.6}"), offset };
        let name = format!("λ = {}", self.ratio.1);
        Ok(Chart {
            x: Axis::linear("φ, rad", [FRAC_PI_2, 0.0]).with_ticks([1.5, 1.25, 1.0, 0.75, 0.5, 0.25, 0.0]),
            y: Axis::holding("N / 2(m₁ + m₂)g", points.iter().map(|p| p[1])),
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
        let level = self.level.interval()[1];
        Ok(CaptionedFigure {
            anchor: "fig8",
            title: "Fig. 8",
            caption: format!(
                "Angular velocity and angular acceleration in flight, λ = {}: {} √(<i>g/l</i>) as all bars lie level, \
                 least angular acceleration {} <i>g/l</i>.",
                self.ratio.1,
                decimals(at(&self.level, "phi'", level)?, 4),
                decimals(range(&self.flight, "phi''", flight)?[0], 4),
            ),
            svg: self.in_flight(flight, [("dφ/dt, √(g/l)", "phi'"), ("d²φ/dt², g/l", "phi''")])?,
        })
    }

    fn joint(&self, flight: [f64; 2]) -> Result<CaptionedFigure, ReportError> {
        Ok(CaptionedFigure {
            anchor: "fig9",
            title: "Fig. 9",
            caption: format!(
                "Velocity and acceleration of C in flight, downward, λ = {}: {} √(<i>gl</i>) and {} <i>g</i> as B and D \
                 reach the floor.",
                self.ratio.1,
                decimals(at(&self.flight, "-vy(C)", flight[1])?, 4),
                decimals(at(&self.flight, "-ay(C)", flight[1])?, 4),
            ),
            svg: self.in_flight(
                flight,
                [("velocity of C, √(gl)", "-vy(C)"), ("acceleration of C, g", "-ay(C)")],
            )?,
        })
    }

    fn in_flight(&self, flight: [f64; 2], outputs: [(&str, &str); 2]) -> Result<String, ReportError> {
        let ticks = [0.4, 0.3, 0.2, 0.1, 0.0];
        against_phi(&self.flight, flight, outputs, &ticks, |points| points.last().copied())
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
            description: "Superposed positions of the four bars in flight".into(),
            size: (860, 250),
        };
        Ok(CaptionedFigure {
            anchor: "fig10",
            title: "Fig. 10",
            caption: format!(
                "Superposed positions in flight, λ = {}, at equal steps of the angle from lift-off until B and D reach \
                 the floor.",
                self.ratio.1
            ),
            svg: sheet.superposition(&superposition),
        })
    }
}
