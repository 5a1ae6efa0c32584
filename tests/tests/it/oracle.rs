//! The oracle against closed forms, so that it can be trusted where there are none.
//!
//! Tolerance 1e-12 relative to the scale of the quantity: a dense solve of some 20 unknowns loses
//! two or three digits of the 16. Looser ones say why.

use std::f64::consts::{FRAC_PI_2, PI};

use crate::scenes::{self, at_rest_from, bar_over_floor, level_rod, pendulum};
use liftoff_tests::catalogue::{
    a_frame, double_pendulum, hinged_bar, ladder, rod_on_floor, vanishing_support,
};
use liftoff_tests::numerics::root;
use liftoff_tests::oracle::{Body, Load, Mark, Unsolvable};
use liftoff_tests::paper::{FallingPair, Zigzag};
use nalgebra::Vector2;

const ROUNDING: f64 = 1e-12;

fn close(computed: f64, expected: f64, scale: f64) {
    let error = (computed - expected).abs() / scale;
    assert!(error <= ROUNDING, "{computed:e} for {expected:e}, {error:.1e}");
}

#[test]
fn hinged_bar_forces() {
    for theta in [0.0, 0.4, 1.1, FRAC_PI_2] {
        let assembly = pendulum(1);
        let rate = hinged_bar::rate_squared(theta).sqrt();
        let state = assembly.state(&[-theta], &[-rate], &[]).expect("pinned");
        let motion = assembly.solve(&state, &[]).expect("regular");
        let along = Vector2::new(theta.cos(), -theta.sin());
        close(-motion.angular(0), hinged_bar::acceleration(theta), 1.0);
        close(-motion.pins[0].dot(&along), hinged_bar::force_along(theta), 1.0);
        close(
            motion.pins[0].dot(&Vector2::new(theta.sin(), theta.cos())),
            hinged_bar::force_across(theta),
            1.0,
        );
    }
}

#[test]
fn double_pendulum_equations() {
    for (angles, rates) in [([0.3, -1.2], [1.0, -2.0]), ([2.9, 0.1], [-3.0, 0.7])] {
        let mut assembly = pendulum(2);
        assembly.bodies = (0..2).map(|k| Body::uniform(["AB", "BC"][k], 0.5, 0.5)).collect();
        assembly.hinges[0].first = Mark::along(0, 0.5);
        let absolute = angles.map(|angle| angle - FRAC_PI_2);
        let state = assembly.state(&absolute, &rates, &[]).expect("pinned");
        let motion = assembly.solve(&state, &[]).expect("regular");
        let expected = double_pendulum::accelerations(0.5, 1.0, angles, rates);
        close(motion.angular(0), expected[0], 10.0);
        close(motion.angular(1), expected[1], 10.0);
        let carried = motion.linear(1) - assembly.gravity;
        close((motion.hinges[0] + carried * 0.5).norm(), 0.0, 10.0);
    }
}

#[test]
fn vanishing_support_leaves_its_share() {
    for offset in [0.1, 0.3, 0.5] {
        let (assembly, state) = level_rod(offset);
        let both = assembly.solve(&state, &[0, 1]).expect("regular");
        close(both.reactions[0], 0.5, 1.0);
        let one = assembly.solve(&state, &[1]).expect("regular");
        close(one.reactions[1], vanishing_support::reaction(offset, 1.0), 1.0);
        assert!(one.gap_accelerations[0] < 0.0 && one.reactions[0] == 0.0);
    }
}

#[test]
fn rod_on_three_supports_has_many_reactions_and_one_motion() {
    let (mut assembly, state) = level_rod(0.5);
    assembly.supports.push(scenes::floor("C", Mark::along(0, 0.5)));
    let motion = assembly.solve(&state, &[0, 1, 2]).expect("consistent");
    assert!(!motion.unique && motion.accelerations.amax() < ROUNDING);
    close(motion.reactions.iter().sum::<f64>(), 1.0, 1.0);
    close(motion.reactions[0], motion.reactions[1], 1.0);
}

