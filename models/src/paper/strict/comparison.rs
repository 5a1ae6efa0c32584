//! Fig. 1b as published against strict.

use super::{MODEL, Run, names, spec};
use crate::models;
use crate::paper::ReportError;
use crate::paper::figure::decimals;
use crate::paper::published::PublishedRuns;
use crate::paper::reading::evaluate_output;

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

/// Every ratio both ways.
pub fn lines(strict: &[Run], tolerance: f64) -> Result<Vec<Line>, ReportError> {
    strict.iter().map(|run| Ok(run.line(&PublishedRuns::new(run.ratio, tolerance)?))).collect()
}

impl Run {
    /// The mass ratio.
    pub fn ratio(&self) -> super::Ratio {
        self.ratio
    }

    fn line(&self, published: &PublishedRuns) -> Line {
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

    /// What differs, in two sentences; `published` has this run's mass ratio. None without a second
    /// opening.
    pub fn difference(
        &self,
        published: &PublishedRuns,
        tolerance: f64,
    ) -> Result<Option<String>, ReportError> {
        let line = self.line(published);
        let (Some((first, phi)), Some((second, then)), Some(touch), [Some(phi1), Some(phi2)]) =
            (line.first, line.second, line.touch, line.published)
        else {
            return Ok(None);
        };
        let spec = spec(self.ratio.1, tolerance)?.hold(&["A", "C", "E"]);
        let held = models().find(MODEL)?.run(&spec.until(&format!("phi_inner = {phi1}")))?;
        let reaction = |support: &str| {
            evaluate_output(&held, &format!("N({support}) / ((m1 + m2) * g)"), held.interval()[1])
        };
        Ok(Some(format!(
            "Watched one by one at λ = {ratio}, the first support to open is {first}, at φ = {phi:.6}, and the next are \
             {second}, at φ<sub>inner</sub> = {inner:.6}; the paper watches only the total, which vanishes at \
             φ = {phi1:.6}, where it would take N<sub>C</sub> = {n_c} and N<sub>A</sub> = N<sub>E</sub> = {n_a} \
             (in (m₁ + m₂)<i>g</i>). From the first opening on, inner and outer angles differ, which the paper rules out \
             by assumption, and B and D reach the floor at φ<sub>inner</sub> = {t_inner}, φ<sub>outer</sub> = {t_outer} \
             instead of both at {phi2}.",
            ratio = self.ratio.1,
            second = second.replace(", ", " and "),
            inner = then[0],
            n_c = decimals(reaction("C")?, 4),
            n_a = decimals(reaction("A")?, 5),
            t_inner = decimals(touch[0], 6),
            t_outer = decimals(touch[1], 6),
            phi2 = decimals(phi2, 6),
        )))
    }
}
