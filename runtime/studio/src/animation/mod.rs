//! A motion as a page that plays it, one HTML file that needs nothing beside itself; or as a
//! picture that moves.
//!
//! - `geometry`, `rounds`: what moves, and where contacts act; `quantities`: what is drawn over
//!   time;
//! - `sampling`: the motion as cubics, few and close; `rounding`: as whole numbers;
//! - `scenery`: what stands still, and what happens; `motion`: all of it as the page reads it;
//! - `page/`: the page's style and scripts;
//! - [`live`]: sliders beside it, and the engine that runs it again; `moving_picture`: the motion
//!   as an SVG, or modes of vibration.

mod geometry;
pub mod live;
mod motion;
mod moving_picture;
mod place;
mod quantities;
mod rounding;
mod rounds;
mod sampling;
mod scenery;
#[cfg(test)]
mod tests;

use crate::html;
use crate::picture::shown;
use crate::registry::{MotionError, Units};
use liftoff::Trajectory;
use motion::Motion;
use serde::Serialize;

pub use moving_picture::{ModeShape, mode_shapes, moving_picture};

const STYLE: &str = concat!(
    include_str!("page/layout.css"),
    include_str!("page/controls.css"),
    include_str!("page/stage.css"),
    include_str!("page/graphs.css"),
    include_str!("page/print.css"),
);

const BODY: &str = include_str!("page/body.html");

/// Each of these sees what those before it declare, and the motion that is played.
const SCRIPTS: &[&str] = &[
    include_str!("page/motion.js"),
    include_str!("page/draw.js"),
    include_str!("page/numbers.js"),
    include_str!("page/view.js"),
    include_str!("page/scenery.js"),
    include_str!("page/bodies.js"),
    include_str!("page/forces.js"),
    include_str!("page/trails.js"),
    include_str!("page/clock.js"),
    include_str!("page/scrubber.js"),
    include_str!("page/graph.js"),
    include_str!("page/panels.js"),
    include_str!("page/events.js"),
    include_str!("page/gestures.js"),
    include_str!("page/keys.js"),
    include_str!("page/main.js"),
];

/// Plays motions.
const HOST: &str = include_str!("page/host.js");

/// What a page tells of a run beside its motion.
#[derive(Clone, Copy, Debug, Default)]
pub struct About<'a> {
    /// The page's heading: the model's name, say.
    pub title: &'a str,
    /// What it is, in a line.
    pub summary: &'a str,
    /// Values of the parameters.
    pub parameters: &'a [(String, f64)],
    /// Expressions to draw beside coordinates, reactions and energies.
    pub outputs: &'a [String],
    /// Why the run stopped short, if it did.
    pub stopped: Option<&'a str>,
}

/// The page of a motion: it plays, scrubs and steps it, with contacts, reactions, graphs and
/// events.
///
/// # Errors
/// An output that is no expression of the model.
///
/// ```
/// use liftoff_studio::animation::{About, page};
/// use liftoff::prelude::*;
/// use liftoff_studio::run_spec::RunSpec;
///
/// /// A bar that swings.
/// #[derive(BarSystem)]
/// #[gravity(g)]
/// #[bar(OA, mass = m, length = l)]
/// #[pin(O = (0, 0))]
/// #[figure(A = (0, -l))]
/// #[coordinate(phi = angle(OA), from = down)]
/// struct SwingingBar {
///     m: f64,
///     l: f64,
///     g: f64,
/// }
///
/// let models = liftoff_studio::models![SwingingBar];
/// let spec = RunSpec::with(&[("m", 1.0), ("l", 1.0), ("g", 9.81)]).start(&[("phi", 1.0)]).until("t = 3");
/// let record = models.find("swinging-bar")?.run(&spec)?;
/// let about = About { title: "A bar that swings", outputs: &["fz(O)".to_owned()], ..About::default() };
/// assert!(page(&record, &about).is_err_and(|error| error.to_string().contains("fz")));
/// let html = page(&record, &About { outputs: &[], ..about })?;
/// assert!(html.starts_with("<!doctype html>"));
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
pub fn page(record: &Trajectory, about: &About) -> Result<String, MotionError> {
    let motion = Motion::from_run(record, about)?;
    Ok(html::page(about.title, STYLE, &body(&head(record, about), &motion.json())))
}

/// The page of no motion yet: in a frame of another page it plays what [`played`] gives, as often
/// as one is posted to it.
pub fn empty_page() -> String {
    html::page("Motion", STYLE, &body("", "null"))
}

/// A motion and what is told of it, for a page that is shown already: serialised, it is posted to
/// that.
#[derive(Serialize)]
pub struct Played {
    head: String,
    motion: Motion,
}

/// What a page plays next.
///
/// # Errors
/// As [`page`].
pub fn played(record: &Trajectory, about: &About) -> Result<Played, MotionError> {
    Ok(Played { head: head(record, about), motion: Motion::from_run(record, about)? })
}

fn body(head: &str, data: &str) -> String {
    let scripts = SCRIPTS.concat();
    format!(
        "<header>\n{head}</header>\n{BODY}<script type=\"application/json\" id=motion>{data}</script>\n<script>\n\"use strict\";\n\
         (() => {{\nfunction play(motion, signal, earlier) {{\n{scripts}}}\n{HOST}}})();\n</script>\n"
    )
}

/// What stands above the motion.
fn head(record: &Trajectory, about: &About) -> String {
    let stopped = about.stopped.map_or(String::new(), |why| {
        format!("<p class=stopped role=status>The run stopped short: {}</p>\n", html::escaped(why))
    });
    format!(
        "<h1>{}</h1>\n<p>{}</p>\n<p class=parameters>{}</p>\n{stopped}",
        html::escaped(about.title),
        prose(about.summary),
        html::escaped(&parameters(record, about.parameters)),
    )
}

/// A line of documentation: what stands between backticks is code.
fn prose(text: &str) -> String {
    let parts = text.split('`').map(html::escaped).enumerate();
    parts.map(|(i, part)| if i % 2 == 1 { format!("<code>{part}</code>") } else { part }).collect()
}

/// Values with units: `m₁ = 0.5 kg`.
fn parameters(record: &Trajectory, values: &[(String, f64)]) -> String {
    let units = Units::from_layout(record.layout());
    let short = |value: f64| -> f64 { format!("{value:.5e}").parse().unwrap_or(value) };
    let all = values.iter().map(|(name, value)| {
        let unit = units.unit(name).filter(|unit| !unit.is_empty()).map(|unit| format!(" {unit}"));
        format!("{} = {}{}", shown(name), short(*value), unit.unwrap_or_default())
    });
    all.collect::<Vec<String>>().join(", ")
}
