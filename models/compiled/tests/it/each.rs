//! One check of many models.

/// A test for each model, named so, that calls `check` with it.
macro_rules! models {
    ($($name:ident: $model:expr;)*) => {
        $(#[test] fn $name() { check(&$model); })*
    };
}

/// The same for the paper's models and the simplest others.
macro_rules! first_models {
    () => {
        models! {
            falling_pair: FallingPair { m: 1.3, l: 0.7, g: 9.81 };
            falling_pair_full: FallingPairFull { m: 1.3, l: 0.7, g: 9.81 };
            zigzag_published: ZigzagPublished { m1: 0.4, m2: 0.9, l: 0.7, g: 9.81 };
            zigzag: Zigzag { m1: 0.4, m2: 0.9, l: 0.7, g: 9.81 };
            zigzag_full: ZigzagFull { m1: 0.4, m2: 0.9, l: 0.7, g: 9.81 };
            ladder: Ladder { m: 1.3, l: 0.7, g: 9.81 };
            rod_on_floor: RodOnFloor { m: 1.3, l: 0.7, g: 9.81 };
            a_frame: AFrame { m: 1.3, l: 0.7, g: 9.81 };
            pendulum: Pendulum { m: 1.3, l: 0.7, g: 9.81 };
            double_pendulum: DoublePendulum { m: 1.3, l: 0.7, g: 9.81 };
        }
    };
}
