//! Coordinates that are positions: arrows from the axis to the point, below and left of the model.

use super::Draft;
use super::canvas::{HELP, MEASURE};
use super::plane::{Px, add, along, distance, left_of, middle, minus, unit};
use super::script::Script;
use liftoff_core::model::geometry::Reading;

/// Distance of the first arrow from the model, and of each further one.
const OFFSET: f64 = 20.0;
const FURTHER: f64 = 26.0;
/// Arrows shorter than this are drawn as a sense only.
const SHORT: f64 = 16.0;
/// Length of a sense, and how far from its point it may stand.
const SENSE: f64 = 30.0;
const BESIDE: [f64; 4] = [14.0, -14.0, 24.0, -24.0];

impl Draft<'_> {
    pub(super) fn positions(&mut self) {
        let Some(drawn) = self.canvas.extent() else { return };
        let mut taken = [0_u32; 2];
        let coordinates = self.configuration.layout.coordinates;
        for (coordinate, reading) in coordinates.iter().zip(self.geometry.readings) {
            if let Reading::Position { point, axis, sign } = *reading {
                let out = OFFSET + FURTHER * f64::from(taken[axis]);
                taken[axis] += 1;
                let level = if axis == 0 { drawn.most[1] + out } else { drawn.least[0] - out };
                self.position(coordinate.name, point, axis, f64::from(sign), level);
            }
        }
    }

    /// Along axis 0 at the height `level`, along axis 1 at the side `level`.
    fn position(&mut self, name: &str, point: usize, axis: usize, sign: f64, level: f64) {
        let on_level = |along: f64| if axis == 0 { [along, level] } else { [level, along] };
        let at = self.map_point(point);
        let origin = self.frame.px([0.0, 0.0]);
        let [from, to] = [on_level(origin[axis]), on_level(at[axis])];
        let side = if axis == 0 { [0.0, 1.0] } else { [-1.0, 0.0] };
        if distance(from, to) < SHORT {
            return self.sense(name, at, axis, sign);
        }
        self.canvas.line(vec![at, overshoot(to, axis)], HELP);
        self.canvas.line(vec![add(from, side.map(|x| -8.0 * x)), overshoot(from, axis)], HELP);
        self.canvas.arrow(vec![from, to], MEASURE, false);
        self.measured(Script::quantity(name), middle(from, to), 3.0, side);
    }

    /// An arrow beside the point that shows the coordinate's sense.
    fn sense(&mut self, name: &str, at: Px, axis: usize, sign: f64) {
        let ahead = if axis == 0 { [sign, 0.0] } else { [0.0, -sign] };
        let across = left_of(ahead);
        let arrow = |out: f64| [0.0, SENSE].map(|x| along(along(at, across, out), ahead, x));
        let free = BESIDE.into_iter().min_by_key(|&out| self.canvas.crossings(arrow(out)));
        let [from, tip] = arrow(free.unwrap_or(BESIDE[0]));
        self.canvas.line(vec![at, along(from, unit(minus(from, at)), 4.0)], HELP);
        self.canvas.arrow(vec![from, tip], MEASURE, false);
        self.measured(Script::quantity(name), tip, 3.0, ahead);
    }
}

/// A little beyond the arrow.
fn overshoot([x, y]: Px, axis: usize) -> Px {
    if axis == 0 { [x, y + 4.0] } else { [x - 4.0, y] }
}
