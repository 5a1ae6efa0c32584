//! A bounded run of random scenes in equal forms, in this process.

use std::collections::BTreeMap;

use liftoff_fuzz::metamorphic::Scenes;
use liftoff_fuzz::{Subject, judge};
use rayon::prelude::*;

/// So many scenes take some seconds.
const CASES: u64 = 200;

#[test]
fn scenes_keep_the_laws_in_every_form() {
    let told: Vec<_> = (0..CASES)
        .into_par_iter()
        .map(|seed| {
            let case = Scenes.generate(seed);
            judge(&Scenes, &case).unwrap_or_else(|finding| panic!("seed {seed}: {finding}\n{case}"))
        })
        .collect();
    let mut fates = BTreeMap::new();
    told.into_iter().flatten().for_each(|word| *fates.entry(word).or_insert(0) += 1);
    let count = |word: &str| fates.get(word).copied().unwrap_or(0);
    assert!(count("ran") > CASES / 2 && count("the same") > CASES, "{fates:?}");
}

#[test]
fn a_seed_is_one_scene() {
    assert!((0..200).all(|seed| Scenes.generate(seed).to_string() == Scenes.generate(seed).to_string()));
}
