use std::cell::RefCell;
use std::collections::BTreeSet;
use std::io::Write;
use std::sync::OnceLock;

static CHOSEN: OnceLock<u32> = OnceLock::new();
static RECORD: OnceLock<Option<String>> = OnceLock::new();

thread_local!(static SEEN: RefCell<BTreeSet<u32>> = const { RefCell::new(BTreeSet::new()) });

pub(crate) fn mutant(id: u32) -> bool {
    if let Some(path) = RECORD.get_or_init(|| std::env::var("LIFTOFF_MUTANTS_REACHED").ok()) {
        record(path, id);
    }
    let chosen = || std::env::var("LIFTOFF_MUTANT").ok().and_then(|id| id.parse().ok()).unwrap_or(u32::MAX);
    *CHOSEN.get_or_init(chosen) == id
}

/// A line for the first time that a test, known by its thread, reaches the place.
fn record(path: &str, id: u32) {
    if !SEEN.try_with(|seen| seen.borrow_mut().insert(id)).unwrap_or(false) {
        return;
    }
    let thread = std::thread::current();
    let line = format!("{id} {}\n", thread.name().unwrap_or("main"));
    let file = std::fs::File::options().append(true).create(true).open(path);
    file.and_then(|mut file| file.write_all(line.as_bytes())).expect("records reached mutants");
}
