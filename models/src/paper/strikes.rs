//! Which points of Fig. 1b reach the floor first after lift-off: B and D, or for light outer bars
//! those that have left it.

use super::ReportError;
use super::border::find_border;
use super::figure::{CaptionedFigure, decimals};
use super::published::{self, normalised};
use super::quantity::Quantity;
use super::reading::coordinate;
use super::strict;
use crate::models;
use liftoff::prelude::*;
use liftoff_studio::plot::{Axis, Chart, Colour, Curve, Figure, Mark};
use liftoff_studio::sweep::Sweep;

/// How C and the outer ends are watched: a model, and its angle of the inner bars.
#[derive(Clone, Copy)]
struct Scheme {
    model: &'static str,
    angle: &'static str,
}

const PUBLISHED: Scheme = Scheme { model: published::MODEL, angle: "phi" };
const STRICT: Scheme = Scheme { model: strict::MODEL, angle: "phi_inner" };

/// Mass ratios between which the order changes, in both schemes.
const AROUND: &str = "lambda=0.01:0.05:2";
/// Mass ratios whose φ₂ is compared with a reference, beside those of Table 1.
const LIGHT: [(&str, f64); 2] = [("0.0001", 0.0001), ("0.01", 0.01)];

impl Scheme {
    /// The angle of the inner bars at the first contact after lift-off.
    fn find_first_strike(self, ratio: f64, tolerance: f64) -> Result<Option<f64>, ReportError> {
        let model = models().find(self.model)?;
        let run = model.run(&normalised(model.default_run().tolerance(tolerance), ratio))?;
        let opened = run.events().iter().position(|event| event.kind == EventKind::Open);
        let strikes = |event: &&Event| matches!(event.kind, EventKind::Impact | EventKind::Close);
        let later = opened.map_or(&[][..], |opened| &run.events()[opened..]);
        Ok(later.iter().find(strikes).and_then(|event| coordinate(&run, &event.state, self.angle)))
    }

    /// The mass ratio at which C and D reach the floor at once, with the inner bars level; C does
    /// first below it.
    fn find_level(self, tolerance: f64) -> Result<f64, ReportError> {
        let model = models().find(self.model)?;
        let sweep = Sweep::new(model)
            .spec(normalised(model.default_run().tolerance(tolerance), 0.0))
            .vary(AROUND)?
            .set("m1=1-lambda")?
            .set("m2=lambda")?
            .observe("first impact")?;
        find_border(&sweep, tolerance)
    }
}

/// The order of strikes over the mass ratio.
pub struct Strikes {
    /// The mass ratio at which all five points of the published scheme reach the floor at once.
    pub published_level: f64,
    /// The mass ratio at which C, watched on its own, reaches it with B and D.
    pub strict_level: f64,
    /// φ₂ of the published scheme for light outer bars.
    light: Vec<(&'static str, Option<f64>)>,
    tolerance: f64,
}

impl Strikes {
    /// From runs of both schemes.
    pub fn new(tolerance: f64) -> Result<Self, ReportError> {
        let light =
            LIGHT.into_iter().map(|(name, ratio)| Ok((name, PUBLISHED.find_first_strike(ratio, tolerance)?)));
        Ok(Self {
            published_level: PUBLISHED.find_level(tolerance)?,
            strict_level: STRICT.find_level(tolerance)?,
            light: light.collect::<Result<_, ReportError>>()?,
            tolerance,
        })
    }

    /// φ₂ for λ = 0.01.
    pub fn light(&self) -> Option<f64> {
        self.light.last()?.1
    }

    /// The numbers of `references.json`.
    pub fn quantities(&self) -> Vec<Quantity> {
        let level = |id: &str, scheme: Scheme, quantity, value| {
            Quantity::number(id, scheme.model, quantity, "1", Some(value))
        };
        let light = self.light.iter().map(|(name, phi)| {
            let id = format!("fig1b.phi2[{name}]");
            Quantity::number(id, PUBLISHED.model, "angle as A, C and E land again", "rad", *phi)
        });
        let mut all: Vec<Quantity> = light.collect();
        all.extend([
            level(
                "fig1b.level",
                PUBLISHED,
                "λ at which all five points reach the floor at once",
                self.published_level,
            ),
            level("strict.level", STRICT, "λ at which C lands as B and D reach the floor", self.strict_level),
        ]);
        all
    }

    /// The angle of the inner bars at the first strike, over λ.
    pub fn figure(&self) -> Result<CaptionedFigure, ReportError> {
        let published = self.curve(PUBLISHED, self.published_level)?;
        let strict = self.curve(STRICT, self.strict_level)?;
        let chart = Chart {
            x: Axis::decades("λ", [2e-4, 0.9]),
            y: Axis::holding(
                "angle of the inner bars at the first strike, rad",
                published.iter().chain(&strict).map(|point| point[1]),
            ),
            curves: vec![
                Curve::solid("as published, φ₂", Colour::Blue, published),
                Curve::solid("strict", Colour::Vermilion, strict).dashed(),
            ],
            marks: vec![Mark {
                at: [self.published_level, 0.0],
                label: format!("λ = {}", decimals(self.published_level, 6)),
            }],
        };
        let sheet =
            Figure { description: "Angle at the first strike over the mass ratio".into(), size: (560, 480) };
        Ok(CaptionedFigure {
            anchor: "strikes",
            title: "Fig. 1b: what strikes first",
            caption: format!(
                "The angle of the inner bars at which a point first reaches the floor after lift-off. Above 0 A, C and E land \
                 again, strictly C; below 0 B and D strike. The borders are at λ = {} as published, where all bars lie level, and \
                 at λ = {} strictly. Table 1 has 0.34 at λ = 0, then −0.022.",
                decimals(self.published_level, 10),
                decimals(self.strict_level, 10),
            ),
            svg: sheet.charts(&[chart]),
        })
    }

    /// Through the border, at which the curve has a kink.
    fn curve(&self, scheme: Scheme, level: f64) -> Result<Vec<[f64; 2]>, ReportError> {
        let mut ratios: Vec<f64> = (0..=60).map(|k| 10_f64.powf(-4.0 + f64::from(k) / 15.0)).collect();
        // λ = 1 has no inner masses, which the strict scheme needs.
        ratios.pop();
        ratios.push(0.99);
        let mut points = Vec::new();
        for ratio in ratios {
            if let Some(phi) = scheme.find_first_strike(ratio, self.tolerance)? {
                points.push([ratio, phi]);
            }
        }
        points.push([level, 0.0]);
        points.sort_by(|a, b| a[0].total_cmp(&b[0]));
        Ok(points)
    }
}
