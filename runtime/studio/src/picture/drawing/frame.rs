//! From the model's lengths to pixels.

use super::plane::{Box2, Px, towards};
use crate::picture::geometry::Geometry;
use liftoff::model::Shape;

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
    pub fn of(geometry: &Geometry) -> Self {
        let seen = seen(geometry).unwrap_or(Box2 { least: [0.0; 2], most: [1.0; 2] });
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
fn seen(geometry: &Geometry) -> Option<Box2> {
    let configuration = geometry.configuration;
    let points = configuration.points.iter().copied();
    let fixed = configuration
        .scenery
        .iter()
        .filter(|thing| !matches!(thing.shape, Shape::Line { .. } | Shape::Guide { .. }));
    let near = Box2::round(points.chain(fixed.map(|thing| thing.at)).chain(feet(geometry)))?;
    let size = near.size()[0].max(near.size()[1]);
    let circles = configuration.scenery.iter().filter_map(|thing| match thing.shape {
        Shape::Circle { radius, .. } if radius < LARGE * size || size == 0.0 => {
            Some(Box2 { least: thing.at, most: thing.at }.wider(radius))
        }
        _ => None,
    });
    Some(circles.fold(near, Box2::with))
}

/// The points of lines that are nearest to what they support.
fn feet<'a>(geometry: &'a Geometry) -> impl Iterator<Item = Px> + 'a {
    geometry.lines().map(|line| {
        let [x, y] = towards(line.angle);
        let ahead = [x, -y];
        let from = [line.point[0] - line.through[0], line.point[1] - line.through[1]];
        let step = from[0] * ahead[0] + from[1] * ahead[1];
        [line.through[0] + step * ahead[0], line.through[1] + step * ahead[1]]
    })
}
