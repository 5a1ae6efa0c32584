//! Figs. 3 and 6 of the paper: positions.

use super::FallingPairRuns;
use crate::paper::ReportError;
use crate::paper::figure::{CaptionedFigure, decimals, path, superposed};
use crate::paper::reading::{equal_steps, evaluate_output, places, range};
use crate::paper::scheme::arc;
use liftoff_studio::plot::{Axis, Colour, Figure, Label, LegendLine, Stroke, Superposition};

pub(in crate::paper) const BARS: [&str; 3] = ["A", "D", "B"];

impl FallingPairRuns {
    /// The bars as the corners lose them, with the instantaneous centre of bar AD.
    pub(super) fn lift_off(&self, open: f64) -> Result<CaptionedFigure, ReportError> {
        let bars = places(&self.fall, &BARS, open)?;
        let (end, hinge) = (bars[0], bars[1]);
        let centre = self.centre(open)?;
        let line = |points, colour, width| Stroke::solid(points, colour, 1.0, width);
        let mut strokes = ground(self.l);
        strokes.push(line(vec![[-self.l / 2.0, 0.0], centre, hinge], Colour::Green, 1));
        strokes.push(line(vec![hinge, [0.0, 0.0]], Colour::Green, 1));
        strokes.push(line(bars.clone(), Colour::Blue, 3));
        let phi = evaluate_output(&self.fall, "phi", open)?;
        let level = [hinge[0] + 0.5 * self.l, hinge[1]];
        strokes.push(line(vec![hinge, level], Colour::Black, 1));
        strokes.push(arc(hinge, [0.0, phi], 0.25 * self.l));
        let angle = phi.to_degrees();
        let drop = decimals(-hinge[1], 4);
        let write = |at, text: &str, offset| Label { at, text: text.into(), offset };
        let superposition = Superposition {
            x: Axis::linear("x / l", [centre[0] - 0.12, 0.95]),
            y: Axis::linear("y / l", [centre[1].min(hinge[1]) - 0.2, end[1] + 0.25]),
            strokes,
            labels: vec![
                write(end, "A", (-8, -8)),
                write(hinge, "D", (0, 16)),
                write(bars[2], "B", (8, -8)),
                write(centre, "P₁", (0, 16)),
                write([0.0, hinge[1] / 2.0], &format!("{drop} l"), (6, -24)),
                write(hinge, &format!("φ₁ = {angle:.3}°"), (78, -14)),
            ],
            dots: vec![end, hinge, bars[2], centre],
            legend: Vec::new(),
        };
        let sheet = Figure { description: "The bars at lift-off".into(), size: (560, 400) };
        Ok(CaptionedFigure {
            anchor: "fig3",
            title: "Fig. 3",
            caption: format!(
                "The bars as they leave the corners: D has dropped by {drop} l, A and B are {} l above the corners. \
                 P₁ at ({}, {}) l is the instantaneous centre of velocity of the left bar: on the normal to the bar \
                 at its corner, level with D.",
                decimals(end[1], 4),
                decimals(centre[0], 4),
                decimals(centre[1], 4),
            ),
            svg: sheet.superposition(&superposition),
        })
    }

    /// The point of bar AD's plane at rest: v = ω k × r about it.
    fn centre(&self, t: f64) -> Result<[f64; 2], ReportError> {
        let value = |output| evaluate_output(&self.fall, output, t);
        let along = [value("x(D)")? - value("x(A)")?, value("y(D)")? - value("y(A)")?];
        let turn = [value("vx(D)")? - value("vx(A)")?, value("vy(D)")? - value("vy(A)")?];
        let omega = (along[0] * turn[1] - along[1] * turn[0]) / (along[0] * along[0] + along[1] * along[1]);
        Ok([value("x(A)")? - value("vy(A)")? / omega, value("y(A)")? + value("vx(A)")? / omega])
    }

