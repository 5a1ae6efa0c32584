//! The nominal figure: a position for every point, from those given, the pins, the mirror, and, for
//! a bar of which only one point is known, by letting it hang along gravity.

mod draft;
mod frame;
mod reach;
mod sample;
mod settle;

use std::collections::BTreeSet;

use super::bodies::Structure;
use super::mirror_line::{self, Line};
use super::scope::Scope;
use super::{Body, Settled};
use crate::algebra::Series;
use draft::FigureDraft;

pub(super) use sample::{SAMPLES, Sample};
pub(super) use settle::{Heading, Verdict, unturned};

type Place = [Series; 2];

/// Distances below this are taken for zero: far above the rounding of a figure's numbers.
pub(crate) const NEAR: f64 = 1e-9;

/// By so much of a bar's length its figure may be wrong: numbers of two digits are drawn well
/// enough.
const ROUGH: f64 = 0.1;

/// A place for every point.
#[derive(Clone, Debug, Default)]
pub(super) struct Figure {
    /// As series.
    pub positions: Vec<Place>,
    /// In numbers, at samples of the parameters with which every body can be drawn; one at least.
    pub samples: Vec<Sample>,
    /// Image of each point, if there is a mirror.
    pub images: Option<Vec<usize>>,
    /// Points that only hang where nothing is known.
    pub assumed: Vec<bool>,
    /// What it settled, to be checked with a model's own parameters.
    pub settled: Vec<Settled>,
    demanded: BTreeSet<usize>,
}

impl Figure {
    /// Places every point, or reports why not.
    pub fn complete(scope: &mut Scope, structure: &Structure, line: Option<&Line>) -> Option<Self> {
        let mut draft = FigureDraft::given(scope, structure);
        let described = scope.description.mirror.is_none() || line.is_some();
        if !scope.joined || !scope.placed || !described {
            return None;
        }
        draft.spread(scope);
        let images = match line.map(|line| mirror_line::images(scope, structure, line, &draft.places)) {
            Some(Err(error)) => {
                scope.report.add(error);
                return None;
            }
            images => images.and_then(Result::ok),
        };
        draft.finish(scope, line.zip(images.as_deref()));
        draft.settle(scope, images)
    }

    /// The direction of a body, if its first two points are given; if not, that they must be is
    /// reported.
    pub fn direction(
        &mut self,
        scope: &mut Scope,
        structure: &Structure,
        body: usize,
        why: &str,
    ) -> Option<Heading> {
        let Body { from, to, .. } = structure.bodies[body];
        let given = [from, to].map(|point| self.demand(scope, structure, point, why));
        (given == [true, true]).then(|| self.heading(scope, structure, body))
    }

    /// Whether a point is given; if not, that it must be is reported, once.
    pub fn demand(&mut self, scope: &mut Scope, structure: &Structure, point: usize, why: &str) -> bool {
        if self.assumed[point] && self.demanded.insert(point) {
            needed(scope, structure, point, why);
        }
        !self.assumed[point]
    }
}

fn needed(scope: &mut Scope, structure: &Structure, point: usize, why: &str) {
    let point = &structure.points[point];
    scope
        .report
        .add_message(point.span, format!("point `{}` is needed in `#[figure(…)]`: {why}", point.name));
}

