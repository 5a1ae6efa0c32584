//! What is derived against what is written by hand: two ways to the same few dozen operations, hence 1e-12.

use liftoff::Phases;
use liftoff::model::BarSystem;
use liftoff_ladder::{
    DroppedBar, FallingBar, FreeBar, Pendulum, SlungBar, SprungPendulum, StandingBar, by_hand,
};

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
