//! Every bar system of `liftoff-models` as a type: the tests hold the compiled ones to what the texts say.

#[path = "../../src/systems/a_frame.rs"]
mod a_frame;
#[path = "../../src/systems/balance_wheel.rs"]
mod balance_wheel;
#[path = "../../src/systems/belt.rs"]
mod belt;
#[path = "../../src/systems/bouncing_ball.rs"]
mod bouncing_ball;
#[path = "../../src/systems/bouncing_bar.rs"]
mod bouncing_bar;
#[path = "../../src/systems/car_axis.rs"]
mod car_axis;
#[path = "../../src/systems/chimney.rs"]
mod chimney;
#[path = "../../src/systems/compass_walker.rs"]
mod compass_walker;
#[path = "../../src/systems/dominoes.rs"]
mod dominoes;
#[path = "../../src/systems/double_pendulum.rs"]
mod double_pendulum;
#[path = "../../src/systems/folded_chain.rs"]
mod folded_chain;
#[path = "../../src/systems/jansen_leg.rs"]
mod jansen_leg;
#[path = "../../src/systems/ladder.rs"]
mod ladder;
#[path = "../../src/systems/looping.rs"]
mod looping;
#[path = "../../src/systems/marble.rs"]
mod marble;
#[path = "../../src/systems/n_four_bar.rs"]
mod n_four_bar;
#[path = "../../src/systems/newtons_cradle.rs"]
mod newtons_cradle;
#[path = "../../src/systems/painleve.rs"]
mod painleve;
#[path = "../../src/systems/parallelogram.rs"]
mod parallelogram;
#[path = "../../src/systems/pendulum.rs"]
mod pendulum;
#[path = "../../src/systems/quick_return.rs"]
mod quick_return;
#[path = "../../src/systems/rimless_wheel.rs"]
mod rimless_wheel;
#[path = "../../src/systems/rocking_block.rs"]
mod rocking_block;
#[path = "../../src/systems/rod_on_floor.rs"]
mod rod_on_floor;
#[path = "../../src/systems/rod_on_three.rs"]
mod rod_on_three;
#[path = "../../src/systems/slider_crank.rs"]
mod slider_crank;
#[path = "../../src/systems/slipping_ladder.rs"]
mod slipping_ladder;
#[path = "../../src/systems/slipping_rod.rs"]
mod slipping_rod;
#[path = "../../src/systems/spring_pendulum.rs"]
mod spring_pendulum;
#[path = "../../src/systems/squeezer.rs"]
mod squeezer;
#[path = "../../src/systems/struck_chain.rs"]
mod struck_chain;
#[path = "../../src/systems/toppling_rod.rs"]
mod toppling_rod;
#[path = "../../src/systems/trebuchet.rs"]
mod trebuchet;
#[path = "../../src/systems/unequal_pendulum.rs"]
mod unequal_pendulum;
#[path = "../../src/systems/walker.rs"]
mod walker;
#[path = "../../src/systems/woodpecker.rs"]
mod woodpecker;

pub use liftoff_models::systems::*;

pub use a_frame::AFrame;
pub use balance_wheel::BalanceWheel;
pub use belt::Belt;
pub use bouncing_ball::BouncingBall;
pub use bouncing_bar::BouncingBar;
pub use car_axis::CarAxis;
pub use chimney::Chimney;
pub use compass_walker::CompassWalker;
pub use dominoes::Dominoes;
pub use double_pendulum::DoublePendulum;
pub use folded_chain::FoldedChain;
pub use jansen_leg::JansenLeg;
pub use ladder::Ladder;
pub use looping::Looping;
pub use marble::Marble;
pub use n_four_bar::NFourBar;
pub use newtons_cradle::NewtonsCradle;
pub use painleve::Painleve;
pub use parallelogram::Parallelogram;
pub use pendulum::Pendulum;
pub use quick_return::QuickReturn;
pub use rimless_wheel::RimlessWheel;
pub use rocking_block::RockingBlock;
pub use rod_on_floor::RodOnFloor;
pub use rod_on_three::RodOnThree;
pub use slider_crank::SliderCrank;
pub use slipping_ladder::SlippingLadder;
pub use slipping_rod::SlippingRod;
pub use spring_pendulum::SpringPendulum;
pub use squeezer::Squeezer;
pub use struck_chain::StruckChain;
pub use toppling_rod::TopplingRod;
pub use trebuchet::Trebuchet;
pub use unequal_pendulum::UnequalPendulum;
pub use walker::Walker;
pub use woodpecker::Woodpecker;

use liftoff_studio::registry::Models;
use std::sync::LazyLock;

/// Every model, compiled.
pub fn models() -> &'static Models {
    static MODELS: LazyLock<Models> = LazyLock::new(|| {
        let models = liftoff_studio::models![
            FallingPair,
            FallingPairFull,
            NarrowGap,
            ZigzagPublished,
            Zigzag,
            ZigzagFull,
            ZigzagThread,
            Ladder,
            RodOnFloor,
            TopplingRod,
            Pendulum,
            Chimney,
            BouncingBar,
            RockingBlock,
            RodOnThree,
            AFrame,
            DoublePendulum,
            UnequalPendulum,
            StruckChain,
            FoldedChain,
            Walker,
            Parallelogram,
            NFourBar,
            SliderCrank,
            QuickReturn,
            Squeezer,
            CarAxis,
            BouncingBall,
            SpringPendulum,
            Marble,
            Looping,
            Belt,
            SlippingRod,
            SlippingLadder,
            Painleve,
            RimlessWheel,
            Woodpecker,
            NewtonsCradle,
            Dominoes,
            CompassWalker,
            Trebuchet,
            JansenLeg,
            BalanceWheel
        ];
        Models::new(models.iter().cloned().map(liftoff_models::with_default_run).collect())
    });
    &MODELS
}
