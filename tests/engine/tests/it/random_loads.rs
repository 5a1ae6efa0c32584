//! Loads drawn at random of sums, products, |a|, min, max and roots of sums of squares, by every
//! method against steps of DOP853 that are cut at their kinks by hand.

use liftoff::method::MethodId;
use liftoff::prelude::*;
use liftoff_core::integrate::{Dop853, StepState, Stepper, Tolerance};

/// x, y, ẋ, ẏ of a ball of mass 1.
type State = [f64; 4];

/// A ball under a load, the load again as a function of Rust, and what changes its sign at its
/// kinks.
macro_rules! loaded {
    ($name:ident, |$x:ident, $y:ident, $vx:ident, $vy:ident, $P:ident| ($fx:expr, $fy:expr), [$($kink:expr),*]) => {
        #[derive(BarSystem)]
        #[particle(P, mass = m)]
        #[coordinate(x = x(P))]
        #[coordinate(y = y(P))]
        #[figure(P = (0, 0))]
        #[force(P = ($fx, $fy))]
        struct $name {
            m: f64,
        }

        #[test]
        #[allow(non_snake_case, reason = "a test is named as its model, and a point by a capital")]
        #[allow(unused_variables, reason = "a load may not need the whole state")]
        fn $name() {
            let force = |&[$x, $y, u, v]: &State| {
                let ($P, $vx, $vy) = ((), |()| u, |()| v);
                [u, v, $fx, $fy]
            };
            let kinks = |&[$x, $y, u, v]: &State| -> Vec<bool> {
                let ($P, $vx, $vy) = ((), |()| u, |()| v);
                vec![$($kink > 0.0),*]
            };
            agree(&$name { m: 1.0 }, &force, &kinks);
        }
    };
}

const START: State = [0.9, -0.4, 0.7, 1.3];
const END: f64 = 3.0;
/// In a step of this length no kink is passed twice.
const SHORT: f64 = 0.01;

fn agree<M: BarSystem>(model: &M, f: &impl Fn(&State) -> State, kinks: &impl Fn(&State) -> Vec<bool>) {
    let (expected, cuts) = cut_by_hand(f, kinks);
    for method in MethodId::ALL {
        for tolerance in [1e-5, 1e-8, 1e-11] {
            let start =
                Pose::new("x", START[0]).with("y", START[1]).with("x'", START[2]).with("y'", START[3]);
            let simulation = Simulation::new(model).unwrap().tolerance(tolerance).method(method);
            let run = simulation.start(start).unwrap().limit(END).run().unwrap();
            let error =
                run.final_state().iter().zip(expected).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            // Tens of steps, each within the tolerance of entries near one.
            assert!(error < 30.0 * tolerance, "{} at {tolerance:e}: {error:e}, {cuts} kinks", method.name());
        }
    }
}

/// The state at the end by short steps at a tolerance of 1e-13, each on one side of all kinks; and
/// how many were passed.
fn cut_by_hand(f: &impl Fn(&State) -> State, kinks: &impl Fn(&State) -> Vec<bool>) -> (State, usize) {
    let (mut t, mut state, mut cuts) = (0.0, START, 0);
    while t < END {
        let h = SHORT.min(END - t);
        let side = kinks(&state);
        let next = moved(f, state, h);
        if kinks(&next) == side {
            (t, state) = (t + h, next);
            continue;
        }
        let [mut before, mut behind] = [0.0, h];
        while behind - before > 1e-15 {
            let middle = 0.5 * (before + behind);
            if kinks(&moved(f, state, middle)) == side { before = middle } else { behind = middle }
        }
        (t, state, cuts) = (t + behind, moved(f, state, behind), cuts + 1);
    }
    (state, cuts)
}

fn moved(f: &impl Fn(&State) -> State, state: State, h: f64) -> State {
    let tolerance = Tolerance::new(1e-13, [1e-13; 4]).unwrap();
    let mut solver = Dop853::new(f, StepState::new(tolerance, 0.0, state).with_first_step(h).with_end(h));
    while h > 0.0 && solver.step_state().time() < h {
        solver.step().unwrap();
    }
    *solver.step_state().state()
}

