//! Images of points: a point whose place is known maps to the point at the mirror image of that
//! place; the rest follow from the bars that join them, if they follow uniquely.

use super::super::bodies::Structure;
use super::super::names::ParameterNames;
use super::super::scope::Scope;
use super::{Line, agree, sampled};
use crate::algebra::Series;

type Places = [Option<[Series; 2]>];

/// Assignments tried before a figure counts as ambiguous; each costs about the number of points
/// squared.
const TRIES: usize = 10_000;

/// The image of each point.
pub(in super::super) fn images(
    scope: &Scope,
    structure: &Structure,
    line: &Line,
    places: &Places,
) -> syn::Result<Vec<usize>> {
    let candidates = candidates(scope, structure, line, places)?;
    let mut search = Search { structure, candidates: &candidates, found: Vec::new(), tries: 0 };
    let mut start = vec![None; structure.points.len()];
    for (point, images) in candidates.iter().enumerate() {
        if let &[image] = &images[..] {
            start[point] = Some(image);
            start[image].get_or_insert(point);
        }
    }
    search.extend(start);
    match &search.found[..] {
        [images] => Ok(images.clone()),
        [] => {
            let text =
                "the bars have no mirror images in this line; give the pairs: `#[mirror(x = 0, swap(A, E))]`";
            Err(syn::Error::new(line.span, text))
        }
        [a, b, ..] => Err(ambiguous(structure, line, a, b)),
    }
}

fn ambiguous(structure: &Structure, line: &Line, a: &[usize], b: &[usize]) -> syn::Error {
    let name = |point: usize| &structure.points[point].name;
    let point = (0..a.len()).find(|&p| a[p] != b[p]).unwrap_or(0);
    let text = format!(
        "the mirror image of point `{0}` may be `{1}` or `{2}`; place `{0}` in the figure or add `swap({0}, {1})` here",
        name(point),
        name(a[point]),
        name(b[point])
    );
    syn::Error::new(line.span, text)
}

fn candidates(
    scope: &Scope,
    structure: &Structure,
    line: &Line,
    places: &Places,
) -> syn::Result<Vec<Vec<usize>>> {
    let known = at_images(scope, structure, line, places);
    let open = |p: usize| known[p].is_empty();
    let degree = |p: usize| structure.points[p].on.len();
    let candidates = |p: usize| -> Vec<usize> {
        if let Some(image) = line.swaps.iter().find_map(|pair| partner(*pair, p)) {
            return vec![image];
        }
        let free = |&q: &usize| {
            let undrawn = places[p].is_none() || places[q].is_none();
            open(q) && undrawn && degree(p) == degree(q) && akin(structure, p, q)
        };
        match open(p) {
            true => (0..places.len()).filter(free).collect(),
            false => known[p].clone(),
        }
    };
    let all: Vec<Vec<usize>> = (0..places.len()).map(candidates).collect();
    let lost = (0..places.len())
        .find_map(|p| places[p].as_ref().filter(|_| all[p].is_empty()).map(|place| (p, place)));
    match lost {
        Some((p, place)) => Err(nothing_at(scope, structure, p, &line.image(place))),
        None => Ok(all),
    }
}

fn partner([a, b]: [usize; 2], point: usize) -> Option<usize> {
    match point {
        _ if point == a => Some(b),
        _ if point == b => Some(a),
        _ => None,
    }
}

/// The points that are drawn where the mirror image of each is; none for one that is not drawn.
fn at_images(scope: &Scope, structure: &Structure, line: &Line, places: &Places) -> Vec<Vec<usize>> {
    let samples = scope.samples();
    let drawn: Vec<Option<Vec<[f64; 2]>>> =
        places.iter().map(|place| place.as_ref().map(|place| sampled(&samples, place))).collect();
    let there = |p: usize, place: &[Series; 2]| -> Vec<usize> {
        let image = sampled(&samples, &line.image(place));
        let same =
            |&q: &usize| akin(structure, p, q) && drawn[q].as_ref().is_some_and(|other| agree(&image, other));
        (0..places.len()).filter(same).collect()
    };
    let images = |(p, place): (usize, &Option<[Series; 2]>)| place.as_ref().map(|place| there(p, place));
    places.iter().enumerate().map(|place| images(place).unwrap_or_default()).collect()
}

/// Whether both belong to bodies, both are particles, or both are fixed points.
fn akin(structure: &Structure, p: usize, q: usize) -> bool {
    let kind =
        |point: usize| (structure.points[point].on.is_empty(), structure.points[point].ground.is_some());
    kind(p) == kind(q)
}

fn nothing_at(scope: &Scope, structure: &Structure, point: usize, place: &[Series; 2]) -> syn::Error {
    let names = ParameterNames::new(&scope.description.fields, scope.constants.definitions());
    let point = &structure.points[point];
    let [x, y] = place.each_ref().map(|c| c.text(&names));
    let text =
        format!("point `{}` has no mirror image: no point lies at ({x}, {y}) in the figure", point.name);
    syn::Error::new(point.span, text)
}

/// Backtracking over involutions that keep which points share a bar.
struct Search<'a> {
    structure: &'a Structure,
    candidates: &'a [Vec<usize>],
    found: Vec<Vec<usize>>,
    tries: usize,
}

impl Search<'_> {
    fn extend(&mut self, images: Vec<Option<usize>>) {
        if self.found.len() > 1 || self.tries > TRIES {
            return;
        }
        let open = (0..images.len()).filter(|&p| images[p].is_none());
        let choices = open.map(|p| (p, self.choices(&images, p)));
        let Some((point, choices)) = choices.min_by_key(|(_, choices)| choices.len()) else {
            return self.found.push(images.into_iter().flatten().collect());
        };
        for image in choices {
            self.tries += 1;
            let mut next = images.clone();
            next[point] = Some(image);
            next[image] = Some(point);
            self.extend(next);
        }
    }

    fn choices(&self, images: &[Option<usize>], point: usize) -> Vec<usize> {
        let fits = |&&image: &&usize| {
            let free = image == point || images[image].is_none() && self.candidates[image].contains(&point);
            let joined = |(other, other_image): (usize, &Option<usize>)| {
                other_image.is_none_or(|i| self.shared(point, other) == self.shared(image, i))
            };
            free && images.iter().enumerate().all(joined)
        };
        self.candidates[point].iter().filter(fits).copied().collect()
    }

    fn shared(&self, a: usize, b: usize) -> usize {
        let on = |point: usize| self.structure.points[point].on.iter().map(|(body, _)| *body);
        on(a).filter(|body| on(b).any(|other| other == *body)).count()
    }
}