    /// Superposed positions: in flight, ten equal steps of the angle, as in the paper.
    pub(super) fn positions(&self, [open, end]: [f64; 2]) -> Result<Superposition, ReportError> {
        let fall = &self.fall;
        let start = fall.interval()[0];
        let constrained = equal_steps(fall, "phi", [start, open], 6)?;
        let free = equal_steps(fall, "phi", [open, end], 10)?;
        let mut strokes = ground(self.l);
        strokes.extend(superposed(fall, &BARS, &constrained, Colour::Blue)?);
        strokes.extend(superposed(fall, &BARS, &free[1..], Colour::Vermilion)?);
        Ok(Superposition {
            x: Axis::linear("x / l", [-1.1, 1.1]),
            y: Axis::linear("y / l", [-2.2, 0.4]),
            strokes,
            dots: Vec::new(),
            labels: Vec::new(),
            legend: vec![
                LegendLine::solid("on the corners", Colour::Blue),
                LegendLine::solid("in free fall", Colour::Vermilion),
            ],
        })
    }

    /// The positions with the paths of the ends.
    pub(super) fn motion(&self, flight: [f64; 2]) -> Result<CaptionedFigure, ReportError> {
        let mut superposition = self.positions(flight)?;
        superposition.legend.push(LegendLine::solid("paths of A and B", Colour::Green));
        for point in ["A", "B"] {
            superposition.strokes.push(path(&self.fall, point, self.fall.interval(), Colour::Green)?);
        }
        self.measure(&mut superposition, flight[1])?;
        let [first, last] = flight.map(|t| evaluate_output(&self.fall, "phi", t));
        let step = ((last? - first?) / 10.0).to_degrees();
        let sheet =
            Figure { description: "Superposed positions of the falling pair".into(), size: (560, 690) };
        Ok(CaptionedFigure {
            anchor: "fig6",
            title: "Fig. 6",
            caption: format!(
                "Superposed positions: <span class=blue>on the corners</span>, then \
                 <span class=vermilion>in free fall</span> at steps of {step:.2}° until the bars meet; \
                 <span class=green>paths of A and B</span>."
            ),
            svg: sheet.superposition(&superposition),
        })
    }
}

impl FallingPairRuns {
    /// Points named, the travel of D and the height of the paths of A and B with their lengths.
    fn measure(&self, superposition: &mut Superposition, end: f64) -> Result<(), ReportError> {
        let [start, last] = [self.fall.interval()[0], end].map(|t| places(&self.fall, &BARS, t));
        let ([a, _, b], d) = (<[[f64; 2]; 3]>::try_from(start?).unwrap_or_default(), last?[1]);
        let [low, high] = range(&self.fall, "y(B)", self.fall.interval())?;
        let write = |at, text: String, offset| Label { at, text, offset };
        let upright = |x: f64, y: [f64; 2]| Stroke::solid(y.map(|y| [x, y]).into(), Colour::Black, 0.7, 1);
        superposition.strokes.extend([upright(-0.75, [0.0, d[1]]), upright(0.62, [low, high])]);
        superposition.labels.extend([
            write(a, "A".into(), (-6, -8)),
            write(b, "B".into(), (6, -8)),
            write(d, "D".into(), (10, 4)),
            write([-0.75, 0.5 * d[1]], format!("D: {} l", decimals(-d[1] / self.l, 3)), (-6, 0)),
            write([0.62, 0.5 * (low + high)], format!("B: {} l", decimals((high - low) / self.l, 3)), (6, 0)),
        ]);
        Ok(())
    }
}

/// The two sides of the gap.
pub(in crate::paper) fn ground(l: f64) -> Vec<Stroke> {
    let side = |sign: f64| {
        let corner = sign * 0.5 * l;
        Stroke::solid(vec![[sign * 1.1 * l, 0.0], [corner, 0.0], [corner, -0.35 * l]], Colour::Grey, 1.0, 4)
    };
    vec![side(-1.0), side(1.0)]
}
