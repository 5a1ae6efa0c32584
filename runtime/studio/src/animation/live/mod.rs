//! Pages that run their model again: sliders for its parameters and start beside a motion, and the
//! engine that runs it within the page.
//!
//! - `engine`: the engine as text; `sliders`: what can be changed.
//! - `page/player.js`, `engine.js`, `worker.js`, `sliders.js`, `rerun.js`: what all such pages
//!   share; `live.js`: what begins a page of one model. The engine is `liftoff-web` as WebAssembly,
//!   packed and as text.

mod engine;
mod sliders;

pub use engine::{Engine, Packed, compressed};
pub use sliders::{Slider, Sliders};

use super::{self as animation, About};
use crate::html::{self, escaped};
use crate::registry::{Entry, MotionError};
use crate::run_spec::RunSpec;
use liftoff::Trajectory;
use serde_json::json;

/// The style of sliders.
pub const STYLE: &str = include_str!("page/live.css");

/// What runs in the page, the first before its player is there; each sees what those before it
/// declare.
pub const SCRIPTS: [&str; 4] = [
    include_str!("page/player.js"),
    include_str!("page/engine.js"),
    include_str!("page/sliders.js"),
    include_str!("page/rerun.js"),
];

/// What runs in a worker of its own.
pub const WORKER: &str = include_str!("page/worker.js");

const LIVE: &str = include_str!("page/live.js");

/// The player is all of the page.
const FRAMED: &str = "body { max-width: 96rem; padding: .5rem 0; } #sliders, body > p { margin: .5rem 1.25rem; }\n\
                      #player iframe { width: 100%; border: 0; }\n";

/// Makes the frame as high as the page in it, whatever the width.
pub const FIT: &str = "for (const frame of document.querySelectorAll('iframe')) frame.addEventListener('load', () => { \
    const page = frame.contentDocument.documentElement; \
    const fit = () => { frame.style.height = `${page.offsetHeight + 4}px`; }; \
    new ResizeObserver(fit).observe(page); fit(); });";

/// The page of a motion with sliders above it.
///
/// # Errors
/// As [`page`](animation::page).
pub fn page(
    model: &Entry,
    spec: &RunSpec,
    record: &Trajectory,
    about: &About,
    engine: Engine,
) -> Result<String, MotionError> {
    let body = section(model, spec, record, about, engine)?;
    Ok(html::page(about.title, &[STYLE, FRAMED].concat(), &body))
}

/// The motion of a run with sliders above it, as a part of a page that has [`STYLE`].
///
/// # Errors
/// As [`page`](animation::page).
pub fn section(
    model: &Entry,
    spec: &RunSpec,
    record: &Trajectory,
    about: &About,
    engine: Engine,
) -> Result<String, MotionError> {
    let Sliders { parameters, start } = Sliders::new(model, spec);
    let layout = model.layout();
    let described = json!({
        "text": format!("#[derive(BarSystem)]\n{}", layout.declaration), "spec": spec, "outputs": about.outputs,
        "parameters": parameters, "start": start,
    });
    // No text ends the element that it is in.
    let described = described.to_string().replace('<', "\\u003c");
    let player = escaped(&animation::page(record, about)?);
    // The player may be there before the rest is read.
    let [listens, scripts @ ..] = SCRIPTS;
    let scripts = [scripts.concat(), LIVE.to_owned(), FIT.to_owned()].concat();
    Ok(format!(
        "<script>\n\"use strict\";\n{listens}</script>\n\
         <form id=sliders autocomplete=off></form>\n\
         <p><span id=told role=status></span> <button id=stop type=button hidden>Stop</button></p>\n\
         <p id=wrong role=alert hidden></p>\n\
         <div id=player><iframe title=Motion srcdoc=\"{player}\"></iframe></div>\n\
         <script type=\"application/json\" id=described>{described}</script>\n{}\
         <script>\n\"use strict\";\n{scripts}</script>\n",
        engine.html()
    ))
}