#[test]
fn ladder_reactions() {
    let start = 75f64.to_radians();
    for theta in [1.2, 0.9, 0.75] {
        let rate = -ladder::rate_squared(start, theta).sqrt();
        let (assembly, state) = scenes::ladder(theta, rate);
        let motion = assembly.solve(&state, &[0, 1]).expect("regular");
        close(motion.reactions[0], ladder::floor_reaction(start, theta), 1.0);
        close(motion.reactions[1], ladder::wall_reaction(start, theta), 1.0);
    }
    let (assembly, state) = bar_over_floor(0.5, -ladder::free_rate_squared(start, 0.5).sqrt());
    let motion = assembly.solve(&state, &[0]).expect("regular");
    close(motion.reactions[0], ladder::free_floor_reaction(start, 0.5), 1.0);
}

#[test]
fn rod_falling_on_a_floor() {
    for tilt in [0.2, 0.8, 1.5] {
        let rate = rod_on_floor::rate_squared(0.01, tilt).sqrt();
        let (assembly, state) = bar_over_floor(FRAC_PI_2 - tilt, -rate);
        let motion = assembly.solve(&state, &[0]).expect("regular");
        close(-motion.angular(0), rod_on_floor::acceleration(0.01, tilt), 1.0);
        close(motion.reactions[0], rod_on_floor::reaction(0.01, tilt), 1.0);
    }
}

#[test]
fn a_frame_feet() {
    let start = 80f64.to_radians();
    for phi in [1.3, 0.6, 0.1] {
        let (assembly, state) = scenes::a_frame(phi, -a_frame::rate_squared(start, phi).sqrt());
        let motion = assembly.solve(&state, &[0, 1]).expect("regular");
        close(motion.reactions[0], 2.0 * a_frame::reaction(start, phi) - motion.reactions[1], 1.0);
        close(motion.reactions[0], a_frame::reaction(start, phi), 1.0);
    }
}

#[test]
fn falling_pair_at_the_published_lift_off() {
    let pair = FallingPair { m: 1.0, l: 1.0, g: 9.81 };
    let phi = 0.814_911_663_027_575_2;
    let state_at = |angle: f64| scenes::falling_pair(&pair, angle, pair.rate_squared(angle).sqrt());
    let (assembly, state) = state_at(phi);
    let motion = assembly.solve(&state, &[0, 1]).expect("regular");
    close(motion.angular(1), -2.576_941_642_996_128_5, 1.0);
    close(motion.angular(0), 2.576_941_642_996_128_5, 1.0);
    close(motion.reactions[0], 0.0, 9.81);
    close(assembly.solve(&state, &[]).expect("regular").angular(1), motion.angular(1), 1.0);
    for angle in [0.05, 0.4, 1.0] {
        let (assembly, state) = state_at(angle);
        let rate = pair.rate_squared(angle).sqrt();
        let motion = assembly.solve(&state, &[0, 1]).expect("regular");
        close(motion.angular(1), pair.acceleration(angle), 100.0);
        close(motion.reactions[1], pair.reaction(angle, rate), 100.0);
        close(assembly.kinetic_energy(&state), pair.constrained_energy(angle, rate), 10.0);
        close(assembly.kinetic_energy(&state) + assembly.potential_energy(&state), 0.0, 10.0);
        let free = assembly.solve(&state, &[]).expect("regular");
        close(free.angular(1), pair.free_accelerations(angle, rate)[0], 100.0);
    }
}

#[test]
fn zigzag_as_published() {
    let published = Zigzag { m1: 0.8, m2: 1.7, l: 0.6, g: 9.81, start: 1.4 };
    for phi in [0.2, 0.7, 1.2] {
        let rate = -published.rate_squared(phi).sqrt();
        let (mut assembly, state) = scenes::zigzag(&published, phi, rate);
        scenes::tie_all(&mut assembly);
        let motion = assembly.solve(&state, &[0, 1, 2]).expect("consistent");
        assert!(!motion.unique);
        close(motion.angular(2), published.acceleration(phi), 100.0);
        close(motion.reactions.iter().sum(), published.reaction(phi), 100.0);
        close(assembly.kinetic_energy(&state), published.constrained_energy(phi, rate), 10.0);
        let free = assembly.solve(&state, &[]).expect("regular");
        let h = published.free_integral(phi, rate);
        close(free.angular(2), published.free_acceleration(h, phi), 100.0);
        let rise = assembly.acceleration(&state, &free, assembly.end(1));
        close(-rise.y, published.free_drop_acceleration(h, phi), 100.0);
    }
}

