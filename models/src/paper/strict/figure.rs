//! Fig. 1b as published against strict, drawn.

use super::Run;
use crate::paper::ReportError;
use crate::paper::figure::CaptionedFigure;
use crate::paper::published::PublishedRuns;
use crate::paper::reading::time_of;
use liftoff::Trajectory;
use liftoff_studio::picture::curve;
use liftoff_studio::plot::{Axis, Chart, Colour, Curve, Figure, Mark};

/// The angle at which the drawing of the reactions begins.
const FROM: f64 = 0.75;

impl Run {
    /// Reactions one by one and in total; then how far the angles depart from the published one.
    /// `published` has this run's mass ratio; none if either motion has no flight.
    pub fn figure(&self, published: &PublishedRuns) -> Result<Option<CaptionedFigure>, ReportError> {
        let (Some(first), Some(last)) = (self.openings().next(), self.openings().last()) else {
            return Ok(None);
        };
        let Some(flight) = published.interval() else {
            return Ok(None);
        };
        let panels =
            [self.reactions(published, flight[0], [first.t, last.t])?, self.departures(published, first.t)?];
        let sheet = Figure { description: "Fig. 1b as published against strict".into(), size: (860, 620) };
        Ok(Some(CaptionedFigure {
            anchor: "strict",
            title: "Fig. 1b, both ways",
            caption: format!(
                "λ = {}. Above: total reaction of A, C and E as published, and the reactions one by one, with the zeros that \
                 end a phase, in (m₁ + m₂)<i>g</i>, half the weight (Fig. 7: in the whole weight). Below: how far the strict angles depart from the published one at the same time, until \
                 B and D reach the floor.",
                self.ratio.1
            ),
            svg: sheet.charts(&panels),
        }))
    }

    fn reactions(
        &self,
        published: &PublishedRuns,
        open: f64,
        [first, last]: [f64; 2],
    ) -> Result<Chart, ReportError> {
        let strict = &self.flight;
        let total = late(published.flight(), ["phi", "N(A, C, E) / ((m1 + m2) * g)"], open)?;
        let n_c = late(strict, ["phi_inner", "N(C) / ((m1 + m2) * g)"], last)?;
        let n_a = late(strict, ["phi_inner", "N(A) / ((m1 + m2) * g)"], last)?;
        let phi_inner = strict.function("phi_inner")?;
        let zero = |phi, text: &str| Mark { at: [phi, 0.0], label: text.into() };
        let marks = vec![
            zero(phi_inner(first), "first"),
            zero(total[total.len() - 1][0], "published"),
            zero(phi_inner(last), "second"),
        ];
        let low = marks.iter().map(|mark| mark.at[0]).fold(FROM, f64::min);
        Ok(Chart {
            x: Axis::linear("φ as published, inner angle strict, rad", [FROM, (low * 20.0).floor() / 20.0]),
            y: Axis::holding("N / ((m₁ + m₂) g)", total.iter().chain(&n_c).chain(&n_a).map(|p| p[1])),
            curves: vec![
                Curve::solid("A, C, E as published", Colour::Blue, total).dashed(),
                Curve::solid("C", Colour::Vermilion, n_c),
                Curve::solid("A (and E)", Colour::Green, n_a),
            ],
            marks,
        })
    }

    /// Both motions start in one state, so that their times agree.
    fn departures(&self, published: &PublishedRuns, first: f64) -> Result<Chart, ReportError> {
        let strict = &self.flight;
        let end = strict.interval()[1].min(published.flight().interval()[1]);
        let phi = published.flight().function("phi")?;
        let departure = |angle| -> Result<Vec<[f64; 2]>, ReportError> {
            let points = curve(strict, ["t", angle], [first, end])?;
            Ok(points.into_iter().map(|[t, value]| [t - first, value - phi(t)]).collect())
        };
        let (inner, outer) = (departure("phi_inner")?, departure("phi_outer")?);
        Ok(Chart {
            x: Axis::holding("time after the first opening, √(l/g)", inner.iter().map(|p| p[0])),
            y: Axis::holding("departure, rad", inner.iter().chain(&outer).map(|p| p[1])),
            curves: vec![
                Curve::solid("inner − published", Colour::Vermilion, inner),
                Curve::solid("outer − published", Colour::Green, outer),
            ],
            marks: Vec::new(),
        })
    }
}

/// The curve from the angle where the drawing begins to the time `end`.
fn late(record: &Trajectory, outputs: [&str; 2], end: f64) -> Result<Vec<[f64; 2]>, ReportError> {
    let begin = time_of(record, outputs[0], FROM, [record.interval()[0], end])?;
    Ok(curve(record, outputs, [begin, end])?)
}
