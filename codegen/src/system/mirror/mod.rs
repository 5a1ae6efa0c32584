//! Mirror symmetry in a line x = a or y = a: which point, bar and support is the image of which,
//! and that images agree in everything that matters.
//!
//! Reflection in x = a takes a direction δ to π − δ, in y = a to −δ. A left normal becomes the
//! right one of the image; if the image is described from its other end, the left one again.

mod bodies;
mod constraints;
mod images;
mod loads;
mod motion;
mod places;
mod shapes;

use super::Mirror;
use super::bodies::Structure;
use super::figure::Figure;
use super::mirror_line::{Line, agree, sampled};
use super::parts::Parts;
use super::scope::Scope;
use super::value::ParameterValues;
use crate::algebra::Series;
use crate::syntax::Description;
use images::{Images, check};

/// What is needed to compare an original with its image.
struct Pairing<'a> {
    structure: &'a Structure,
    line: &'a Line,
    figure: &'a Figure,
    points: &'a [usize],
    samples: Vec<ParameterValues>,
}

impl Pairing<'_> {
    fn same(&self, a: &Series, b: &Series) -> bool {
        let [a_and_0, b_and_0] = [a, b].map(|c| sampled(&self.samples, &[c.clone(), Series::zero()]));
        a == b || agree(&a_and_0, &b_and_0)
    }

    fn name(&self, point: usize) -> &str {
        &self.structure.points[point].name
    }

    /// Each unordered pair of a point and its image once.
    fn pairs(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        self.points.iter().enumerate().map(|(p, &q)| (p, q)).filter(|(p, q)| p <= q)
    }
}

/// Completes the mirror and checks it.
pub(super) fn resolve(
    scope: &mut Scope,
    structure: &Structure,
    line: Line,
    figure: &Figure,
    parts: &Parts,
) -> Option<Mirror> {
    let points = figure.images.clone()?;
    let pairing = Pairing { structure, line: &line, figure, points: &points, samples: scope.samples() };
    places::check(scope, &pairing);
    let bodies = bodies::bodies(scope, &pairing)?;
    let supports = if understood(scope.description, parts) {
        let images = Images { pairing: &pairing, bodies: &bodies, parts };
        others(scope, &images);
        let supports = shapes::supports(scope, &pairing, &bodies, &parts.supports)?;
        shapes::frictions(scope, &images, &supports);
        supports
    } else {
        return None;
    };
    let Line { axis, at, span, .. } = line;
    Some(Mirror { axis, at, points, bodies, supports, span })
}

fn others(scope: &mut Scope, images: &Images) {
    let parts = images.parts;
    check(scope, images, &parts.welds);
    check(scope, images, &parts.sliders);
    check(scope, images, &parts.drives);
    check(scope, images, &parts.springs);
    check(scope, images, &parts.torsions);
    check(scope, images, &parts.loads);
}

/// Whether all that needs an image is there; what is missing has been told.
fn understood(d: &Description, parts: &Parts) -> bool {
    let supports: usize = d.supports.iter().map(|support| support.names().len()).sum();
    let stops = 2 * d.sliders.iter().filter(|slider| slider.stops.is_some()).count();
    let limits: usize = d.limits.iter().map(|limit| limit.bounds().count()).sum();
    let counts = [
        (supports + stops + d.threads.len() + limits, parts.supports.len()),
        (d.welds.len(), parts.welds.len()),
        (d.sliders.len(), parts.sliders.len()),
        (d.drives.len(), parts.drives.len()),
        (d.springs.len(), parts.springs.len()),
        (d.torsions.len(), parts.torsions.len()),
        (d.forces.len() + d.couples.len(), parts.loads.len()),
        (d.coordinates.len(), parts.coordinates.len()),
    ];
    counts.iter().all(|(declared, resolved)| declared == resolved)
}
