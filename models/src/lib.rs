//! Bar systems declared with liftoff, one file each with its figure; their default runs in `default_run`. Beside them what
//! only our own command does: `paper` reproduces the seed, `stability` has stiff and extreme scenes to be judged.

pub mod command;
pub mod paper;
pub mod stability;

mod default_run;

mod a_frame;
mod balance_wheel;
mod belt;
mod bouncing_ball;
mod bouncing_bar;
mod car_axis;
mod chimney;
mod compass_walker;
mod dominoes;
mod double_pendulum;
mod falling_pair;
mod falling_pair_full;
mod folded_chain;
mod jansen_leg;
mod ladder;
mod looping;
mod marble;
mod n_four_bar;
mod narrow_gap;
mod newtons_cradle;
mod painleve;
mod parallelogram;
mod pendulum;
mod quick_return;
mod rimless_wheel;
mod rocking_block;
mod rod_on_floor;
mod rod_on_three;
mod slider_crank;
mod slipping_ladder;
mod slipping_rod;
mod spring_pendulum;
mod squeezer;
mod struck_chain;
mod toppling_rod;
mod trebuchet;
mod unequal_pendulum;
mod walker;
mod woodpecker;
mod zigzag;
mod zigzag_full;
mod zigzag_published;
mod zigzag_thread;

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
pub use falling_pair::FallingPair;
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
pub use zigzag::Zigzag;
pub use zigzag_full::ZigzagFull;
pub use zigzag_published::ZigzagPublished;
pub use zigzag_thread::ZigzagThread;

use liftoff_studio::registry::Models;
use std::sync::LazyLock;

/// Every model.
pub fn models() -> &'static Models {
    static MODELS: LazyLock<Models> = LazyLock::new(|| {
        liftoff_cli::models![
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
        ]
    });
    &MODELS
}
