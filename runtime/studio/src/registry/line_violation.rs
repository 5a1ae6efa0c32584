//! Points that start behind a line although nothing is wrong with the contacts: lines keep only
//! what is declared on them.

use super::Configuration;
use liftoff_core::model::geometry::{Fixture, Shape};

/// Less than this part of the distances themselves is rounding.
const ROUNDING: f64 = 1e-9;

/// A point that starts behind a floor, wall or slope in front of which it is in the nominal figure.
#[derive(Clone, PartialEq, Debug)]
pub struct LineViolation {
    /// Name of the point on the wrong side.
    pub point: &'static str,
    /// The support that the line belongs to.
    pub support: &'static str,
    /// How far behind it starts, > 0.
    pub depth: f64,
}

impl core::fmt::Display for LineViolation {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let Self { point, support, depth } = self;
        write!(
            f,
            "{point} starts {depth:.3} behind the line of support {support}, which the nominal figure is in front of; \
             nothing declared keeps {point} there"
        )
    }
}

/// The point that starts farthest behind a line.
pub fn line_violation(start: &Configuration, nominal: &Configuration) -> Option<LineViolation> {
    let fixtures = start.geometry().fixtures.iter();
    let lines = fixtures.filter_map(|fixture| Some((fixture, normal(fixture, start)?)));
    let found = lines.flat_map(|(line, normal)| {
        let at = start.position(line.at);
        let height = move |point: &[f64; 2]| (point[0] - at[0]) * normal[0] + (point[1] - at[1]) * normal[1];
        let pairs = start.layout.points.iter().zip(start.points.iter().zip(&nominal.points));
        pairs.filter_map(move |(&point, (now, usual))| {
            let size = ROUNDING * (1.0 + now[0].abs() + now[1].abs());
            let crossed = height(now) < -size && height(usual) > -size;
            crossed.then(|| LineViolation { point, support: line.name, depth: -height(now) })
        })
    });
    found.max_by(|a, b| a.depth.total_cmp(&b.depth))
}

fn normal(fixture: &Fixture, start: &Configuration) -> Option<[f64; 2]> {
    match fixture.shape {
        Shape::Line { angle, solid: true } => {
            let (sin, cos) = start.number(angle).sin_cos();
            Some([-sin, cos])
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::registry::Models;
    use crate::run_spec::RunSpec;
    use liftoff::prelude::*;

    /// A ladder.
    #[derive(BarSystem)]
    #[gravity(g)]
    #[bar(AB, mass = m, length = l)]
    #[support(A = floor)]
    #[support(B = wall(0), facing = right)]
    #[figure(A = (3 * l / 5, 0), B = (0, 4 * l / 5))]
    #[coordinate(phi = angle(AB), from = horizontal)]
    #[coordinate(x = x(A))]
    #[coordinate(y = y(A))]
    struct Ladder {
        m: f64,
        l: f64,
        g: f64,
    }

    fn violation(models: &Models, phi: f64) -> Option<LineViolation> {
        let model = models.find("ladder").expect("a model");
        let spec = RunSpec::with(&[("m", 1.0), ("l", 1.0), ("g", 1.0)]);
        let at = |spec: &RunSpec| model.configuration(spec).expect("a start");
        line_violation(&at(&spec.clone().start(&[("phi", phi)])), &at(&spec))
    }

    #[test]
    fn a_foot_behind_the_wall_that_only_the_head_meets_is_reported() {
        let models = crate::models![Ladder];
        assert_eq!(violation(&models, 1.3), None);
        let Some(LineViolation { point: "A", support: "B", depth }) = violation(&models, 3.0) else {
            panic!("no violation found")
        };
        assert!((depth + 3f64.cos()).abs() < 1e-12, "{depth}");
    }
}