loaded!(
    Load0,
    |x, y, vx, vy, P| (
        -4.0 * x
            - 0.34
                * (0.5
                    * (1.15 * x * y - 1.06 * vy(P) + (x + 1.21 * vy(P)).sin()
                        - 0.35 * y
                        - ((1.15 * x * y - 1.06 * vy(P) - ((x + 1.21 * vy(P)).sin() - 0.35 * y))
                            * (1.15 * x * y - 1.06 * vy(P) - ((x + 1.21 * vy(P)).sin() - 0.35 * y)))
                            .sqrt())),
        -3.0 * y
            + 0.49
                * (0.5
                    * (x + 0.41 * vy(P) - 1.07 + y - 0.36 * vy(P)
                        + ((x + 0.41 * vy(P) - 1.07 - (y - 0.36 * vy(P)))
                            * (x + 0.41 * vy(P) - 1.07 - (y - 0.36 * vy(P))))
                        .sqrt()))
            - 0.64 * ((((vy(P) + 0.96 * y).sin() - 1.41 * x) * ((vy(P) + 0.96 * y).sin() - 1.41 * x)).sqrt())
    ),
    [
        1.15 * x * y - 1.06 * vy(P) - ((x + 1.21 * vy(P)).sin() - 0.35 * y),
        x + 0.41 * vy(P) - 1.07 - (y - 0.36 * vy(P)),
        (vy(P) + 0.96 * y).sin() - 1.41 * x
    ]
);
loaded!(
    Load1,
    |x, y, vx, vy, P| (
        -4.0 * x - 1.37 * (((vy(P) + 1.32 * y - 1.17) * (vy(P) + 1.32 * y - 1.17)).sqrt()),
        -3.0 * y
            + 0.83
                * (0.5
                    * ((vy(P) + 1.24 * x).sin() - 0.85 * y + 0.56 * y * vx(P)
                        - 0.24 * vy(P)
                        - (((vy(P) + 1.24 * x).sin() - 0.85 * y - (0.56 * y * vx(P) - 0.24 * vy(P)))
                            * ((vy(P) + 1.24 * x).sin() - 0.85 * y - (0.56 * y * vx(P) - 0.24 * vy(P))))
                        .sqrt()))
            - 1.16 * (((vy(P) + 0.90 * vx(P) - 0.79) * (vy(P) + 0.90 * vx(P) - 0.79)).sqrt())
    ),
    [
        vy(P) + 1.32 * y - 1.17,
        (vy(P) + 1.24 * x).sin() - 0.85 * y - (0.56 * y * vx(P) - 0.24 * vy(P)),
        vy(P) + 0.90 * vx(P) - 0.79
    ]
);
loaded!(
    Load2,
    |x, y, vx, vy, P| (
        -4.0 * x
            - 0.83
                * (((0.82 * y * x - 0.51 * vx(P)) * (0.82 * y * x - 0.51 * vx(P))
                    + ((y + 1.11 * vx(P)).sin() - 0.94 * x) * ((y + 1.11 * vx(P)).sin() - 0.94 * x))
                    .sqrt()),
        -3.0 * y
            + 0.22
                * (((1.42 * vx(P) * y - 0.54 * x) * (1.42 * vx(P) * y - 0.54 * x)
                    + (y - 1.02 * x) * (y - 1.02 * x))
                    .sqrt())
            - 0.81
                * (0.5
                    * (vx(P) - 0.45 * vy(P) + 1.49 * vx(P) * y - 0.35 * vy(P)
                        + ((vx(P) - 0.45 * vy(P) - (1.49 * vx(P) * y - 0.35 * vy(P)))
                            * (vx(P) - 0.45 * vy(P) - (1.49 * vx(P) * y - 0.35 * vy(P))))
                        .sqrt()))
    ),
    [vx(P) - 0.45 * vy(P) - (1.49 * vx(P) * y - 0.35 * vy(P))]
);
loaded!(
    Load3,
    |x, y, vx, vy, P| (
        -4.0 * x
            - 1.44
                * (0.5
                    * (0.44 * vx(P) * y - 0.47 * vy(P) + x
                        - 0.93 * vy(P)
                        - ((0.44 * vx(P) * y - 0.47 * vy(P) - (x - 0.93 * vy(P)))
                            * (0.44 * vx(P) * y - 0.47 * vy(P) - (x - 0.93 * vy(P))))
                        .sqrt())),
        -3.0 * y
            + 0.97
                * (0.5
                    * ((x + 0.52 * vx(P)).sin() - 0.70 * vy(P) + vy(P) + 1.04 * x
                        - 0.76
                        - (((x + 0.52 * vx(P)).sin() - 0.70 * vy(P) - (vy(P) + 1.04 * x - 0.76))
                            * ((x + 0.52 * vx(P)).sin() - 0.70 * vy(P) - (vy(P) + 1.04 * x - 0.76)))
                            .sqrt()))
            - 1.21 * (((y + 0.27 * vy(P) - 1.41) * (y + 0.27 * vy(P) - 1.41)).sqrt())
    ),
    [
        0.44 * vx(P) * y - 0.47 * vy(P) - (x - 0.93 * vy(P)),
        (x + 0.52 * vx(P)).sin() - 0.70 * vy(P) - (vy(P) + 1.04 * x - 0.76),
        y + 0.27 * vy(P) - 1.41
    ]
);
loaded!(
    Load4,
    |x, y, vx, vy, P| (
        -4.0 * x
            - 0.48
                * (((vx(P) - 1.22 * y) * (vx(P) - 1.22 * y)
                    + ((x + 0.74 * y).sin() - 0.78 * vy(P)) * ((x + 0.74 * y).sin() - 0.78 * vy(P)))
                .sqrt()),
        -3.0 * y
            + 0.32
                * (0.5
                    * (1.49 * vy(P) * vx(P) - 0.97 * x + (vy(P) + 0.55 * y).sin()
                        - 0.81 * vx(P)
                        - ((1.49 * vy(P) * vx(P) - 0.97 * x - ((vy(P) + 0.55 * y).sin() - 0.81 * vx(P)))
                            * (1.49 * vy(P) * vx(P)
                                - 0.97 * x
                                - ((vy(P) + 0.55 * y).sin() - 0.81 * vx(P))))
                        .sqrt()))
            - 1.41
                * (0.5
                    * (y - 0.75 * vy(P) + y - 0.20 * vx(P)
                        + ((y - 0.75 * vy(P) - (y - 0.20 * vx(P)))
                            * (y - 0.75 * vy(P) - (y - 0.20 * vx(P))))
                        .sqrt()))
    ),
    [
        1.49 * vy(P) * vx(P) - 0.97 * x - ((vy(P) + 0.55 * y).sin() - 0.81 * vx(P)),
        y - 0.75 * vy(P) - (y - 0.20 * vx(P))
    ]
);
loaded!(
    Load5,
    |x, y, vx, vy, P| (
        -4.0 * x - 1.08 * (((vx(P) - 1.35 * x) * (vx(P) - 1.35 * x)).sqrt()),
        -3.0 * y
            + 0.81
                * (((0.52 * vx(P) * vy(P) - 1.09 * y) * (0.52 * vx(P) * vy(P) - 1.09 * y)
                    + (y - 1.41 * vy(P)) * (y - 1.41 * vy(P)))
                .sqrt())
            - 1.37 * (((0.65 * x * vx(P) - 1.42 * y) * (0.65 * x * vx(P) - 1.42 * y)).sqrt())
    ),
    [vx(P) - 1.35 * x, 0.65 * x * vx(P) - 1.42 * y]
);
loaded!(
    Load6,
    |x, y, vx, vy, P| (
        -4.0 * x
            - 0.24
                * (0.5
                    * (x + 0.88 * y - 1.29 + (y + 0.64 * vx(P)).sin()
                        - 0.70 * x
                        - ((x + 0.88 * y - 1.29 - ((y + 0.64 * vx(P)).sin() - 0.70 * x))
                            * (x + 0.88 * y - 1.29 - ((y + 0.64 * vx(P)).sin() - 0.70 * x)))
                            .sqrt())),
        -3.0 * y
            + 0.98
                * (0.5
                    * ((y + 1.32 * vx(P)).sin() - 0.82 * x + y + 1.28 * x - 0.45
                        + (((y + 1.32 * vx(P)).sin() - 0.82 * x - (y + 1.28 * x - 0.45))
                            * ((y + 1.32 * vx(P)).sin() - 0.82 * x - (y + 1.28 * x - 0.45)))
                            .sqrt()))
            - 1.30 * (((vx(P) - 0.24 * vy(P)) * (vx(P) - 0.24 * vy(P))).sqrt())
    ),
    [
        x + 0.88 * y - 1.29 - ((y + 0.64 * vx(P)).sin() - 0.70 * x),
        (y + 1.32 * vx(P)).sin() - 0.82 * x - (y + 1.28 * x - 0.45),
        vx(P) - 0.24 * vy(P)
    ]
);
loaded!(
    Load7,
    |x, y, vx, vy, P| (
        -4.0 * x
            - 1.08
                * (0.5
                    * (vx(P) - 1.01 * x + (x + 1.10 * vy(P)).sin() - 0.70 * vx(P)
                        + ((vx(P) - 1.01 * x - ((x + 1.10 * vy(P)).sin() - 0.70 * vx(P)))
                            * (vx(P) - 1.01 * x - ((x + 1.10 * vy(P)).sin() - 0.70 * vx(P))))
                        .sqrt())),
        -3.0 * y
            + 0.98
                * (((0.85 * x * vy(P) - 1.28 * vx(P)) * (0.85 * x * vy(P) - 1.28 * vx(P))
                    + ((y + 0.37 * vy(P)).sin() - 1.31 * x) * ((y + 0.37 * vy(P)).sin() - 1.31 * x))
                    .sqrt())
            - 0.56
                * (0.5
                    * (y - 1.09 * vx(P) + 1.07 * x * vx(P) - 1.16 * y
                        + ((y - 1.09 * vx(P) - (1.07 * x * vx(P) - 1.16 * y))
                            * (y - 1.09 * vx(P) - (1.07 * x * vx(P) - 1.16 * y)))
                            .sqrt()))
    ),
    [
        vx(P) - 1.01 * x - ((x + 1.10 * vy(P)).sin() - 0.70 * vx(P)),
        y - 1.09 * vx(P) - (1.07 * x * vx(P) - 1.16 * y)
    ]
);

