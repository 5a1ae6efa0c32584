//! The model at all frames, in pixels: x to the right, y down.

use super::timeline::Timeline;
use crate::plot::svg::plane::{Box2, Px};
use crate::registry::Configuration;
use liftoff::Trajectory;
use liftoff_core::model::geometry::Shape;

/// Width of the picture.
const WIDTH: f64 = 720.0;
/// The motion's least and greatest height.
const HEIGHT: [f64; 2] = [60.0, 330.0];
/// Free room round the motion: left and right, above, below.
const BESIDE: f64 = 52.0;
pub(super) const ABOVE: f64 = 72.0;
pub(super) const BELOW: f64 = 54.0;
/// Circles so many times larger than all else are seen in part.
const LARGE: f64 = 3.0;

/// The model at all frames.
pub(super) struct Stage {
    pub timeline: Timeline,
    pub frames: Vec<Configuration>,
    pub size: Px,
    scale: f64,
    origin: Px,
}

impl Stage {
    /// A scale by which all of the motion is seen.
    pub fn new(record: &Trajectory, timeline: Timeline) -> Self {
        let frames: Vec<_> = timeline.times.iter().map(|&t| Configuration::from_run(record, t)).collect();
        Self::seeing(seen(&frames), frames, timeline)
    }

    /// A scale by which this part of the plane is seen.
    pub fn seeing(seen: Box2, frames: Vec<Configuration>, timeline: Timeline) -> Self {
        let size = seen.size();
        let room = [WIDTH - 2.0 * BESIDE, HEIGHT[1]];
        let scales = [0, 1].map(|i| if size[i] > 0.0 { room[i] / size[i] } else { f64::INFINITY });
        let scale = scales[0].min(scales[1]);
        let scale = if scale.is_finite() { scale } else { room[0] };
        let high = (scale * size[1]).max(HEIGHT[0]);
        let centre = seen.centre();
        let middle = [0.5 * WIDTH, ABOVE + 0.5 * high];
        let origin = [middle[0] - scale * centre[0], middle[1] + scale * centre[1]];
        Self { timeline, frames, size: [WIDTH, (ABOVE + high + BELOW).ceil()], scale, origin }
    }

    /// Where a place of the model is drawn.
    pub fn px(&self, [x, y]: [f64; 2]) -> Px {
        [self.origin[0] + self.scale * x, self.origin[1] - self.scale * y]
    }

    /// What turns pixels and seconds of the picture back into those of the run.
    pub fn attributes(&self) -> String {
        let ([x, y], pace) = (self.origin, self.timeline.pace);
        format!("data-scale=\"{}\" data-x=\"{x}\" data-y=\"{y}\" data-pace=\"{pace}\"", self.scale)
    }

    /// A length in pixels.
    pub fn long(&self, length: f64) -> f64 {
        self.scale * length
    }

    /// Where points are at a frame.
    pub fn places(&self, frame: &Configuration, points: &[usize]) -> Vec<Px> {
        points.iter().map(|&point| self.px(frame.points[point])).collect()
    }
}

/// Round all points at all times, and what stands still and has a place.
pub(super) fn seen(frames: &[Configuration]) -> Box2 {
    let nothing = Box2 { least: [0.0; 2], most: [1.0; 2] };
    let start = &frames[0];
    let fixtures = start.geometry().fixtures;
    let fixed = fixtures.iter().filter(|fixture| !matches!(fixture.shape, Shape::Line { .. }));
    let fixed = fixed.map(|fixture| start.position(fixture.at));
    let moving = frames.iter().flat_map(Configuration::places);
    let finite = |at: &Px| at.iter().all(|x| x.is_finite());
    let near = Box2::round(moving.chain(fixed).filter(finite)).unwrap_or(nothing);
    let size = near.size()[0].max(near.size()[1]);
    let circles = fixtures.iter().filter_map(|fixture| {
        let Shape::Circle { radius, .. } = fixture.shape else { return None };
        let (at, radius) = (start.position(fixture.at), start.number(radius));
        (radius < LARGE * size).then(|| Box2 { least: at, most: at }.wider(radius))
    });
    circles.fold(near, Box2::with)
}
