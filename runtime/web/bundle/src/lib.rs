//! The page of `liftoff-web` as one file that needs nothing beside itself: no server, no network.
//!
//! The engine is in it compressed, as text; so are the editor, the scripts and the declarations to start from.

use core::fmt;
use liftoff_studio::animation::empty_page;
use liftoff_studio::animation::live::{self, Engine, Packed, compressed};
use liftoff_studio::html::{escaped, page};
use liftoff_web::{State, answer};
use serde_json::json;
use std::io;
use std::path::{Path, PathBuf};
use std::process::Command;

const EDITOR: &str = include_str!("../../page/editor/codemirror.min.js");
const BODY: &str = include_str!("../../page/index.html");
const STYLE: &str = include_str!("../../page/style.css");
const APP: &str = include_str!("../../page/app.js");

/// Declarations to start from.
const GALLERY: [(&str, &str); 8] = [
    ("Four bars on a floor (Fig. 1b)", include_str!("../../gallery/fig_1b.rs")),
    ("Two bars over a gap (Fig. 1a)", include_str!("../../gallery/fig_1a.rs")),
    ("Ladder", include_str!("../../gallery/ladder.rs")),
    ("Double pendulum", include_str!("../../gallery/double_pendulum.rs")),
    ("Four-bar linkage", include_str!("../../gallery/four_bar.rs")),
    ("Bouncing bar", include_str!("../../gallery/bouncing_bar.rs")),
    ("Stick and slip", include_str!("../../gallery/belt.rs")),
    ("Blank: one bar", include_str!("../../gallery/blank.rs")),
];

/// The declarations that a reader can start from, by their names.
pub fn gallery() -> &'static [(&'static str, &'static str)] {
    &GALLERY
}

/// Why there is no page.
#[derive(thiserror::Error, Debug)]
pub enum BundleError {
    /// A file cannot be read or written.
    #[error("{path}: {error}", path = path.display())]
    File {
        /// Which.
        path: PathBuf,
        /// Why.
        error: io::Error,
    },
    /// The engine does not compile.
    #[error("the engine does not compile; it needs `rustup target add wasm32-unknown-unknown`")]
    Build,
}

/// How large the parts are, bytes.
#[derive(Clone, Copy, Debug)]
pub struct Sizes {
    /// The engine.
    pub engine: usize,
    /// The page.
    pub page: usize,
    /// The page as servers send it.
    pub compressed: usize,
}

impl fmt::Display for Sizes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let kilo = |bytes: usize| bytes / 1000;
        let [engine, page, compressed] = [self.engine, self.page, self.compressed].map(kilo);
        write!(f, "{page} kB, {compressed} kB compressed; the engine {engine} kB")
    }
}

/// Compiles the engine; where it lies.
///
/// # Errors
/// It does not compile.
pub fn build() -> Result<PathBuf, BundleError> {
    let target = "wasm32-unknown-unknown";
    let folder = std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| "target".into(), PathBuf::from);
    let built = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()))
        .args(["build", "-p", "liftoff-web", "--lib", "--profile", "web", "--target", target])
        // Those of this machine are no flags of that one.
        .env("RUSTFLAGS", "")
        .status();
    match built {
        Ok(status) if status.success() => Ok(folder.join(target).join("web/liftoff_web.wasm")),
        _ => Err(BundleError::Build),
    }
}

/// Writes the page with an engine.
///
/// # Errors
/// A file cannot be read or written.
pub fn bundle(engine: &Path, out: &Path) -> Result<Sizes, BundleError> {
    let failed = |path: &Path| {
        let path = path.to_owned();
        |error| BundleError::File { path, error }
    };
    let code = std::fs::read(engine).map_err(failed(engine))?;
    let packed = Packed::new(&code).map_err(failed(engine))?;
    let style = [live::STYLE, STYLE].concat();
    let html = page("Liftoff", &style, &body(&packed));
    liftoff_studio::file::write(out, &html).map_err(failed(out))?;
    let sent = compressed(html.as_bytes()).map_err(failed(out))?;
    Ok(Sizes { engine: code.len(), page: html.len(), compressed: sent.len() })
}

fn body(engine: &Packed) -> String {
    let texts: Vec<_> = GALLERY.iter().map(|(name, text)| json!({ "name": name, "text": text })).collect();
    let first = answer(&mut State::default(), &json!({ "ask": "derive", "text": GALLERY[0].1 }).to_string());
    // No text ends the element that it is in.
    let [texts, first] = [json!(texts).to_string(), first].map(|text| text.replace("</", "<\\/"));
    // The player may be there before the engine is read.
    let [listens, scripts @ ..] = live::SCRIPTS;
    let (scripts, engine) = (scripts.concat(), Engine::Within(engine).html());
    // Name, summary and values stand around the motion.
    let player = empty_page() + "<style>header { display: none; }</style>";
    let seen = BODY.replace("PLAYER", &escaped(&player));
    format!(
        "<script>\n\"use strict\";\n{listens}</script>\n{seen}{engine}\
         <script type=\"application/json\" id=texts>{texts}</script>\n\
         <script type=\"application/json\" id=first>{first}</script>\n\
         <script>\n\"use strict\";\n{scripts}begin();\n</script>\n\
         <script>{EDITOR}</script>\n\
         <script>\n\"use strict\";\n{APP}</script>\n"
    )
}
