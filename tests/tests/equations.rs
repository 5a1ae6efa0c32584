//! The derived equations of every model as snapshots in textbook notation, operation counts included.

use liftoff::model::BarSystem;
use liftoff_models::*;

macro_rules! snapshots {
    ($($name:ident: $model:ty;)*) => {
        $(#[test] fn $name() {
            insta::assert_snapshot!(stringify!($name), liftoff::equations::<$model>());
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
    rod_on_floor: RodOnFloor;
    a_frame: AFrame;
    pendulum: Pendulum;
    double_pendulum: DoublePendulum;
}

/// The equations that users snapshot are those that were compiled.
#[test]
fn declaration_is_re_derivable() {
    let again = liftoff_codegen::equations(Zigzag::LAYOUT.declaration.parse().unwrap()).unwrap();
    assert_eq!(again.to_string(), liftoff::equations::<Zigzag>());
}
