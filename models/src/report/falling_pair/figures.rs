//! Figs. 2 to 6 of the paper.

use super::Runs;
use crate::plot::{Axis, Chart, Curve, Ink, Mark, Pattern, Sheet, Stroke, Writing};
use crate::report::ReportError;
use crate::report::figure::{Figure, path, superposed};
use crate::report::reading::{at, curve, places, time_of};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_3};

const BARS: [&str; 3] = ["A", "D", "B"];

impl Runs {
    /// Figs. 2 to 6; those of the flight only if there is one.
    pub fn figures(&self) -> Result<Vec<Figure>, ReportError> {
        let Some(open) = self.opening() else { return Ok(vec![self.reaction()?]) };
        let flight = [open, self.fall.interval()[1]];
        Ok(vec![
            self.reaction()?,
            self.lift_off(open)?,
            self.rates(
                flight,
                ("fig4", "Fig. 4", "Angular velocity and angular acceleration of a bar in free fall."),
                [("dφ/dt, rad/s", "phi'"), ("d²φ/dt², rad/s²", "phi''")],
            )?,
            self.rates(
                flight,
                ("fig5", "Fig. 5", "Velocity and acceleration of the hinge D in free fall, downward."),
                [("velocity of D, m/s", "y'"), ("acceleration of D, m/s²", "y''")],
            )?,
            self.motion(flight)?,
        ])
    }

    fn reaction(&self) -> Result<Figure, ReportError> {
        let points = curve(&*self.held, ["phi", "N(P)"], self.held.interval(), 400)?;
        let phi = self.opening().map(|t| at(&*self.fall, "phi", t)).transpose()?;
        let mark = |phi: f64| Mark { at: [phi, 0.0], label: format!("φ₁ = {phi:.6}"), offset: (10, -14) };
        let chart = Chart {
            x: Axis::linear("φ, rad", [0.0, FRAC_PI_3]).with_ticks([0.0, 0.25, 0.5, 0.75, 1.0]),
            y: Axis::holding("N at one corner, N", points.iter().map(|p| p[1])),
            curves: vec![Curve::solid("", Ink::Blue, points)],
            marks: phi.map(mark).into_iter().collect(),
        };
        let description = "Reaction of one corner against the angle of the bars, past its zero";
        Ok(Figure {
            anchor: "fig2",
            title: "Fig. 2",
            caption: "Reaction of one corner against the angle, with the corners held past its zero \
                      (<i>m</i> = 1 kg, <i>l</i> = 1 m, <i>g</i> = 9.81 m/s²)."
                .into(),
            svg: Sheet { description: description.into(), size: (560, 360) }.charts(&[chart])?,
        })
    }

    fn rates(
        &self,
        flight: [f64; 2],
        (anchor, title, caption): (&'static str, &'static str, &str),
        outputs: [(&str, &str); 2],
    ) -> Result<Figure, ReportError> {
        let phi = at(&*self.fall, "phi", flight[0])?;
        let mut panels = Vec::new();
        for (name, output) in outputs {
            let points = curve(&*self.fall, ["phi", output], flight, 300)?;
            let first = points[0];
            panels.push(Chart {
                x: Axis::linear("φ, rad", [phi, FRAC_PI_2]).with_ticks([0.9, 1.0, 1.1, 1.2, 1.3, 1.4, 1.5]),
                y: Axis::holding(name, points.iter().map(|p| p[1])),
                curves: vec![Curve::solid("", Ink::Blue, points)],
                marks: vec![Mark { at: first, label: format!("{:.4} at φ₁", first[1]), offset: (12, 0) }],
            });
        }
        let sheet = Sheet { description: caption.into(), size: (560, 480) };
        Ok(Figure { anchor, title, caption: caption.into(), svg: sheet.charts(&panels)? })
    }

