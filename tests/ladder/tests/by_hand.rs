//! What is derived against what is written by hand: two ways to the same few dozen operations,
//! hence 1e-12.

use falling_pair::FallingPair;
use liftoff::BarSystem;
use liftoff::Phases;
use liftoff::prelude::*;
use liftoff_ladder::{
    DroppedBar, FallingBar, FreeBar, Pendulum, SlungBar, SprungPendulum, StandingBar, by_hand,
};

use parallelogram::Parallelogram;
use slipping_rod::SlippingRod;
use zigzag::Zigzag;

#[path = "../../../models/systems/src/falling_pair.rs"]
mod falling_pair;
#[path = "../../../models/systems/src/parallelogram.rs"]
mod parallelogram;
#[path = "../../../models/systems/src/slipping_rod.rs"]
mod slipping_rod;
#[path = "../../../models/systems/src/zigzag.rs"]
mod zigzag;

fn compare<const N: usize>(derived: &[f64], by_hand: [f64; N]) {
    assert_eq!(derived.len(), N / 2);
    for (a, b) in derived.iter().zip(&by_hand[N / 2..]) {
        assert!((a - b).abs() <= 1e-12 * b.abs().max(1.0), "{derived:?}, by hand {by_hand:?}");
    }
}

#[test]
fn bars() {
    let state = [0.3, 0.4, 0.5, 0.6, 0.7, 0.8];
    compare(&FreeBar::SCENE.phase(&[]).unwrap().accelerations(&state), by_hand::free_bar::rates(&state));
    compare(
        &FallingBar::SCENE.phase(&[]).unwrap().accelerations(&state),
        by_hand::falling_bar::rates(&state),
    );
    compare(
        &DroppedBar::SCENE.phase(&[]).unwrap().accelerations(&state),
        by_hand::dropped_bar::rates(&state),
    );
}

#[test]
fn pendula() {
    let state = [0.7, -1.3];
    compare(&Pendulum::SCENE.phase(&[]).unwrap().accelerations(&state), by_hand::pendulum::rates(&state));
    let sprung = SprungPendulum::SCENE.phase(&[]).unwrap().accelerations(&state);
    compare(&sprung, by_hand::sprung_pendulum::rates(&state));
}

#[test]
fn a_bar_on_the_floor() {
    let (phi, w): (f64, f64) = (1.1, -0.8);
    let full = [phi, 0.2, 0.5 * phi.sin(), w, 0.4, 0.5 * w * phi.cos()];
    let phase = StandingBar::SCENE.phase(&["A"]).unwrap();
    let reduced = [phi, 0.2, w, 0.4];
    compare(&phase.reduced_accelerations(&full), by_hand::standing_bar::rates(&reduced));
    let reaction = by_hand::standing_bar::reaction(&reduced);
    assert!((phase.reactions(&full)[0] - reaction).abs() <= 1e-12 * reaction);
}

/// Moving along the ellipse: level under the eye, every rate but the vertical one is free.
#[test]
fn a_bar_on_a_thread() {
    let phase = SlungBar::SCENE.phase(&["rope"]).unwrap();
    let level = [0.0, 0.0, -2.0 / 3.0, 0.4, 0.9, 0.0];
    let tension = by_hand::slung_bar::tension(&level);
    assert!((phase.reactions(&level)[0] - tension).abs() <= 1e-12 * tension);
    let numbers = |k: usize| 2.0 * (0.618 * k as f64).fract() - 1.0;
    for k in 0..200 {
        // Every other bar is level or upright.
        let turn =
            if k % 2 == 0 { core::f64::consts::FRAC_PI_2 * (k / 2 % 4) as f64 } else { 3.0 * numbers(k) };
        let [x, y, w, u, v] = core::array::from_fn(|i| numbers(7 * k + i + 1));
        let state = [turn, x, y - 1.5, w, u, v];
        compare(&phase.accelerations(&state), by_hand::slung_bar::rates(&state));
        let tension = by_hand::slung_bar::tension(&state);
        assert!((phase.reactions(&state)[0] - tension).abs() <= 1e-12 * tension.abs().max(1.0));
    }
    assert_eq!(SlungBar::LAYOUT.contacts.len(), 1);
}

