//! The derived equations of every model as snapshots in textbook notation, operation counts
//! included.

use liftoff::equations;
use liftoff_compiled::*;

macro_rules! snapshots {
    ($($name:ident: $model:ty;)*) => {
        $(#[test] fn $name() {
            insta::assert_snapshot!(stringify!($name), equations::<$model>());
        })*
    };
}

snapshots! {
    falling_pair: FallingPair;
    falling_pair_full: FallingPairFull;
    zigzag_published: ZigzagPublished;
    zigzag: Zigzag;
    zigzag_full: ZigzagFull;
    ladder: Ladder;
    narrow_gap: NarrowGap;
    rod_on_floor: RodOnFloor;
    a_frame: AFrame;
    pendulum: Pendulum;
    double_pendulum: DoublePendulum;
    zigzag_thread: ZigzagThread;
    toppling_rod: TopplingRod;
    bouncing_bar: BouncingBar;
    rocking_block: RockingBlock;
    rod_on_three: RodOnThree;
    chimney: Chimney;
    struck_chain: StruckChain;
    unequal_pendulum: UnequalPendulum;
    cart_pendulum: CartPendulum;
    folded_chain: FoldedChain;
    walker: Walker;
    parallelogram: Parallelogram;
    n_four_bar: NFourBar;
    slider_crank: SliderCrank;
    quick_return: QuickReturn;
    squeezer: Squeezer;
    car_axis: CarAxis;
    bouncing_ball: BouncingBall;
    spring_pendulum: SpringPendulum;
    marble: Marble;
    looping: Looping;
    belt: Belt;
    slipping_rod: SlippingRod;
    slipping_ladder: SlippingLadder;
    painleve: Painleve;
    rimless_wheel: RimlessWheel;
    woodpecker: Woodpecker;
    newtons_cradle: NewtonsCradle;
    dominoes: Dominoes;
    compass_walker: CompassWalker;
    trebuchet: Trebuchet;
    jansen_leg: JansenLeg;
    balance_wheel: BalanceWheel;
}