    /// The bars as the corners lose them, with the instantaneous centre of bar AD.
    fn lift_off(&self, open: f64) -> Result<Figure, ReportError> {
        let fall = &*self.fall;
        let places = places(fall, &BARS, open)?;
        let centre = self.centre(open)?;
        let phi = at(fall, "phi", open)?.to_degrees();
        let drop = -places[1][1];
        let line = |points: Vec<[f64; 2]>, ink, width| Stroke { points, ink, opacity: 1.0, width };
        let corner = -self.l / 2.0;
        let mut strokes = ground(self.l);
        strokes.push(line(vec![[corner, 0.0], centre, places[1]], Ink::Green, 1));
        strokes.push(line(vec![places[1], [0.0, 0.0]], Ink::Green, 1));
        strokes.push(line(places.clone(), Ink::Blue, 3));
        let write = |at, text: &str, offset| Writing { at, text: text.into(), offset };
        let pattern = Pattern {
            x: Axis::linear("x / l", [-1.0, 1.0]),
            y: Axis::linear("y / l", [-0.8, centre[1].max(0.5) + 0.1]),
            strokes,
            dots: vec![places[0], places[1], places[2], centre],
            writings: vec![
                write(places[0], "A", (-8, -8)),
                write(places[1], "D", (0, 16)),
                write(places[2], "B", (8, -8)),
                write(centre, &format!("P₁ ({:.3}, {:.3})", centre[0], centre[1]), (10, 10)),
                write([0.0, -drop / 2.0], &format!("{drop:.3} l"), (6, -24)),
                write(places[1], &format!("φ₁ = {phi:.2}°"), (26, 4)),
            ],
        };
        let sheet = Sheet { description: "The bars at lift-off".into(), size: (560, 480) };
        Ok(Figure {
            anchor: "fig3",
            title: "Fig. 3",
            caption: "The bars as they leave the corners, lengths in <i>l</i>. P₁ is the instantaneous centre of velocity \
                      of the left bar: on the normal to the bar at its corner, and level with D."
                .into(),
            svg: sheet.pattern(&pattern)?,
        })
    }

    /// The point of bar AD's plane at rest: v = ω k × r about it.
    fn centre(&self, t: f64) -> Result<[f64; 2], ReportError> {
        let value = |output| at(&*self.fall, output, t);
        let along = [value("x(D)")? - value("x(A)")?, value("y(D)")? - value("y(A)")?];
        let turn = [value("vx(D)")? - value("vx(A)")?, value("vy(D)")? - value("vy(A)")?];
        let omega = (along[0] * turn[1] - along[1] * turn[0]) / (along[0] * along[0] + along[1] * along[1]);
        Ok([value("x(A)")? - value("vy(A)")? / omega, value("y(A)")? + value("vx(A)")? / omega])
    }

    /// Superposed positions: in flight, ten equal steps of the angle, as in the paper.
    fn motion(&self, [open, end]: [f64; 2]) -> Result<Figure, ReportError> {
        let fall = &*self.fall;
        let start = fall.interval()[0];
        let (phi0, phi1) = (at(fall, "phi", start)?, at(fall, "phi", open)?);
        let times = |from: f64, to: f64, interval: [f64; 2], count: u32| -> Result<Vec<f64>, ReportError> {
            let step = |i| Ok(time_of(fall, "phi", from + (to - from) * f64::from(i) / f64::from(count), interval)?);
            (0..=count).map(step).collect()
        };
        let mut strokes = ground(self.l);
        strokes.extend(superposed(fall, &BARS, &times(phi0, phi1, [start, open], 6)?, Ink::Blue)?);
        strokes.extend(superposed(fall, &BARS, &times(phi1, FRAC_PI_2, [open, end], 10)?[1..], Ink::Vermilion)?);
        for point in ["A", "B"] {
            strokes.push(path(fall, point, [start, end], Ink::Green)?);
        }
        let pattern = Pattern {
            x: Axis::linear("x / l", [-1.1, 1.1]),
            y: Axis::linear("y / l", [-2.2, 0.4]),
            strokes,
            dots: Vec::new(),
            writings: Vec::new(),
        };
        let step = ((FRAC_PI_2 - phi1) / 10.0).to_degrees();
        let sheet = Sheet { description: "Superposed positions of the falling pair".into(), size: (560, 660) };
        Ok(Figure {
            anchor: "fig6",
            title: "Fig. 6",
            caption: format!(
                "Superposed positions: <span class=blue>on the corners</span>, then \
                 <span class=vermilion>in free fall</span> at steps of {step:.2}° until the bars meet; \
                 <span class=green>paths of A and B</span>."
            ),
            svg: sheet.pattern(&pattern)?,
        })
    }
}

/// The two sides of the gap.
fn ground(l: f64) -> Vec<Stroke> {
    let side = |sign: f64| Stroke {
        points: vec![[sign * 1.1 * l, 0.0], [sign * 0.5 * l, 0.0], [sign * 0.5 * l, -0.35 * l]],
        ink: Ink::Grey,
        opacity: 1.0,
        width: 4,
    };
    vec![side(-1.0), side(1.0)]
}
