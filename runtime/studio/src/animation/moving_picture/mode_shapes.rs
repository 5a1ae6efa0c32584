//! Modes of vibration, one below the other, each swinging about the position at rest, which is
//! drawn pale:
//!
//! ```text
//! q(θ) = q₀ + a Re(v e^{iθ}),   θ from 0 to 2π
//! ```
//!
//! a is such that the points move by a part of the model's size, and nothing turns far.

use core::f64::consts::TAU;

use super::bodies;
use super::stage::{self, Stage};
use super::standing;
use super::timeline::Timeline;
use super::track::number;
use crate::html::escaped;
use crate::plot::Colour;
use crate::plot::svg::Fill;
use crate::plot::svg::plane::{Box2, distance};
use crate::registry::{Configuration, Entry, MotionError};
use crate::run_spec::Values;
use liftoff_core::system::Model;

/// Positions of a cycle, and its seconds on the screen.
const FRAMES: usize = 24;
const CYCLE: f64 = 2.0;
/// So far the points move, parts of the model's size, and so far coordinates that are angles, rad.
const REACH: f64 = 0.12;
const TURN: f64 = 0.4;
/// The displacement by which it is seen how far the points move.
const SMALL: f64 = 1e-5;

/// A mode of vibration.
#[derive(Clone, Debug)]
pub struct ModeShape {
    /// What is said of it, in a line.
    pub words: String,
    /// Real and imaginary part of v for each coordinate.
    pub shape: Vec<[f64; 2]>,
}

/// The modes about a position as one SVG in which each of them moves.
///
/// # Errors
/// Parameters that the model does not have, or that are not given.
pub fn mode_shapes(
    entry: &Entry,
    parameters: &Values,
    position: &[f64],
    modes: &[ModeShape],
) -> Result<String, MotionError> {
    let model = entry.model(parameters)?;
    let rest = configure(&model, position);
    let cycle = |mode: &ModeShape| -> Vec<Configuration> {
        let reach = reach(&model, &rest, mode);
        let turned = |i: usize| TAU * i as f64 / FRAMES as f64;
        (0..=FRAMES).map(|i| configure(&model, &moved(position, mode, reach, turned(i)))).collect()
    };
    let cycles: Vec<Vec<Configuration>> = modes.iter().map(cycle).collect();
    let all: Vec<Configuration> = cycles.iter().flatten().chain([&rest]).cloned().collect();
    let seen = stage::seen(&all);
    let still = Stage::seeing(seen, vec![rest], Timeline::cycle(1, CYCLE));
    let mut text = standing::definitions(&still);
    for (i, (mode, cycle)) in modes.iter().zip(cycles).enumerate() {
        let moving = Stage::seeing(seen, cycle, Timeline::cycle(FRAMES, CYCLE));
        let down = number(i as f64 * still.size[1]);
        text +=
            &format!("<g transform=\"translate(0 {down})\">\n{}</g>\n", panel(&still, &moving, &mode.words));
    }
    let [width, height] = [still.size[0], still.size[1] * modes.len() as f64];
    let label = escaped(&format!("{}: modes of vibration", entry.name()));
    Ok(format!(
        "<svg role=\"img\" aria-label=\"{label}\" width=\"{width:.0}\" height=\"{height:.0}\" viewBox=\"0 0 {width:.0} {height:.0}\" \
         xmlns=\"http://www.w3.org/2000/svg\" fill=\"none\" stroke-linejoin=\"round\" stroke-linecap=\"round\" \
         font-family=\"sans-serif\" {}>\n{text}</svg>\n",
        still.attributes()
    ))
}

fn panel(still: &Stage, moving: &Stage, words: &str) -> String {
    format!(
        "<text x=\"20\" y=\"28\" font-size=\"16\"{}>{}</text>\n{}<g opacity=\"0.25\">\n{}{}</g>\n{}{}{}",
        Fill::Colour(Colour::Black),
        escaped(words),
        standing::drawn(still),
        bodies::bodies(still),
        bodies::points(still),
        bodies::ties(moving),
        bodies::bodies(moving),
        bodies::points(moving),
    )
}

/// q(θ).
fn moved(position: &[f64], mode: &ModeShape, reach: f64, angle: f64) -> Vec<f64> {
    let (sin, cos) = angle.sin_cos();
    position.iter().zip(&mode.shape).map(|(q, [re, im])| q + reach * (re * cos - im * sin)).collect()
}

/// a.
fn reach(model: &Model, rest: &Configuration, mode: &ModeShape) -> f64 {
    let coordinates = rest.layout.coordinates;
    let position = &rest.state[..coordinates.len()];
    let largest = |of_angles: bool| {
        let parts = mode.shape.iter().zip(coordinates).filter(|(_, c)| c.is_angle == of_angles);
        parts.map(|([re, im], _)| re.hypot(*im)).fold(0.0, f64::max)
    };
    let (turn, most) = (largest(true), largest(true).max(largest(false)));
    let small = SMALL / most;
    let steps = [0.0, 0.25 * TAU].into_iter().flat_map(|angle| {
        let near = configure(model, &moved(position, mode, small, angle));
        near.points.into_iter().zip(&rest.points).map(|(a, b)| distance(a, *b) / small).collect::<Vec<_>>()
    });
    let size = Box2::round(rest.places()).map_or(0.0, |area| area.size()[0].max(area.size()[1]));
    let size = if size > 0.0 { size } else { 1.0 };
    let reach = (REACH * size / steps.fold(0.0, f64::max)).min(TURN / turn);
    if reach.is_finite() { reach } else { 0.0 }
}

fn configure(model: &Model, coordinates: &[f64]) -> Configuration {
    let at_rest = [coordinates, &vec![0.0; coordinates.len()]].concat();
    Configuration::new(model, &model.layout().state_at(&at_rest, 0.0))
}
