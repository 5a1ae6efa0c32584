//! Every model by its name: the paper's compiled, the others as text that is derived and interpreted when it is used.

use crate::default_run::{DefaultRun, default_runs};
use crate::{FallingPair, Zigzag, ZigzagFull, ZigzagPublished};
use liftoff_studio::registry::Models;
use liftoff_studio::source::embedded;
use std::sync::LazyLock;

/// Names with the text of the file of each.
macro_rules! texts {
    ($($name:literal $file:literal)*) => {
        [$(($name, include_str!(concat!($file, ".rs")))),*]
    };
}

const TEXTS: [(&str, &str); 39] = texts![
    "falling-pair-full" "falling_pair_full"
    "narrow-gap" "narrow_gap"
    "zigzag-thread" "zigzag_thread"
    "ladder" "ladder"
    "rod-on-floor" "rod_on_floor"
    "toppling-rod" "toppling_rod"
    "pendulum" "pendulum"
    "chimney" "chimney"
    "bouncing-bar" "bouncing_bar"
    "rocking-block" "rocking_block"
    "rod-on-three" "rod_on_three"
    "a-frame" "a_frame"
    "double-pendulum" "double_pendulum"
    "unequal-pendulum" "unequal_pendulum"
    "struck-chain" "struck_chain"
    "folded-chain" "folded_chain"
    "walker" "walker"
    "parallelogram" "parallelogram"
    "n-four-bar" "n_four_bar"
    "slider-crank" "slider_crank"
    "quick-return" "quick_return"
    "squeezer" "squeezer"
    "car-axis" "car_axis"
    "bouncing-ball" "bouncing_ball"
    "spring-pendulum" "spring_pendulum"
    "marble" "marble"
    "looping" "looping"
    "belt" "belt"
    "slipping-rod" "slipping_rod"
    "slipping-ladder" "slipping_ladder"
    "painleve" "painleve"
    "rimless-wheel" "rimless_wheel"
    "woodpecker" "woodpecker"
    "newtons-cradle" "newtons_cradle"
    "dominoes" "dominoes"
    "compass-walker" "compass_walker"
    "trebuchet" "trebuchet"
    "jansen-leg" "jansen_leg"
    "balance-wheel" "balance_wheel"
];

/// Every model.
pub fn models() -> &'static Models {
    static MODELS: LazyLock<Models> = LazyLock::new(|| {
        let compiled = liftoff_studio::models![FallingPair, Zigzag, ZigzagFull, ZigzagPublished];
        with_default_runs(&compiled)
    });
    &MODELS
}

/// Every model with its default run: those that are compiled, and the others from their texts.
pub fn with_default_runs(compiled: &Models) -> Models {
    let model = |(name, run): DefaultRun| match compiled.find(name) {
        Ok(model) => model.clone().with_default_run(run()),
        Err(_) => embedded(name, text(name), run()),
    };
    Models::new(default_runs().map(model).collect())
}

fn text(name: &str) -> &'static str {
    let found = TEXTS.iter().find(|(known, _)| *known == name);
    found.map_or("", |(_, text)| text)
}
