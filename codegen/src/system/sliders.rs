//! Points kept on straight guides, two-sided.

use super::bodies::Structure;
use super::scope::Scope;
use super::{Guide, Slider};
use crate::algebra::{Angle, Series};
use crate::syntax::{SliderDeclaration, Track, plain};

/// Resolves all sliders.
pub(super) fn resolve(scope: &mut Scope, structure: &Structure) -> Vec<Slider> {
    let description = scope.description;
    description.sliders.iter().filter_map(|declared| slider(scope, structure, declared)).collect()
}

fn slider(scope: &mut Scope, structure: &Structure, declared: &SliderDeclaration) -> Option<Slider> {
    let name = declared.of.as_ref().unwrap_or(&declared.name);
    let (point, guide) = match &declared.guide {
        Track::Bar(bar) => {
            let (point, body) = (structure.point(scope, name), structure.bar(scope, bar));
            (point, body.map(Guide::Axis))
        }
        track => {
            let point = structure.moving(scope, name);
            (point, line(scope, track))
        }
    };
    let (point, guide) = (point?, guide?);
    if let Guide::Axis(body) = guide
        && structure.members(body).iter().any(|(member, _)| *member == point)
    {
        let text =
            format!("`{name}` is a point of `{}`; it cannot slide along it", structure.bodies[body].name);
        scope.report.at(name.span(), text);
        return None;
    }
    Some(Slider { name: plain(&declared.name), point, guide, span: declared.name.span() })
}

fn line(scope: &mut Scope, track: &Track) -> Option<Guide> {
    let zero = Series::zero;
    match track {
        Track::Horizontal(height) => {
            let through = [zero(), scope.number(height)?];
            Some(Guide::Line { through, direction: Angle::zero() })
        }
        Track::Vertical(x) => {
            let through = [scope.number(x)?, zero()];
            Some(Guide::Line { through, direction: Angle::quarters(1) })
        }
        Track::Line(angle, through) => {
            let angle = scope.angle(angle);
            let through = through.as_ref().map_or_else(|| Ok([zero(), zero()]), |p| scope.position(p));
            let (angle, through) = (scope.report.keep(angle), scope.report.keep(through));
            Some(Guide::Line { through: through?, direction: angle? })
        }
        Track::Bar(_) => None,
    }
}
