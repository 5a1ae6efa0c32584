//! Figs. 7 to 10 of the paper.

use super::{REACTION, Runs};
use crate::plot::{Axis, Chart, Curve, Ink, Mark, Pattern, Sheet, Stroke};
use crate::report::ReportError;
use crate::report::figure::{Figure, superposed};
use crate::report::reading::{curve, time_of};
use std::f64::consts::FRAC_PI_2;

const BARS: [&str; 5] = ["A", "B", "C", "D", "E"];

/// Fig. 7: the total reaction of the runs without outer bars and of those shown.
pub fn reactions(runs: &[Runs]) -> Result<Figure, ReportError> {
    let chosen = runs.iter().filter(|run| run.ratio.1 == 0.0 || run.is_shown());
    let panels: Result<Vec<_>, _> = chosen.map(Runs::reaction).collect();
    let description = "Total reaction of the floor against the angle, for two mass ratios";
    Ok(Figure {
        anchor: "fig7",
        title: "Fig. 7",
        caption: "Total reaction of the floor against the angle, for λ = 0 and λ = 0.5, with the supports held past \
                  its zero. At λ = 0 it touches zero and comes back."
            .into(),
        svg: Sheet { description: description.into(), size: (560, 560) }.charts(&panels?)?,
    })
}

impl Runs {
    fn reaction(&self) -> Result<Chart, ReportError> {
        let points = curve(&*self.held, ["phi", REACTION], self.held.interval(), 400)?;
        let mark = |phi: f64| Mark { at: [phi, 0.0], label: format!("φ₁ = {phi:.6}"), offset: (-10, -16) };
        let name = format!("λ = {}", self.ratio.1);
        Ok(Chart {
            x: Axis::linear("φ, rad", [FRAC_PI_2, 0.0]).with_ticks([1.5, 1.25, 1.0, 0.75, 0.5, 0.25, 0.0]),
            y: Axis::holding("N / 2(m₁ + m₂)g", points.iter().map(|p| p[1])),
            curves: vec![Curve::solid(&name, Ink::Blue, points)],
            marks: self.lift_off().map(mark).into_iter().collect(),
        })
    }

    /// Figs. 8 to 10, of the flight if there is one.
    pub fn figures(&self) -> Result<Vec<Figure>, ReportError> {
        let Some(flight) = self.interval() else { return Ok(Vec::new()) };
        Ok(vec![
            self.rates(
                flight,
                ("fig8", "Fig. 8", "Angular velocity and angular acceleration in flight, λ = 0.5."),
                [("dφ/dt, √(g/l)", "phi'"), ("d²φ/dt², g/l", "phi''")],
            )?,
            self.rates(
                flight,
                ("fig9", "Fig. 9", "Velocity and acceleration of C in flight, downward, λ = 0.5."),
                [("velocity of C, √(gl)", "-vy(C)"), ("acceleration of C, g", "-ay(C)")],
            )?,
            self.motion(flight)?,
        ])
    }

    fn rates(
        &self,
        flight: [f64; 2],
        (anchor, title, caption): (&'static str, &'static str, &str),
        outputs: [(&str, &str); 2],
    ) -> Result<Figure, ReportError> {
        let mut panels = Vec::new();
        for (name, output) in outputs {
            let points = curve(&*self.flight, ["phi", output], flight, 300)?;
            let (first, last) = (points[0], points[points.len() - 1]);
            panels.push(Chart {
                x: Axis::linear("φ, rad", [first[0], last[0]]).with_ticks([0.4, 0.3, 0.2, 0.1, 0.0]),
                y: Axis::holding(name, points.iter().map(|p| p[1])),
                curves: vec![Curve::solid("", Ink::Blue, points)],
                marks: vec![Mark { at: last, label: format!("{:.4} at φ₂", last[1]), offset: (-12, 0) }],
            });
        }
        let sheet = Sheet { description: caption.into(), size: (560, 480) };
        Ok(Figure { anchor, title, caption: caption.into(), svg: sheet.charts(&panels)? })
    }

    fn motion(&self, flight: [f64; 2]) -> Result<Figure, ReportError> {
        const POSITIONS: u32 = 6;
        let [Some(from), Some(to)] = [self.lift_off(), self.touch_down()] else {
            return Err(ReportError::NoFlight);
        };
        let angle = |i| from + (to - from) * f64::from(i) / f64::from(POSITIONS);
        let times: Result<Vec<f64>, _> =
            (0..=POSITIONS).map(|i| time_of(&*self.flight, "phi", angle(i), flight)).collect();
        let floor = Stroke { points: vec![[-2.2, 0.0], [2.2, 0.0]], ink: Ink::Grey, opacity: 1.0, width: 4 };
        let mut strokes = vec![floor];
        strokes.extend(superposed(&*self.flight, &BARS, &times?, Ink::Vermilion)?);
        let pattern = Pattern {
            x: Axis::linear("x / l", [-2.2, 2.2]),
            y: Axis::linear("y / l", [-0.1, 0.6]),
            strokes,
            dots: Vec::new(),
            writings: Vec::new(),
        };
        let sheet = Sheet { description: "Superposed positions of the four bars in flight".into(), size: (860, 240) };
        Ok(Figure {
            anchor: "fig10",
            title: "Fig. 10",
            caption: "Superposed positions in flight, λ = 0.5, at equal steps of the angle from lift-off until B and D \
                      reach the floor."
                .into(),
            svg: sheet.pattern(&pattern)?,
        })
    }
}
