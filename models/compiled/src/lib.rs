//! Every bar system of `liftoff-systems` as a type: the tests hold the compiled ones to what the
//! texts say.

#[path = "../../systems/src/a_frame.rs"]
mod a_frame;
#[path = "../../systems/src/balance_wheel.rs"]
mod balance_wheel;
#[path = "../../systems/src/belt.rs"]
mod belt;
#[path = "../../systems/src/bouncing_ball.rs"]
mod bouncing_ball;
#[path = "../../systems/src/bouncing_bar.rs"]
mod bouncing_bar;
#[path = "../../systems/src/car_axis.rs"]
mod car_axis;
#[path = "../../systems/src/cart_pendulum.rs"]
mod cart_pendulum;
#[path = "../../systems/src/chimney.rs"]
mod chimney;
#[path = "../../systems/src/compass_walker.rs"]
mod compass_walker;
#[path = "../../systems/src/dominoes.rs"]
mod dominoes;
#[path = "../../systems/src/double_pendulum.rs"]
mod double_pendulum;
#[path = "../../systems/src/falling_pair_full.rs"]
mod falling_pair_full;
#[path = "../../systems/src/folded_chain.rs"]
mod folded_chain;
#[path = "../../systems/src/jansen_leg.rs"]
mod jansen_leg;
#[path = "../../systems/src/ladder.rs"]
mod ladder;
#[path = "../../systems/src/looping.rs"]
mod looping;
#[path = "../../systems/src/marble.rs"]
mod marble;
#[path = "../../systems/src/n_four_bar.rs"]
mod n_four_bar;
#[path = "../../systems/src/narrow_gap.rs"]
mod narrow_gap;
#[path = "../../systems/src/newtons_cradle.rs"]
mod newtons_cradle;
#[path = "../../systems/src/painleve.rs"]
mod painleve;
#[path = "../../systems/src/parallelogram.rs"]
mod parallelogram;
#[path = "../../systems/src/pendulum.rs"]
mod pendulum;
#[path = "../../systems/src/quick_return.rs"]
mod quick_return;
#[path = "../../systems/src/rimless_wheel.rs"]
mod rimless_wheel;
#[path = "../../systems/src/rocking_block.rs"]
mod rocking_block;
#[path = "../../systems/src/rod_on_floor.rs"]
mod rod_on_floor;
#[path = "../../systems/src/rod_on_three.rs"]
mod rod_on_three;
#[path = "../../systems/src/slider_crank.rs"]
mod slider_crank;
#[path = "../../systems/src/slipping_ladder.rs"]
mod slipping_ladder;
#[path = "../../systems/src/slipping_rod.rs"]
mod slipping_rod;
#[path = "../../systems/src/spring_pendulum.rs"]
mod spring_pendulum;
#[path = "../../systems/src/squeezer.rs"]
mod squeezer;
#[path = "../../systems/src/struck_chain.rs"]
mod struck_chain;
#[path = "../../systems/src/toppling_rod.rs"]
mod toppling_rod;
#[path = "../../systems/src/trebuchet.rs"]
mod trebuchet;
#[path = "../../systems/src/unequal_pendulum.rs"]
mod unequal_pendulum;
#[path = "../../systems/src/walker.rs"]
mod walker;
#[path = "../../systems/src/woodpecker.rs"]
mod woodpecker;
#[path = "../../systems/src/zigzag_thread.rs"]
mod zigzag_thread;

pub use liftoff_systems::{FallingPair, Zigzag, ZigzagFull, ZigzagPublished};

pub use a_frame::AFrame;
pub use balance_wheel::BalanceWheel;
pub use belt::Belt;
pub use bouncing_ball::BouncingBall;
pub use bouncing_bar::BouncingBar;
pub use car_axis::CarAxis;
pub use cart_pendulum::CartPendulum;
pub use chimney::Chimney;
pub use compass_walker::CompassWalker;
pub use dominoes::Dominoes;
pub use double_pendulum::DoublePendulum;
pub use falling_pair_full::FallingPairFull;
pub use folded_chain::FoldedChain;
pub use jansen_leg::JansenLeg;
pub use ladder::Ladder;
pub use looping::Looping;
pub use marble::Marble;
pub use n_four_bar::NFourBar;
pub use narrow_gap::NarrowGap;
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
pub use zigzag_thread::ZigzagThread;

use liftoff_studio::registry::Models;
use std::sync::LazyLock;

/// Every model, compiled.
pub fn models() -> &'static Models {
    static MODELS: LazyLock<Models> = LazyLock::new(|| {
        liftoff_systems::with_default_runs(&liftoff_studio::models![
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
            CartPendulum,
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
        ])
    });
    &MODELS
}
