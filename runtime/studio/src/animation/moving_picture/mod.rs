//! A motion as one SVG that moves by itself: animations by SMIL, no script, nothing outside the
//! file, so that it plays where only pictures are allowed.
//!
//! - `timeline`: the times that are drawn, and when they are on the screen;
//! - `stage`: the model at these times, in pixels;
//! - `track`: values over time as `<animate>` elements;
//! - `standing`, `bodies`, `cones`, `contacts`, `names`, `words`: what is drawn, from back to
//!   front;
//! - `mode_shapes`: small motions about a position in place of a motion.

mod bodies;
mod cones;
mod contacts;
mod mode_shapes;
mod names;
mod stage;
mod standing;
mod timeline;
mod track;
mod words;

use super::About;
use crate::html::escaped;
use crate::registry::MotionError;
use contacts::Contacts;
use liftoff::Trajectory;
use stage::Stage;
use timeline::Timeline;

pub use mode_shapes::{ModeShape, mode_shapes};

/// Times that are drawn, at most and at least.
const FRAMES: [usize; 2] = [220, 24];

/// Bytes that a picture has at most, unless it has the fewest frames; a card for it takes some
/// more.
const LARGEST: usize = 145_000;

/// A motion as an SVG that plays it again and again: bodies, springs, threads, contacts with their
/// reactions, and the names of the events at their times, so many times `slower` than it is, or as
/// people can follow it. Between two frames everything moves along straight lines.
///
/// # Errors
/// A reaction that cannot be computed.
pub fn moving_picture(
    record: &Trajectory,
    about: &About,
    slower: Option<f64>,
) -> Result<String, MotionError> {
    let [mut frames, fewest] = FRAMES;
    loop {
        let svg = with_frames(record, about, Timeline::new(record, frames, slower))?;
        if svg.len() <= LARGEST || frames == fewest {
            return Ok(svg);
        }
        frames = (frames * LARGEST / svg.len() * 19 / 20).max(fewest);
    }
}

fn with_frames(record: &Trajectory, about: &About, timeline: Timeline) -> Result<String, MotionError> {
    let stage = Stage::new(record, timeline);
    let contacts = Contacts::from_run(record, &stage)?;
    let [width, height] = stage.size;
    Ok(format!(
        "<svg role=\"img\" aria-label=\"{label}\" width=\"{width:.0}\" height=\"{height:.0}\" \
         viewBox=\"0 0 {width:.0} {height:.0}\" xmlns=\"http://www.w3.org/2000/svg\" fill=\"none\" \
         stroke-linejoin=\"round\" stroke-linecap=\"round\" font-family=\"sans-serif\" {scale}>\n{scene}{words}</svg>\n",
        scale = stage.attributes(),
        label = escaped(&format!("{}: {}", about.title, about.summary)),
        scene = [
            standing::definitions(&stage),
            standing::drawn(&stage),
            bodies::threads(&stage, &contacts, record),
            bodies::springs(&stage, record),
            bodies::bodies(&stage),
            cones::drawn(&stage, record)?,
            contacts.drawn(&stage, record),
            bodies::points(&stage),
            names::drawn(&stage),
        ]
        .concat(),
        words = words::drawn(&stage, record, about),
    ))
}