macro_rules! pulled_as_power {
    ($name:ident, $power:tt) => {
        /// A block at a wall, pulled away from it by a power of time.
        #[derive(BarSystem)]
        #[particle(P, mass = m)]
        #[slider(P = horizontal(0))]
        #[support(a = wall(0), under = P, facing = right)]
        #[force(pull = (f * t.powi($power), 0), at = P)]
        #[figure(P = (0, 0))]
        struct $name {
            m: f64,
            f: f64,
        }
    };
}

pulled_as_power!(Fourth, 4);
pulled_as_power!(Fifth, 5);
pulled_as_power!(Eighth, 8);

/// However high the power of time by which a load begins, the contact opens at once: x = f tⁿ⁺² / m
/// (n + 1)(n + 2).
#[test]
fn what_is_pulled_off_slowly_opens_at_once() {
    fn check<M: BarSystem>(block: M, power: i32) {
        let run = Simulation::new(&block).unwrap().tolerance(1e-6).limit(1.0).run().unwrap();
        let kinds: Vec<EventKind> = run.events().iter().map(|event| event.kind).collect();
        assert_eq!(kinds, [EventKind::Start, EventKind::End], "{power}");
        let expected = 3.0 / (2.0 * f64::from((power + 1) * (power + 2)));
        assert!((run.final_state()[0] - expected).abs() < 1e-6, "{power}: {:?}", run.final_state());
    }
    check(Fourth { m: 2.0, f: 3.0 }, 4);
    check(Fifth { m: 2.0, f: 3.0 }, 5);
    check(Eighth { m: 2.0, f: 3.0 }, 8);
}
