//! A copy of the workspace with mutants, built.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::process::Command;

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};
use serde_json::Value;

use crate::core::{Core, tracked, write};
use crate::schema::Schema;
use crate::sites::{Site, sites};

/// A mutant: a file of the workspace, its text, and a change of it.
#[derive(Clone, Debug)]
pub struct Mutant {
    /// Where it is.
    pub file: PathBuf,
    /// What is changed.
    pub site: Site,
    /// The line before and after, without what stands around.
    pub change: String,
}

/// The mutants of a core in the order of their drawing.
pub fn drawn(core: Core, seed: u64) -> Vec<Mutant> {
    let mut source = ChaCha8Rng::seed_from_u64(seed);
    let mut all: Vec<(u64, Mutant)> = Vec::new();
    for file in core.files(&tracked()) {
        let text = std::fs::read_to_string(&file).expect("reads a source");
        for site in sites(&text).expect("parses a source") {
            let change = describe(&text, &site);
            all.push((source.next_u64(), Mutant { file: file.clone(), site, change }));
        }
    }
    all.sort_by_key(|&(key, _)| key);
    all.into_iter().map(|(_, mutant)| mutant).collect()
}

fn describe(text: &str, Site { range, cut, to, .. }: &Site) -> String {
    let flat = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
    let short = |text: String| match text.char_indices().nth(90) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text,
    };
    let (old, marked) = (&text[cut.clone()], &text[range.clone()]);
    if to.is_empty() && old == marked {
        return format!("without `{}`", short(flat(marked)));
    }
    let new = if to.is_empty() { "nothing" } else { to };
    let marked = format!("{}⟦{old}⟧{}", &text[range.start..cut.start], &text[cut.end..range.end]);
    format!("`{}` with {new}", short(flat(&marked)))
}

/// Test binaries with mutants, and where they run.
#[derive(Debug)]
pub struct Built {
    /// Executables in the order in which they are tried.
    pub binaries: Vec<PathBuf>,
    /// Numbers of the mutants that they hold: the first `sample` of those that compile.
    pub ids: Vec<u32>,
}

/// Builds the first so many mutants that compile.
pub fn build(core: Core, mutants: &[Mutant], sample: usize, folder: &Path) -> Built {
    for path in tracked() {
        if !core.files(std::slice::from_ref(&path)).is_empty() || path == core.home_file() {
            continue;
        }
        write(&folder.join(&path), &std::fs::read(&path).expect("reads a file"));
    }
    let root = std::fs::read_to_string(core.home_file()).expect("reads the crate's root");
    let switch = include_str!("switch.rs");
    let root = format!("{root}\nmod mutant_switch {{\n{switch}}}\npub(crate) use mutant_switch::mutant;\n");
    write(&folder.join(core.home_file()), root.as_bytes());
    let mut refused = BTreeSet::new();
    loop {
        let fits = (0..mutants.len() as u32).filter(|id| !refused.contains(id));
        let ids: Vec<u32> = fits.take(sample).collect();
        let schemata = written(core, mutants, &ids, folder);
        match compiled(core, folder) {
            Ok(binaries) => return Built { binaries, ids },
            Err(errors) => {
                let at = |(file, range): &(PathBuf, Range<usize>)| schemata.get(file)?.find_mutant(range);
                let bad: BTreeSet<u32> = errors.places.iter().filter_map(at).collect();
                assert!(!bad.is_empty(), "errors outside of mutants:\n{}", errors.text);
                eprintln!("{} of {} do not compile", bad.len(), ids.len());
                refused.extend(bad);
            }
        }
    }
}

fn written(core: Core, mutants: &[Mutant], ids: &[u32], folder: &Path) -> BTreeMap<PathBuf, Schema> {
    let of = |file: PathBuf| {
        let text = std::fs::read_to_string(&file).expect("reads a source");
        let own = |&&id: &&u32| mutants[id as usize].file == file;
        let mut chosen: Vec<(u32, &Site)> =
            ids.iter().filter(own).map(|&id| (id, &mutants[id as usize].site)).collect();
        chosen.sort_by_key(|(_, site)| (site.range.start, std::cmp::Reverse(site.range.end)));
        let schema = Schema::new(&text, &chosen);
        write(&folder.join(&file), schema.text.as_bytes());
        (file, schema)
    };
    core.files(&tracked()).into_iter().map(of).collect()
}

#[derive(Default)]
struct Errors {
    places: Vec<(PathBuf, Range<usize>)>,
    text: String,
}

fn compiled(core: Core, folder: &Path) -> Result<Vec<PathBuf>, Errors> {
    let mut cargo = Command::new("cargo");
    // Cargo names the files of both workspaces alike.
    cargo.env("CARGO_TARGET_DIR", folder.join("target"));
    cargo.current_dir(folder).args(["test", "--no-run", "--message-format=json"]).args(core.targets());
    let output = cargo.stderr(std::process::Stdio::inherit()).output().expect("starts cargo");
    let (mut binaries, mut errors) = (Vec::new(), Errors::default());
    for message in String::from_utf8_lossy(&output.stdout).lines() {
        let Ok(message) = serde_json::from_str::<Value>(message) else { continue };
        if let Some(path) = message["executable"].as_str() {
            binaries.push((message["target"]["kind"] == "test", PathBuf::from(path)));
        }
        if message["message"]["level"] == "error" {
            errors.text += message["message"]["rendered"].as_str().unwrap_or_default();
            errors
                .places
                .extend(message["message"]["spans"].as_array().into_iter().flatten().filter_map(parse_span));
        }
    }
    binaries.sort();
    if output.status.success() {
        Ok(binaries.into_iter().map(|(_, path)| path).collect())
    } else {
        Err(errors)
    }
}

fn parse_span(span: &Value) -> Option<(PathBuf, Range<usize>)> {
    let byte = |name: &str| span[name].as_u64().map(|byte| byte as usize);
    Some((PathBuf::from(span["file_name"].as_str()?), byte("byte_start")?..byte("byte_end")?))
}
