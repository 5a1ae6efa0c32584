//! Every page that the project makes: those named by `LIFTOFF_PAGES` (files or folders, joined as
//! in `PATH`), by default all of `target/liftoff`.

use liftoff_pages::{Browser, check};
use std::env;
use std::path::{Path, PathBuf};

/// The pages in a folder and in those within it; the file itself, if it is one.
fn pages(place: &Path) -> Vec<PathBuf> {
    let Ok(entries) = place.read_dir() else {
        return vec![place.to_owned()];
    };
    let within = entries.filter_map(|entry| Some(entry.ok()?.path())).flat_map(|path| pages(&path));
    let mut pages: Vec<_> =
        within.filter(|path| path.extension().is_some_and(|kind| kind == "html")).collect();
    pages.sort();
    pages
}

#[test]
#[ignore = "needs chromium and chromedriver"]
fn every_page_loads_without_complaint_and_fits_its_screen() {
    let made = concat!(env!("CARGO_MANIFEST_DIR"), "/../../target/liftoff");
    let places = env::var_os("LIFTOFF_PAGES").unwrap_or_else(|| made.into());
    let all: Vec<PathBuf> = env::split_paths(&places).flat_map(|place| pages(&place)).collect();
    let browser = Browser::open().unwrap();
    let flaws: Vec<String> =
        all.iter().filter_map(|page| check(&browser, page).err()).map(|flaw| flaw.to_string()).collect();
    assert!(!all.is_empty(), "no pages in {}", places.display());
    assert!(flaws.is_empty(), "{}", flaws.join("\n"));
}
