//! Mirror symmetry in a line x = a or y = a: which point, bar and support is the image of which, and that images
//! agree in everything that matters.
//!
//! Reflection in x = a takes a direction δ to π − δ, in y = a to −δ. A left normal becomes the right one of
//! the image; if the image is described from its other end, the left one again.

mod bodies;
mod constraints;
mod images;
mod loads;
mod motion;
mod places;
pub(super) mod search;
mod shapes;

use proc_macro2::Span;

use super::Mirror;
use super::bodies::Structure;
use super::figure::Figure;
use super::resolve::Parts;
use super::scope::Scope;
use super::value::Numbers;
use crate::algebra::{Rational, Series};
use crate::syntax::Description;
use images::{Images, check};

/// A mirror before its images are known.
#[derive(Clone, Debug)]
pub(super) struct Line {
    /// 0 for x = at, 1 for y = at.
    pub axis: usize,
    /// Where it lies.
    pub at: Series,
    /// Pairs that the user gives.
    pub swaps: Vec<[usize; 2]>,
    /// Where it is declared.
    pub span: Span,
}

impl Line {
    /// The declared mirror, if there is one and it is understood.
    pub fn resolve(scope: &mut Scope, structure: &Structure) -> Option<Self> {
        let declared = scope.description.mirror.as_ref()?;
        let at = scope.number(&declared.at);
        let mut swaps: Option<Vec<[usize; 2]>> = Some(Vec::new());
        for [a, b] in &declared.swaps {
            let pair = [structure.point(scope, a), structure.point(scope, b)];
            if pair.iter().flatten().any(|p| swaps.iter().flatten().flatten().any(|q| p == q)) {
                scope
                    .report
                    .at(a.span(), format!("`{a}` or `{b}` is swapped twice; a point has one mirror image"));
                swaps = None;
            }
            swaps = swaps.zip(pair[0].zip(pair[1])).map(|(mut all, (a, b))| {
                all.push([a, b]);
                all
            });
        }
        Some(Self { axis: declared.axis, at: at?, swaps: swaps?, span: declared.span })
    }

    /// The mirror image of a place.
    pub fn image(&self, place: &[Series; 2]) -> [Series; 2] {
        let mut image = place.clone();
        image[self.axis] = &self.at.scale(Rational::integer(2)) - &place[self.axis];
        image
    }
}

/// What is needed to compare an original with its image.
struct Pairing<'a> {
    structure: &'a Structure,
    line: &'a Line,
    figure: &'a Figure,
    points: &'a [usize],
    samples: Vec<Numbers>,
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

/// A place at each sample.
fn sampled(samples: &[Numbers], place: &[Series; 2]) -> Vec<[f64; 2]> {
    samples.iter().map(|numbers| numbers.pair(place)).collect()
}

/// Whether two places agree at every sample where both are numbers, of which there is one at least.
fn agree(a: &[[f64; 2]], b: &[[f64; 2]]) -> bool {
    // 1e-9: far above the rounding of a figure's numbers, far below chance at generic parameters.
    let near = |a: f64, b: f64| (a - b).abs() <= 1e-9 * (1.0 + a.abs().max(b.abs()));
    let finite = |(a, b): &(&[f64; 2], &[f64; 2])| a.iter().chain(*b).all(|x| x.is_finite());
    let mut numbers = a.iter().zip(b).filter(finite).peekable();
    numbers.peek().is_some() && numbers.all(|(a, b)| near(a[0], b[0]) && near(a[1], b[1]))
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
    let counts = [
        (supports + stops + d.threads.len(), parts.supports.len()),
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