#[test]
fn the_papers_pair_of_bars() {
    let model = FallingPair { m: 1.0, l: 1.0, g: liftoff_ladder::GRAVITY };
    let (phi, w): (f64, f64) = (0.6, 1.7);
    let held = [phi, 0.5 * phi.tan(), w, 0.5 * w / phi.cos().powi(2)];
    let on_corners = model.phase(&["P", "Q"]).unwrap();
    compare(&on_corners.reduced_accelerations(&held), by_hand::fig_1a::held(&[phi, w]));
    // A contact and its image are one, which bears what both do.
    let reaction = 2.0 * by_hand::fig_1a::reaction(&[phi, w]);
    assert!((on_corners.reactions(&held)[0] - reaction).abs() <= 1e-12 * reaction.abs());
    let free = [phi, 0.8, w, -0.3];
    compare(&model.phase(&[]).unwrap().accelerations(&free), by_hand::fig_1a::free(&free));
}

#[test]
fn the_papers_four_bars() {
    let model = Zigzag { m1: 0.5, m2: 0.5, l: 1.0, g: liftoff_ladder::GRAVITY };
    let (phi, w): (f64, f64) = (0.9, -1.3);
    let all = [phi, phi, 0.0, w, w, 0.0];
    let phase = model.phase(&["A", "C", "E"]).unwrap();
    compare(&phase.accelerations(&all), by_hand::fig_1b::rates(&all, [true, true]));
    let (_, [half_c, e]) = by_hand::fig_1b::solve(&all, [true, true]);
    for (derived, by_hand) in phase.reactions(&all).iter().zip([2.0 * e, 2.0 * half_c]) {
        assert!((derived - by_hand).abs() <= 1e-12 * by_hand, "{derived}, by hand {by_hand}");
    }
    let (inner, outer, v): (f64, f64, f64) = (0.9, 0.7, 0.4);
    let on_ends = [inner, outer, outer.sin() - inner.sin(), w, v, v * outer.cos() - w * inner.cos()];
    let phase = model.phase(&["A", "E"]).unwrap();
    compare(&phase.accelerations(&on_ends), by_hand::fig_1b::rates(&on_ends, [false, true]));
    let free = [inner, outer, 0.3, w, v, -0.2];
    compare(&model.phase(&[]).unwrap().accelerations(&free), by_hand::fig_1b::rates(&free, [false; 2]));
}

#[test]
fn a_loop_of_four_bars() {
    let model = Parallelogram { m: 1.0, l: 1.0, c: 1.0, d: 2.0, g: liftoff_ladder::GRAVITY };
    let accelerations = model.phase(&[]).unwrap().accelerations(&[0.8, 0.8, 0.0, -1.1, -1.1, 0.0]);
    let [_, swing] = by_hand::four_bar::rates(&[0.8, -1.1]);
    compare(&accelerations, [0.0, 0.0, 0.0, swing, swing, 0.0]);
}

/// The foot slips back, then forward: times, angles and places of both, each integrated at 1e-9.
#[test]
fn a_rod_on_a_rough_floor() {
    let model =
        SlippingRod { m: 1.0, l: 1.0, mu: by_hand::rubbing_rod::FRICTION, g: liftoff_ladder::GRAVITY };
    let start = Pose::new("phi", 0.1);
    let run =
        Simulation::new(&model).unwrap().tolerance(1e-9).start(start).unwrap().limit(1.0).run().unwrap();
    let derived: Vec<f64> =
        run.events()[1..].iter().flat_map(|it| [it.t, it.state[0], it.state[1]]).collect();
    let by_hand = by_hand::rubbing_rod::run([0.1, 0.0], 1.0);
    let by_hand: Vec<f64> = by_hand.iter().flat_map(|(t, state)| [*t, state[0], state[1]]).collect();
    assert_eq!(derived.len(), by_hand.len());
    for (a, b) in derived.iter().zip(&by_hand) {
        assert!((a - b).abs() <= 1e-7, "{derived:?}, by hand {by_hand:?}");
    }
}