impl FigureDraft<'_> {
    fn settle(self, scope: &mut Scope, images: Option<Vec<usize>>) -> Option<Figure> {
        let positions: Vec<Place> = self.places.iter().flatten().cloned().collect();
        if positions.len() < self.places.len() {
            self.missing(scope);
            return None;
        }
        let samples = Figure::drawable(scope, self.structure, &positions);
        if samples.is_empty() {
            undrawable(scope, self.structure, &positions);
            return None;
        }
        let bodies = 0..self.structure.bodies.len();
        if bodies.clone().any(|body| self.misfit(body, &samples).is_some()) && !self.reaches(scope, &samples)
        {
            return None;
        }
        let closed = bodies.filter(|&body| self.closes(scope, body, &samples)).count();
        let (settled, demanded) = (Vec::new(), BTreeSet::new());
        let sound = closed == self.structure.bodies.len();
        sound.then_some(Figure { positions, samples, images, assumed: self.assumed, settled, demanded })
    }

    /// One point of each bar of which none is known, as long as it shares none with a bar told
    /// before.
    fn missing(&self, scope: &mut Scope) {
        let mut told: BTreeSet<usize> = BTreeSet::new();
        for (i, body) in self.structure.bodies.iter().enumerate() {
            let points: Vec<usize> = self.structure.members(i).iter().map(|(point, _)| *point).collect();
            let unknown = points.iter().any(|&point| self.places[point].is_none());
            if unknown && told.is_disjoint(&points.iter().copied().collect()) {
                let why = format!("nothing else says where {} `{}` is", body.kind(), body.name);
                needed(scope, self.structure, body.from, &why);
            }
            told.extend(points.into_iter().filter(|_| unknown));
        }
        for (point, _) in self.places.iter().enumerate().filter(|(_, place)| place.is_none()) {
            if self.structure.points[point].on.is_empty() {
                needed(scope, self.structure, point, "nothing else says where it is");
            }
        }
    }

    /// Whether a body that hangs where nothing is known closes its loop; if not, that it must be
    /// placed is reported.
    fn closes(&self, scope: &mut Scope, body: usize, samples: &[Sample]) -> bool {
        let bar = &self.structure.bodies[body];
        let open = samples.iter().any(|sample| {
            let length = sample.numbers.evaluate(&bar.length);
            (sample.drawn(self.structure, body) - length).abs() > NEAR * length
        });
        let open = open && (self.assumed[bar.from] || self.assumed[bar.to]);
        if open {
            let point = if self.assumed[bar.to] { bar.to } else { bar.from };
            needed(scope, self.structure, point, "there is more than one way to close the loop");
        }
        !open && self.fits(scope, body, samples)
    }

    /// How far apart the ends of a body that are given are drawn, and its length, where that is the
    /// same wrong multiple with all parameters that are tried. A figure may be drawn from rounded
    /// numbers.
    fn misfit(&self, body: usize, samples: &[Sample]) -> Option<[f64; 2]> {
        let bar = &self.structure.bodies[body];
        let given = !self.assumed[bar.from] && !self.assumed[bar.to];
        let lengths =
            |sample: &Sample| [sample.drawn(self.structure, body), sample.numbers.evaluate(&bar.length)];
        let ratio = |sample: &Sample| {
            let [drawn, length] = lengths(sample);
            drawn / length
        };
        let first = ratio(&samples[0]);
        let same = |sample: &Sample| (ratio(sample) - first).abs() <= NEAR * first;
        let is_wrong = given && (first - 1.0).abs() > ROUGH && samples.iter().all(same);
        is_wrong.then(|| lengths(&samples[0]))
    }

    /// Whether a body is drawn as long as it is; if not, that is reported with both lengths.
    fn fits(&self, scope: &mut Scope, body: usize, samples: &[Sample]) -> bool {
        let bar = &self.structure.bodies[body];
        let Some(lengths) = self.misfit(body, samples) else { return true };
        let [drawn, length] = lengths.map(shortened);
        let at = with_parameters(scope);
        let text = format!(
            "the figure draws {} `{}` {drawn} long, and its length is {length} ({at}); move `{}` or `{}` in \
             `#[figure(…)]`",
            bar.kind(),
            bar.name,
            self.structure.points[bar.from].name,
            self.structure.points[bar.to].name,
        );
        scope.report.add_message(bar.span, text);
        false
    }

    /// Whether bars reach as far as they must; if not, with any parameters that are tried, the loop
    /// is reported that lacks most.
    fn reaches(&self, scope: &mut Scope, samples: &[Sample]) -> bool {
        let open = samples.iter().map(|sample| reach::find_open_loop(self.structure, sample));
        let Some(Some(open)) = open.collect::<Option<Vec<_>>>().map(|open| open.into_iter().next()) else {
            return true;
        };
        let names: Vec<&str> = open.way.iter().map(|&point| &*self.structure.points[point].name).collect();
        let [distance, reach, lack] = [open.distance, open.reach, open.distance - open.reach].map(shortened);
        let at = with_parameters(scope);
        let text = format!(
            "the loop {} cannot close: `{}` and `{}` are {distance} apart, and the way between them is {reach} long \
             ({at}): it lacks {lack}",
            names.join("–"),
            names[0],
            names[names.len() - 1],
        );
        scope.report.add_message(self.structure.points[open.way[0]].span, text);
        false
    }
}

fn with_parameters(scope: &Scope) -> &'static str {
    let by_default = scope.description.values.iter().any(|known| known.value.is_some());
    if by_default { "with the values of the parameters" } else { "with parameters near 1" }
}

fn shortened(length: f64) -> f64 {
    (length * 1e4).round() / 1e4
}

/// What is wrong with the figure at the first sample, where none can be drawn.
fn undrawable(scope: &mut Scope, structure: &Structure, positions: &[Place]) {
    let sample = Sample::new(scope.nominal(), positions);
    for (body, bar) in structure.bodies.iter().enumerate() {
        if let Some(fault) = sample.fault(structure, body) {
            scope.report.add_message(bar.span, fault.text(bar.kind(), &bar.name));
        }
    }
}
