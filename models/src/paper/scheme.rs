//! Fig. 1 of the paper: both systems with their names.

use super::ReportError;
use super::falling_pair::{self, BARS};
use super::figure::CaptionedFigure;
use super::published;
use super::reading::{places, time_of};
use liftoff::Trajectory;
use liftoff_studio::plot::{Axis, Colour, Dash, Figure, Label, Stroke, Superposition};

/// The angles at which the systems are drawn.
const ANGLES: [f64; 2] = [0.35, 1.05];
/// The radius of the arc of an angle, l.
const RADIUS: f64 = 0.22;

/// Both drawings.
pub fn figures(
    pair: &falling_pair::FallingPairRuns,
    zigzag: &published::PublishedRuns,
) -> Result<[CaptionedFigure; 2], ReportError> {
    Ok([two_bars(pair)?, four_bars(zigzag)?])
}

fn two_bars(runs: &falling_pair::FallingPairRuns) -> Result<CaptionedFigure, ReportError> {
    let bars = at_angle(runs.fall(), &BARS, ANGLES[0])?;
    let [a, d, b] = [bars[0], bars[1], bars[2]];
    let mut strokes = falling_pair::ground(1.0);
    strokes.push(line(vec![d, [d[0] + 0.45, d[1]]], Colour::Black, 1));
    strokes.push(arc(d, [0.0, ANGLES[0]], 1.6 * RADIUS));
    strokes.push(line(bars.clone(), Colour::Blue, 3));
    let drop = Stroke { dash: Dash::Dashed, ..line(vec![[0.0, 0.0], d], Colour::Green, 1) };
    strokes.push(drop);
    let superposition = Superposition {
        x: Axis::linear("x / l", [-1.15, 1.15]),
        y: Axis::linear("y / l", [-0.45, 0.35]),
        strokes,
        dots: vec![a, d, b, [-0.5, 0.0], [0.5, 0.0]],
        labels: vec![
            label(a, "A", (-8, -8)),
            label(d, "D", (0, 18)),
            label(b, "B", (8, -8)),
            label([-0.5, 0.0], "P", (-14, 18)),
            label([0.5, 0.0], "Q", (14, 18)),
            label([d[0] + 1.6 * RADIUS, d[1] + 0.07], "φ", (6, 4)),
            label([0.0, 0.5 * d[1]], "y", (-8, 4)),
        ],
        legend: Vec::new(),
    };
    let sheet = Figure { description: "Fig. 1a: two bars on two corners".into(), size: (560, 300) };
    Ok(CaptionedFigure {
        anchor: "fig1a",
        title: "Fig. 1a",
        caption: "Two equal bars AD and DB of mass <i>m</i> and length <i>l</i>, hinged at D, lie across a gap of width \
                  <i>l</i> on the smooth corners P and Q. φ is the angle of the bars to the horizontal, <i>y</i> the drop of D; \
                  N is the reaction of one corner, at right angles to its bar. From rest at φ = 0, each bar on its own midpoint."
            .into(),
        svg: sheet.superposition(&superposition),
    })
}

fn four_bars(runs: &published::PublishedRuns) -> Result<CaptionedFigure, ReportError> {
    let points = at_angle(runs.flight(), &["A", "B", "C", "D", "E"], ANGLES[1])?;
    let [a, b, c, d, e] = [points[0], points[1], points[2], points[3], points[4]];
    let thread = Stroke { dash: Dash::Dashed, ..line(vec![b, d], Colour::Green, 1) };
    let middle = |p: [f64; 2], q: [f64; 2]| [0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1])];
    let superposition = Superposition {
        x: Axis::linear("x / l", [-1.3, 1.3]),
        y: Axis::linear("y / l", [-0.1, 1.05]),
        strokes: vec![
            line(vec![[-1.3, 0.0], [1.3, 0.0]], Colour::Grey, 4),
            thread,
            arc(c, [0.0, ANGLES[1]], RADIUS),
            line(points.clone(), Colour::Blue, 3),
        ],
        dots: points.clone(),
        labels: vec![
            label(a, "A", (-12, -6)),
            label(b, "B", (0, -10)),
            label(c, "C", (-14, -8)),
            label(d, "D", (0, -10)),
            label(e, "E", (12, -6)),
            label([c[0] + RADIUS, c[1] + 0.1], "φ", (8, 0)),
            label(middle(a, b), "m₂", (-18, -4)),
            label(middle(b, c), "m₁", (16, -4)),
            label(middle(c, d), "m₁", (-16, -4)),
            label(middle(d, e), "m₂", (18, -4)),
            label(middle(b, d), "thread", (0, -6)),
        ],
        legend: Vec::new(),
    };
    let sheet = Figure { description: "Fig. 1b: four bars on the floor".into(), size: (560, 300) };
    Ok(CaptionedFigure {
        anchor: "fig1b",
        title: "Fig. 1b",
        caption: "Four bars of length <i>l</i>, the inner ones BC and CD of mass <i>m</i>₁, the outer ones AB and DE of \
                  mass <i>m</i>₂, stand on the smooth floor at A, C and E, held by the thread BD until it breaks. \
                  λ = <i>m</i>₂/(<i>m</i>₁ + <i>m</i>₂); φ is the angle of every bar to the horizontal, and where inner \
                  and outer bars differ, φ<sub>inner</sub> that of BC and CD, φ<sub>outer</sub> that of AB and DE. \
                  N is the reaction of the floor, of A, C and E together where no point is named. From rest at φ(0) = π/2 \
                  unless said otherwise."
            .into(),
        svg: sheet.superposition(&superposition),
    })
}

/// The named points when the bars have this angle.
fn at_angle(record: &Trajectory, points: &[&str], phi: f64) -> Result<Vec<[f64; 2]>, ReportError> {
    let time = time_of(record, "phi", phi, record.interval())?;
    Ok(places(record, points, time)?)
}

fn line(points: Vec<[f64; 2]>, colour: Colour, width: u32) -> Stroke {
    Stroke::solid(points, colour, 1.0, width)
}

/// The arc of an angle at a point.
pub(super) fn arc(centre: [f64; 2], [from, to]: [f64; 2], radius: f64) -> Stroke {
    let point = |k: u32| {
        let (sin, cos) = (from + (to - from) * f64::from(k) / 24.0).sin_cos();
        [centre[0] + radius * cos, centre[1] + radius * sin]
    };
    line((0..=24).map(point).collect(), Colour::Black, 1)
}

fn label(at: [f64; 2], text: &str, offset: (i32, i32)) -> Label {
    Label { at, text: text.into(), offset }
}
