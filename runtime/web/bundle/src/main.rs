//! Puts the page together: `cargo run --release -p liftoff-web-bundle -- OUT.html [ENGINE.wasm]`.
//!
//! Without an engine it is built first, which needs the target `wasm32-unknown-unknown`.

use liftoff_web_bundle::{build, bundle};
use std::path::PathBuf;
use std::process::ExitCode;

fn main() -> ExitCode {
    let mut words = std::env::args_os().skip(1).map(PathBuf::from);
    let out = words.next().unwrap_or_else(|| "target/liftoff/web/index.html".into());
    let made = words.next().map_or_else(build, Ok).and_then(|engine| bundle(&engine, &out));
    match made {
        Ok(sizes) => {
            println!("{}: {sizes}", out.display());
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}