#[test]
fn strict_zigzag_first_opens_where_the_references_say() {
    let cases = [
        (0.10, 0.532_700_146_712_482_3, 0),
        (0.25, 0.469_586_197_024_343_7, 0),
        (0.25, 0.469_586_197_024_343_7, 1),
        (0.50, 0.465_444_058_966_430_8, 1),
        (0.75, 0.467_603_096_309_552_3, 1),
        (0.90, 0.475_090_047_690_290_2, 1),
    ];
    for (lambda, phi, support) in cases {
        let published = Zigzag { m1: 1.0 - lambda, m2: lambda, l: 1.0, g: 1.0, start: FRAC_PI_2 };
        let reaction = |angle: f64| {
            let rate = -published.rate_squared(angle).sqrt();
            let (assembly, state) = scenes::zigzag(&published, angle, rate);
            assembly.solve(&state, &[0, 1, 2]).expect("regular").reactions[support]
        };
        close(root(reaction, 0.4, 0.7).expect("changes sign"), phi, 1.0);
    }
}

#[test]
fn strict_zigzag_motion_meets_the_references() {
    let published = Zigzag { m1: 0.5, m2: 0.5, l: 1.0, g: 1.0, start: FRAC_PI_2 };
    let phi = 0.465_444_058_966_430_8;
    let (assembly, state) = scenes::zigzag(&published, phi, -published.rate_squared(phi).sqrt());
    // Runge–Kutta with located ends: its error at this step, 1e-11, sets the tolerance
    let second = scenes::march(&assembly, state, &[0, 2], |state| {
        let motion = assembly.solve(state, &[0, 2]).expect("regular");
        motion.reactions[0]
    });
    let outer = |state: &liftoff_tests::oracle::State| state.angle(3);
    assert!((second.angle(2) - 0.393_614_602_129_259_2).abs() < 1e-10);
    assert!((-outer(&second) - 0.393_923_250_158_771_4).abs() < 1e-10);
    let touch = scenes::march(&assembly, second, &[], |state| assembly.position(state, assembly.end(0)).y);
    assert!((touch.angle(2) + 0.047_612_873_660_037).abs() < 1e-10);
    assert!((outer(&touch) - 0.019_804_336_202_524_3).abs() < 1e-10);
}

#[test]
fn struck_chain_shares_the_blow() {
    // entry 11 read as accelerations: a force P instead of the impulse, everything at rest
    let (mut assembly, state) = at_rest_from(2, &[0.0, 0.0]);
    assembly.loads.push(Load::constant(Mark::along(1, 1.0), Vector2::new(0.0, 1.0)));
    let motion = assembly.solve(&state, &[]).expect("regular");
    close(motion.hinges[0].y.abs(), 0.25, 1.0);
    close(assembly.acceleration(&state, &motion, Mark::along(1, 1.0)).y, 3.5, 1.0);
}

#[test]
fn insolvable_problems_are_reported() {
    let (mut assembly, state) = at_rest_from(1, &[0.3]);
    assembly.bodies[0].inertia = 0.0;
    assembly.bodies[0].mass = 0.0;
    assert_eq!(assembly.solve(&state, &[]).err(), Some(Unsolvable::Massless));
    let mut assembly = pendulum(2);
    assembly.pins.push(scenes::pin(Mark::along(1, 1.0), 2.0, 0.0));
    let state = assembly.state(&[0.0, 0.0], &[1.0, -1.0], &[]).expect("pinned");
    assert_eq!(assembly.solve(&state, &[]).err(), Some(Unsolvable::Contradictory));
    let folded = assembly.state(&[PI / 3.0, -PI / 3.0], &[0.0; 2], &[]).expect("pinned");
    assert!(assembly.residual(&folded) > 0.9);
}
