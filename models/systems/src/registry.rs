//! Every model by its name: the paper's compiled, the others as text that is derived and interpreted when it is used.

use crate::default_run::default_run;
use crate::{
    FallingPair, FallingPairFull, NarrowGap, Zigzag, ZigzagFull, ZigzagPublished, ZigzagThread,
};
use liftoff_studio::registry::{Entry, Models};
use liftoff_studio::source::embedded;
use std::sync::LazyLock;

/// Names with the text of the file of each.
macro_rules! texts {
    ($($name:literal $file:literal)*) => {
        [$(($name, include_str!(concat!($file, ".rs")))),*]
    };
}

const TEXTS: [(&str, &str); 36] = texts![
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
        let compiled = liftoff_studio::models![
            FallingPair,
            FallingPairFull,
            NarrowGap,
            ZigzagPublished,
            Zigzag,
            ZigzagFull,
            ZigzagThread
        ];
        let texts = TEXTS.map(|(name, text)| embedded(name, text, default_run(name)));
        Models::new(compiled.iter().cloned().map(with_default_run).chain(texts).collect())
    });
    &MODELS
}

/// A model with the default run that it has here.
pub fn with_default_run(model: Entry) -> Entry {
    let run = default_run(model.name());
    model.with_default_run(run)
}
