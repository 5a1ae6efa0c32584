//! The line of a mirror, and which point is the image of which.

mod search;

pub(super) use search::images;

use proc_macro2::Span;

use super::bodies::Structure;
use super::scope::Scope;
use super::value::ParameterValues;
use crate::algebra::{Rational, Series};

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
                scope.report.add_message(
                    a.span(),
                    format!("`{a}` or `{b}` is swapped twice; a point has one mirror image"),
                );
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

/// A place at each sample.
pub(super) fn sampled(samples: &[ParameterValues], place: &[Series; 2]) -> Vec<[f64; 2]> {
    samples.iter().map(|numbers| numbers.pair(place)).collect()
}

/// Whether two places agree at every sample where both are numbers, of which there is one at least.
pub(super) fn agree(a: &[[f64; 2]], b: &[[f64; 2]]) -> bool {
    // 1e-9: far above the rounding of a figure's numbers, far below chance at generic parameters.
    let near = |a: f64, b: f64| (a - b).abs() <= 1e-9 * (1.0 + a.abs().max(b.abs()));
    let finite = |(a, b): &(&[f64; 2], &[f64; 2])| a.iter().chain(*b).all(|x| x.is_finite());
    let mut numbers = a.iter().zip(b).filter(finite).peekable();
    numbers.peek().is_some() && numbers.all(|(a, b)| near(a[0], b[0]) && near(a[1], b[1]))
}
