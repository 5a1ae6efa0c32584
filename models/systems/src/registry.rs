//! Every model by its name: four of the paper compiled, the others as text that is derived and
//! interpreted when it is used.

use crate::default_run::{DefaultRun, default_runs};
use crate::{FallingPair, Zigzag, ZigzagFull, ZigzagPublished};
use liftoff_studio::registry::Models;
use liftoff_studio::source::embedded;
use std::sync::LazyLock;

/// Files with their texts.
macro_rules! texts {
    ($($file:ident)*) => {
        [$((stringify!($file), include_str!(concat!(stringify!($file), ".rs")))),*]
    };
}

const TEXTS: &[(&str, &str)] = &texts![
    falling_pair
    falling_pair_full
    narrow_gap
    zigzag
    zigzag_full
    zigzag_published
    zigzag_thread
    ladder
    rod_on_floor
    toppling_rod
    pendulum
    chimney
    bouncing_bar
    rocking_block
    rod_on_three
    a_frame
    double_pendulum
    unequal_pendulum
    cart_pendulum
    struck_chain
    folded_chain
    walker
    parallelogram
    n_four_bar
    slider_crank
    quick_return
    squeezer
    car_axis
    bouncing_ball
    spring_pendulum
    marble
    looping
    belt
    slipping_rod
    slipping_ladder
    painleve
    rimless_wheel
    woodpecker
    newtons_cradle
    dominoes
    compass_walker
    trebuchet
    jansen_leg
    balance_wheel
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
    let model = |(name, run): DefaultRun| match compiled.iter().find(|model| model.name() == name) {
        Some(model) => model.clone().with_default_run(run()).with_source(text(name)),
        None => embedded(name, text(name), run()),
    };
    Models::new(default_runs().map(model).collect())
}

fn text(name: &str) -> &'static str {
    let found = TEXTS.iter().find(|(file, _)| file.replace('_', "-") == name);
    found.map_or("", |(_, text)| text)
}
