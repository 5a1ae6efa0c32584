//! Valid declarations: random ones, and those of the models.

use std::path::Path;

use liftoff_tests::random::{Source, Vocabulary, sample, sample_of};
use quote::ToTokens;
use syn::visit::Visit;

use super::tokens;

/// How many are drawn of each vocabulary.
const DRAWN: u64 = 256;

/// Declarations as tokens, short ones first.
#[derive(Debug)]
pub(super) struct Pool(Vec<Vec<String>>);

impl Default for Pool {
    fn default() -> Self {
        let simple = (0..DRAWN).map(|seed| sample(seed).declaration);
        let full = (0..DRAWN).map(|seed| sample_of(seed, Vocabulary::ALL).declaration);
        let all = simple.chain(full).chain(models());
        let mut all: Vec<_> = all.filter_map(|text| text.parse().ok()).map(tokens::flat).collect();
        all.sort_by_key(Vec::len);
        Self(all)
    }
}

impl Pool {
    /// One of them, half of the time from the shortest sixteenth: a mistake is one in a short
    /// declaration too, and tried in less time.
    pub fn pick(&self, source: &mut Source) -> &[String] {
        let part = source.unit().powi(4);
        &self.0[(part * self.0.len() as f64) as usize]
    }
}

/// The declarations of the models, file by file.
fn models() -> Vec<String> {
    let directory = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../models/systems/src");
    let entries = std::fs::read_dir(directory).into_iter().flatten().flatten();
    let mut files: Vec<_> = entries.map(|entry| entry.path()).collect();
    files.sort();
    let mut found = Found::default();
    for text in files.iter().filter_map(|file| std::fs::read_to_string(file).ok()) {
        if let Ok(file) = syn::parse_file(&text) {
            found.visit_file(&file);
        }
    }
    found.0
}

/// Structs with attributes of bars.
#[derive(Default)]
struct Found(Vec<String>);

impl<'a> Visit<'a> for Found {
    fn visit_item_struct(&mut self, item: &'a syn::ItemStruct) {
        if item
            .attrs
            .iter()
            .any(|attribute| ["bar", "chain", "body"].iter().any(|a| attribute.path().is_ident(a)))
        {
            let mut item = item.clone();
            item.attrs.retain(|attribute| {
                !attribute.path().is_ident("doc") && !attribute.path().is_ident("derive")
            });
            self.0.push(item.to_token_stream().to_string());
        }
    }
}
