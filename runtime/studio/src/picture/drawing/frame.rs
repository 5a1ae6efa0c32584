//! From the model's lengths to pixels.

use super::plane::{Box2, Px, towards};
use crate::registry::Configuration;
use liftoff_core::model::geometry::Shape;

/// Pixels that the model may take at most.
const ROOM: Px = [400.0, 300.0];
/// Pixels that its longer side takes at least where the model is long one way only.
const LEAST: f64 = 1e-9;
/// Circles larger than so many times everything else are drawn in part.
const LARGE: f64 = 3.0;

/// A scale, and what is seen of the model.
pub(super) struct Frame {
    /// Pixels of a unit of length.
    scale: f64,
    /// Round the model's points, pixels.
    pub area: Box2,
}

impl Frame {
    /// The scale by which all of the model is seen.
    pub fn from_configuration(configuration: &Configuration) -> Self {
        let seen = seen(configuration).unwrap_or(Box2 { least: [0.0; 2], most: [1.0; 2] });
        let size = seen.size();
        let longest = size[0].max(size[1]);
        let size = if longest > 0.0 { size } else { [1.0; 2] };
        let scale = (0..2).map(|i| ROOM[i] / size[i].max(longest * LEAST)).fold(f64::INFINITY, f64::min);
        let [left, bottom] = seen.least.map(|x| x * scale);
        let [right, top] = seen.most.map(|x| x * scale);
        Self { scale, area: Box2 { least: [left, -top], most: [right, -bottom] } }
    }

    /// Where a place of the model is drawn.
    pub fn px(&self, [x, y]: [f64; 2]) -> Px {
        [x * self.scale, -y * self.scale]
    }

    /// A length in pixels.
    pub fn long(&self, length: f64) -> f64 {
        length * self.scale
    }
}

/// Round the points, what they are supported by, and circles that are not much larger.
fn seen(configuration: &Configuration) -> Option<Box2> {
    let fixtures = configuration.geometry().fixtures;
    let points = configuration.places();
    let fixed = fixtures.iter().filter(|fixture| !matches!(fixture.shape, Shape::Line { .. }));
    let fixed = fixed.map(|fixture| configuration.position(fixture.at));
    let near = Box2::round(points.chain(fixed).chain(feet(configuration)))?;
    let size = near.size()[0].max(near.size()[1]);
    let circles = fixtures.iter().filter_map(|fixture| {
        let Shape::Circle { radius, .. } = fixture.shape else { return None };
        let (at, radius) = (configuration.position(fixture.at), configuration.number(radius));
        let shown = radius < LARGE * size || size == 0.0;
        shown.then(|| Box2 { least: at, most: at }.wider(radius))
    });
    Some(circles.fold(near, Box2::with))
}

/// The points of lines that are nearest to what they support.
fn feet(configuration: &Configuration) -> impl Iterator<Item = Px> + '_ {
    let geometry = configuration.geometry();
    geometry.fixtures.iter().filter_map(|fixture| {
        let Shape::Line { angle, solid: true } = fixture.shape else { return None };
        let [x, y] = towards(configuration.number(angle));
        let (ahead, through) = ([x, -y], configuration.position(fixture.at));
        let point = configuration.touched(geometry.push(fixture.name)?);
        let from = [point[0] - through[0], point[1] - through[1]];
        let step = from[0] * ahead[0] + from[1] * ahead[1];
        Some([through[0] + step * ahead[0], through[1] + step * ahead[1]])
    })
}
