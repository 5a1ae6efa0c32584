//! Which small changes of the five cores the tests notice.
//!
//! ```text
//! cargo run -p liftoff-mutants -- --folder /tmp/mutants [algebra phases contact event simulation] [--sample 60] [--seed 0]
//! ```
//!
//! From the root of the workspace: copies what git tracks to the folder and writes into the files
//! of a core, behind a switch, a seeded sample of changes: + for −, * for /, < for <=, == for !=,
//! && for ||, and each the other way round; `!`, a minus sign, a call or an assignment with an
//! operator left out. So one build holds all of them (mutant schemata: Untch, Offutt and Harrold
//! 1993). Changes that do not compile are drawn anew. A run without a mutant records which tests
//! reach which of them; then those tests run for each, until one fails or takes five times as long.

mod build;
mod core;
mod schema;
mod sites;
mod trial;

use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Instant;

use clap::{Parser, ValueEnum};

use crate::build::{Built, Mutant, build, drawn};
use crate::core::Core;
use crate::trial::{Fate, Plain, plain, trial};

/// Changes the five cores, and tells which changes the tests notice
#[derive(Parser)]
struct Options {
    /// The cores; all, if none is given
    cores: Vec<Core>,
    /// Where the workspace is copied to
    #[arg(long)]
    folder: PathBuf,
    /// How many mutants of each core
    #[arg(long, default_value_t = 60)]
    sample: usize,
    /// Which sample
    #[arg(long, default_value_t = 0)]
    seed: u64,
    /// How many at once
    #[arg(long, default_value_t = 2)]
    jobs: usize,
    /// Only those mutants, by their numbers
    #[arg(long)]
    only: Vec<u32>,
}

fn main() {
    let mut options = Options::parse();
    if options.cores.is_empty() {
        options.cores = Core::value_variants().to_vec();
    }
    for &core in &options.cores {
        judge(core, &options);
    }
}

fn judge(core: Core, options: &Options) {
    let start = Instant::now();
    let mutants = drawn(core, options.seed);
    let folder =
        std::path::absolute(&options.folder).expect("has a path").join(core.home().replace('/', "-"));
    let built = build(core, &mutants, options.sample, &folder);
    let home = folder.join(core.home());
    let measured = |binary: &PathBuf| (binary.clone(), plain(binary, &home, &folder.join("reached")));
    let binaries: Vec<_> = built.binaries.iter().map(measured).collect();
    let fates = fates(&built, &mutants, &binaries, &home, options);
    let count = |of: fn(&Fate) -> bool| fates.iter().filter(|fate| of(fate)).count();
    println!(
        "{core:?}: {} found, {} sampled, {} killed, {} survived, {} not reached, {:.0} s",
        mutants.len(),
        fates.len(),
        count(|fate| matches!(fate, Fate::Killed(_))),
        count(|fate| *fate == Fate::Survived),
        count(|fate| *fate == Fate::Unreached),
        start.elapsed().as_secs_f64()
    );
}

fn fates(
    built: &Built,
    mutants: &[Mutant],
    binaries: &[(PathBuf, Plain)],
    home: &Path,
    options: &Options,
) -> Vec<Fate> {
    let wanted = |id: &&u32| options.only.is_empty() || options.only.contains(id);
    let ids: Vec<u32> = built.ids.iter().filter(wanted).copied().collect();
    let (next, fates) = (AtomicUsize::new(0), Mutex::new(Vec::new()));
    let work = || {
        while let Some(&id) = ids.get(next.fetch_add(1, Ordering::Relaxed)) {
            let fate = trial(id, binaries, home);
            tell(id, &mutants[id as usize], &fate);
            fates.lock().expect("collects fates").push(fate);
        }
    };
    std::thread::scope(|scope| (0..options.jobs).for_each(|_| _ = scope.spawn(work)));
    fates.into_inner().expect("collects fates")
}

fn tell(id: u32, Mutant { file, site, change }: &Mutant, fate: &Fate) {
    let (fate, by) = match fate {
        Fate::Killed(by) => ("killed", format!(", by {by}")),
        Fate::Survived => ("survived", String::new()),
        Fate::Unreached => ("not reached", String::new()),
    };
    println!("{fate}: {id} {}:{} {change}{by}", file.display(), site.line);
}
