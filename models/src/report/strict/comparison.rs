//! Fig. 1b as published against strict.

use super::{MODEL, Run, names, setup};
use crate::catalog::{Record, find};
use crate::plot::{Axis, Chart, Curve, Ink, Mark, Sheet};
use crate::report::ReportError;
use crate::report::figure::Figure;
use crate::report::published::Runs;
use crate::report::reading::{at, curve, time_of};

/// One mass ratio both ways.
#[derive(Clone, PartialEq, Debug)]
pub struct Line {
    /// m₂/(m₁ + m₂) as the ids write it.
    pub ratio: &'static str,
    /// As published: the angles at lift-off and as B and D reach the floor.
    pub published: [Option<f64>; 2],
    /// Strict: the supports that open first, and the angle.
    pub first: Option<(String, f64)>,
    /// Strict: the supports that open next, with the inner and the outer angle.
    pub second: Option<(String, [f64; 2])>,
    /// Strict: inner and outer angle as B and D reach the floor.
    pub touch: Option<[f64; 2]>,
}

/// The ratios that were run both ways.
pub fn lines(published: &[Runs], strict: &[Run]) -> Vec<Line> {
    let both = |run| Some((run, published.iter().find(|other| other.ratio().0 == Run::ratio(run).0)?));
    strict.iter().filter_map(both).map(|(run, other)| run.line(other)).collect()
}

impl Run {
    /// The mass ratio.
    pub fn ratio(&self) -> super::Ratio {
        self.ratio
    }

    fn line(&self, published: &Runs) -> Line {
        let mut openings = self.openings();
        let (first, second) = (openings.next(), openings.next());
        let pair = |event| Some([self.angle(event, "phi_inner")?, self.angle(event, "phi_outer")?]);
        Line {
            ratio: self.ratio.0,
            published: [published.lift_off(), published.touch_down()],
            first: first.and_then(|event| Some((names(event), self.angle(first, "phi_inner")?))),
            second: second.and_then(|event| Some((names(event), pair(second)?))),
            touch: pair(self.closing()),
        }
    }

    /// What differs, in two sentences: `published` and this run have one mass ratio.
    pub fn difference(&self, published: &Runs, tolerance: f64) -> Result<Option<String>, ReportError> {
        let line = self.line(published);
        let (Some((first, phi)), Some((second, then)), Some(touch), [Some(phi1), Some(phi2)]) =
            (line.first, line.second, line.touch, line.published)
        else {
            return Ok(None);
        };
        let held = find(MODEL)?.run(&setup(self.ratio.1, tolerance)?.hold(&["A", "C", "E"]).until(&format!("phi_inner = {phi1:?}")))?;
        let end = held.interval()[1];
        let [n_c, n_a] = [at(&*held, "N(C)", end)?, at(&*held, "N(A)", end)?];
        Ok(Some(format!(
            "Watched one by one at λ = {}, {first} opens first, at φ = {phi:.6}, and {second} follow at \
             φ<sub>inner</sub> = {:.6}, whereas the paper keeps all three closed until their total vanishes at φ = {phi1:.6}, \
             where it would need N<sub>C</sub> = {}, N<sub>A</sub> = N<sub>E</sub> = {} (in (m₁ + m₂)g). \
             From the first opening on, the inner and outer angles differ, which the paper rules out by assumption, \
             and B and D reach the floor at φ<sub>inner</sub> = {}, φ<sub>outer</sub> = {} instead of both at {}.",
            self.ratio.1,
            then[0],
            signed(n_c),
            signed(n_a),
            signed(touch[0]),
            signed(touch[1]),
            signed(phi2),
        )))
    }

    /// Reactions one by one and in total; then the angles until B and D reach the floor.
    pub fn figure(&self, published: &Runs) -> Result<Option<Figure>, ReportError> {
        let (Some(first), Some(last), Some(flight)) =
            (self.openings().next(), self.openings().last(), published.interval())
        else {
            return Ok(None);
        };
        let panels = [self.reactions(published, flight[0], last.t)?, self.angles(published, first.t, flight[1])?];
        let sheet = Sheet { description: "Fig. 1b as published against strict".into(), size: (860, 620) };
        Ok(Some(Figure {
            anchor: "strict",
            title: "Fig. 1b, both ways",
            caption: format!(
                "λ = {}: <span class=blue>as published</span>, N / (m₁ + m₂)g of A, C and E in total; strict, each on its own.",
                self.ratio.1
            ),
            svg: sheet.charts(&panels)?,
        }))
    }

    fn reactions(&self, published: &Runs, open: f64, last: f64) -> Result<Chart, ReportError> {
        const FROM: f64 = 0.75;
        let strict = &*self.flight;
        let early = |record: &dyn Record, angle, end| time_of(record, angle, FROM, [record.interval()[0], end]);
        let total = curve(
            published.flight(),
            ["phi", "N(A, C, E) / ((m1 + m2) * g)"],
            [early(published.flight(), "phi", open)?, open],
            200,
        )?;
        let share = |output| -> Result<_, ReportError> {
            let from = early(strict, "phi_inner", last)?;
            Ok(curve(strict, ["phi_inner", output], [from, last], 400)?)
        };
        let (n_c, n_a) = (share("N(C) / ((m1 + m2) * g)")?, share("N(A) / ((m1 + m2) * g)")?);
        let end = |points: &[[f64; 2]]| points.last().map_or(0.0, |p| p[0]);
        let mark = |phi: f64, text: &str, offset| Mark { at: [phi, 0.0], label: text.into(), offset };
        let opened = self.openings().next();
        let c = self.angle(opened, "phi_inner").unwrap_or(f64::NAN);
        let low = end(&n_a).min(end(&total));
        Ok(Chart {
            x: Axis::linear("φ (φ_inner), rad", [FROM, (low * 20.0).floor() / 20.0]),
            y: Axis::holding("N / (m₁ + m₂)g", total.iter().chain(&n_c).chain(&n_a).map(|p| p[1])),
            marks: vec![
                mark(c, "first", (-8, -14)),
                mark(end(&total), "published", (8, -14)),
                mark(end(&n_a), "second", (8, -14)),
            ],
            curves: vec![
                Curve::solid("A, C, E as published", Ink::Blue, total).dashed(),
                Curve::solid("C", Ink::Vermilion, n_c),
                Curve::solid("A (and E)", Ink::Green, n_a),
            ],
        })
    }

    fn angles(&self, published: &Runs, from: f64, to: f64) -> Result<Chart, ReportError> {
        let strict = &*self.flight;
        let end = strict.interval()[1];
        let phi = curve(published.flight(), ["t", "phi"], [from, to], 200)?;
        let inner = curve(strict, ["t", "phi_inner"], [from, end], 200)?;
        let outer = curve(strict, ["t", "phi_outer"], [from, end], 200)?;
        Ok(Chart {
            x: Axis::holding("t, √(l/g)", phi.iter().chain(&inner).map(|p| p[0])),
            y: Axis::holding("φ, rad", phi.iter().chain(&inner).chain(&outer).map(|p| p[1])),
            curves: vec![
                Curve::solid("φ as published", Ink::Blue, phi).dashed(),
                Curve::solid("φ_inner", Ink::Vermilion, inner),
                Curve::solid("φ_outer", Ink::Green, outer),
            ],
            marks: Vec::new(),
        })
    }
}

/// Six decimals with a real minus sign.
fn signed(value: f64) -> String {
    format!("{value:.6}").replace('-', "−")
}
