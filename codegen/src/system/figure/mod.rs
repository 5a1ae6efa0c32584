//! The nominal figure: a position for every point, from those given, the pins, the mirror, and, for a bar of
//! which only one point is known, by letting it hang along gravity.

mod draft;
mod frame;

use std::collections::BTreeSet;

use super::bodies::Scene;
use super::mirror::{Line, search};
use super::scope::Scope;
use super::value::Numbers;
use crate::algebra::Series;
use draft::Draft;

type Place = [Series; 2];

/// Distances below this are taken for zero: far above the rounding of a figure's numbers.
pub(super) const NEAR: f64 = 1e-9;

/// A place for every point.
#[derive(Clone, Debug)]
pub(super) struct Figure {
    /// As series.
    pub positions: Vec<Place>,
    /// With every parameter 1.
    pub numbers: Vec<[f64; 2]>,
    /// Image of each point, if there is a mirror.
    pub images: Option<Vec<usize>>,
    /// Points that only hang where nothing is known.
    pub assumed: Vec<bool>,
    demanded: BTreeSet<usize>,
}

impl Figure {
    /// Places every point, or reports why not.
    pub fn complete(scope: &mut Scope, scene: &Scene, line: Option<&Line>) -> Option<Self> {
        let mut draft = Draft::given(scope, scene);
        let described = scope.description.mirror.is_none() || line.is_some();
        if !scope.joined || !scope.placed || !described {
            return None;
        }
        draft.spread(scope);
        let images = match line.map(|line| search::images(scope, scene, line, &draft.places)) {
            Some(Err(error)) => {
                scope.report.add(error);
                return None;
            }
            images => images.and_then(Result::ok),
        };
        draft.finish(scope, line.zip(images.as_deref()));
        draft.settle(scope, images)
    }

    /// The direction of a body, if its first two points are given; if not, that they must be is reported.
    pub fn direction(&mut self, scope: &mut Scope, scene: &Scene, body: usize, why: &str) -> Option<f64> {
        let [from, to] = [scene.bodies[body].from, scene.bodies[body].to];
        let given = [from, to].map(|point| self.demand(scope, scene, point, why));
        (given == [true, true]).then(|| turned(scene, body, &self.numbers, &scope.nominal()))
    }

    /// Whether a point is given; if not, that it must be is reported, once.
    pub fn demand(&mut self, scope: &mut Scope, scene: &Scene, point: usize, why: &str) -> bool {
        if self.assumed[point] && self.demanded.insert(point) {
            needed(scope, scene, point, why);
        }
        !self.assumed[point]
    }
}

/// The direction of a body's frame: of its first two points, less their direction in the frame.
pub(super) fn turned(scene: &Scene, body: usize, drawn: &[[f64; 2]], numbers: &Numbers) -> f64 {
    let towards = |[a, b]: [[f64; 2]; 2]| (b[1] - a[1]).atan2(b[0] - a[0]);
    let direction = towards([drawn[scene.bodies[body].from], drawn[scene.bodies[body].to]]);
    match (scene.is_bar(body), scene.members(body)) {
        (false, [(_, a), (_, b), ..]) => direction - towards([numbers.pair(a), numbers.pair(b)]),
        _ => direction,
    }
}

fn needed(scope: &mut Scope, scene: &Scene, point: usize, why: &str) {
    let point = &scene.points[point];
    scope.report.at(point.span, format!("point `{}` is needed in `#[figure(…)]`: {why}", point.name));
}

impl Draft<'_> {
    fn settle(self, scope: &mut Scope, images: Option<Vec<usize>>) -> Option<Figure> {
        let positions: Vec<Place> = self.places.iter().flatten().cloned().collect();
        if positions.len() < self.places.len() {
            self.missing(scope);
            return None;
        }
        let nominal = scope.nominal();
        let numbers: Vec<[f64; 2]> = positions.iter().map(|place| nominal.pair(place)).collect();
        let sound = (0..self.scene.bodies.len()).filter(|&body| self.check(scope, body, &numbers)).count();
        let figure = Figure { positions, numbers, images, assumed: self.assumed, demanded: BTreeSet::new() };
        (sound == self.scene.bodies.len()).then_some(figure)
    }

    /// One point of each bar of which none is known, as long as it shares none with a bar told before.
    fn missing(&self, scope: &mut Scope) {
        let mut told: BTreeSet<usize> = BTreeSet::new();
        for (i, body) in self.scene.bodies.iter().enumerate() {
            let points: Vec<usize> = self.scene.members(i).iter().map(|(point, _)| *point).collect();
            let unknown = points.iter().any(|&point| self.places[point].is_none());
            if unknown && told.is_disjoint(&points.iter().copied().collect()) {
                let why = format!("nothing else says where bar `{}` is", body.name);
                needed(scope, self.scene, body.from, &why);
            }
            told.extend(points.into_iter().filter(|_| unknown));
        }
        for (point, _) in self.places.iter().enumerate().filter(|(_, place)| place.is_none()) {
            if self.scene.points[point].on.is_empty() {
                needed(scope, self.scene, point, "nothing else says where it is");
            }
        }
    }

    fn check(&self, scope: &mut Scope, body: usize, numbers: &[[f64; 2]]) -> bool {
        let bar = &self.scene.bodies[body];
        let [a, b] = [numbers[bar.from], numbers[bar.to]];
        let drawn = (b[0] - a[0]).hypot(b[1] - a[1]);
        let length = scope.nominal().of(&bar.length);
        let text = if !drawn.is_finite() {
            format!("the figure of bar `{}` is not a number with every parameter 1", bar.name)
        } else if drawn < NEAR {
            format!("both ends of bar `{}` are at one place in the figure with every parameter 1", bar.name)
        } else if (self.assumed[bar.from] || self.assumed[bar.to])
            && (drawn - length).abs() > NEAR * length.abs()
        {
            let point = if self.assumed[bar.to] { bar.to } else { bar.from };
            needed(scope, self.scene, point, "there is more than one way to close the loop");
            return false;
        } else if self.turned_over(scope, body, numbers) {
            format!(
                "the figure draws body `{}` turned over, as in a mirror; go round its points the other way",
                bar.name
            )
        } else {
            return true;
        };
        scope.report.at(bar.span, text);
        false
    }

    /// Whether three points of a body go round the other way than in its frame.
    fn turned_over(&self, scope: &Scope, body: usize, drawn: &[[f64; 2]]) -> bool {
        let nominal = scope.nominal();
        let members = self.scene.members(body);
        let area = |[a, b, c]: [[f64; 2]; 3]| (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        members.windows(3).any(|three| {
            let [own, there] = [
                area([0, 1, 2].map(|i| nominal.pair(&three[i].1))),
                area([0, 1, 2].map(|i| drawn[three[i].0])),
            ];
            own.abs() > NEAR && there.abs() > NEAR && own.signum() != there.signum()
        })
    }
}
