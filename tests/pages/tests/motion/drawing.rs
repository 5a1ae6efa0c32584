//! What the picture shows, against the record.

use super::models::{double_pendulum, dropped_bar, falling_pair, wheels};
use super::{Shown, near};
use liftoff::EventKind;
use liftoff_studio::registry::Configuration;

/// Bars stand between the record's points, to a tenth of a pixel: that is what a hundredth on
/// either axis, and a cubic off by 1e-5 of some hundred pixels, leave room for.
fn bars_stand_where_they_are(shown: &Shown, times: &[f64]) {
    let layout = shown.record.layout();
    for &t in times {
        shown.go(t);
        let still = Configuration::from_run(&shown.record, t);
        for bar in layout.bars {
            let ends = shown.ends(&format!("[data-body={}]", bar.name));
            for (drawn, point) in ends.into_iter().zip([bar.from, bar.to]) {
                let expected = shown.on_screen(still.points[point]);
                assert!(near(drawn, expected, 0.1), "{} at {t}: {drawn:?}, not {expected:?}", bar.name);
            }
        }
    }
}

#[test]
#[ignore = "needs chromium and chromedriver"]
fn bars_stand_between_the_records_points() {
    let shown = Shown::at_rest(double_pendulum());
    bars_stand_where_they_are(&shown, &[0.0, 0.1, 1.234, 5.5, 9.99, 10.0]);
    let shown = Shown::at_rest(dropped_bar());
    let impact = shown.events()[1];
    bars_stand_where_they_are(&shown, &[0.2, impact - 1e-6, impact, impact + 1e-6, 1.0, 2.9]);
}

#[test]
#[ignore = "needs chromium and chromedriver"]
fn bars_stand_where_they_are_in_a_view_that_was_moved() {
    let shown = Shown::at_rest(double_pendulum());
    let at = |x: f64, y: f64| shown.browser.within("#stage", [x, y]).unwrap();
    let fitted = shown.on_screen([0.0, 0.0]);
    shown.browser.drag(&[at(0.5, 0.5), at(0.6, 0.55)]).unwrap();
    let moved = shown.on_screen([0.0, 0.0]);
    let [from, to] = [at(0.5, 0.5), at(0.6, 0.55)];
    assert!(near([moved[0] - fitted[0], moved[1] - fitted[1]], [to[0] - from[0], to[1] - from[1]], 2.0));
    shown.browser.wheel("#stage", -300).unwrap();
    bars_stand_where_they_are(&shown, &[0.3, 4.0]);
    shown.browser.click("#fit").unwrap();
    assert!(near(shown.on_screen([0.0, 0.0]), fitted, 0.01));
}

#[test]
#[ignore = "needs chromium and chromedriver"]
fn a_reaction_stands_across_its_bar_and_ends_when_its_support_opens() {
    let shown = Shown::at_rest(falling_pair());
    let opens = shown.record.events().iter().find(|event| event.kind == EventKind::Open).unwrap().t;
    shown.go(0.5 * opens);
    let [tail, neck] = shown.ends("[data-reaction=P] .shaft");
    assert!(near(tail, shown.on_screen([-0.5, 0.0]), 0.1));
    let [a, d] = shown.ends("[data-body=AD]");
    let [force, bar] = [[neck[0] - tail[0], neck[1] - tail[1]], [d[0] - a[0], d[1] - a[1]]];
    let across = (force[0] * bar[0] + force[1] * bar[1]) / (force[0].hypot(force[1]) * bar[0].hypot(bar[1]));
    assert!(across.abs() < 1e-2 && force[1] < 0.0, "{force:?} on {bar:?}");
    for support in ["P", "Q"] {
        assert!(shown.visible(&format!("[data-reaction={support}]")));
    }
    shown.go(opens + 1e-3);
    for support in ["P", "Q"] {
        assert!(!shown.visible(&format!("[data-reaction={support}]")));
        let class = format!("document.querySelector('[data-contact={support}]').getAttribute('class')");
        assert_eq!(shown.browser.text(&class).unwrap(), "open");
    }
}

/// Of two forces the arrows are as long as the forces are large.
#[test]
#[ignore = "needs chromium and chromedriver"]
fn arrows_are_as_long_as_reactions_are_large() {
    let shown = Shown::at_rest(falling_pair());
    let reaction = shown.record.function("N(P)").unwrap();
    let length = |t: f64| {
        shown.go(t);
        let head = "document.querySelector('[data-reaction=P] .head').getAttribute('d').split(/[ML]/)[2].split(' ').map(Number)";
        let tip = [0, 1].map(|i| shown.browser.number(&format!("{head}[{i}]")).unwrap());
        let [tail, _] = shown.ends("[data-reaction=P] .shaft");
        (tip[0] - tail[0]).hypot(tip[1] - tail[1])
    };
    let (early, late) = (0.1, 0.7);
    let (drawn, true_ratio) = (length(late) / length(early), reaction(late) / reaction(early));
    assert!((drawn - true_ratio).abs() < 1e-2, "{drawn} for {true_ratio}");
}

#[test]
#[ignore = "needs chromium and chromedriver"]
fn an_impact_shows_its_impulse_at_its_moment() {
    let shown = Shown::at_rest(dropped_bar());
    let impact = shown.record.events().iter().find(|event| event.kind == EventKind::Impact).unwrap();
    let support = impact.supports[0];
    let first = format!("[data-impulse={support}]");
    assert!(!shown.visible(&first));
    shown.go(impact.t);
    assert!(shown.visible(&first));
    let [tail, neck] = shown.ends(&format!("{first} .shaft"));
    assert!((tail[0] - neck[0]).abs() < 0.02 && neck[1] < tail[1]);
    shown.browser.click("#reactions").unwrap();
    assert!(!shown.visible("#stage .forces"));
    shown.browser.click("#reactions").unwrap();
    shown.go(impact.t + 0.1);
    assert!(!shown.visible(&first));
}

#[test]
#[ignore = "needs chromium and chromedriver"]
fn a_trail_ends_at_its_point() {
    let shown = Shown::at_rest(double_pendulum());
    shown.browser.click("#trails").unwrap();
    shown.go(3.3);
    let tip = shown
        .browser
        .text("document.querySelector('[data-trail=B] path:last-child').getAttribute('d').split(/[ C]/).slice(-2)")
        .unwrap();
    let place: Vec<f64> = tip.split(',').filter_map(|x| x.parse().ok()).collect();
    let expected = Configuration::from_run(&shown.record, 3.3).points[2];
    // The size of the scene is four lengths.
    assert!(near([place[0], place[1]], expected, 4.0 * 2e-5), "{place:?}, not {expected:?}");
}

/// The wheel has turned by −2 t; the floor pushes where its rim touches, 0.2 below its centre.
#[test]
#[ignore = "needs chromium and chromedriver"]
fn discs_turn_with_their_bodies_and_touch_with_their_rims() {
    let shown = Shown::at_rest(wheels());
    shown.go(0.6);
    let (centre, turned) = ([0.4 * 0.6, 0.2], -2.0_f64 * 0.6);
    let [from, to] = shown.ends("[data-spoke=H]");
    let rim = [centre[0] - 0.2 * turned.sin(), centre[1] + 0.2 * turned.cos()];
    assert!(
        near(from, shown.on_screen(centre), 0.1) && near(to, shown.on_screen(rim), 0.1),
        "{from:?} {to:?}"
    );
    let [tail, _] = shown.ends("[data-reaction=H] .shaft");
    assert!(near(tail, shown.on_screen([centre[0], 0.0]), 0.1), "{tail:?}");
    let radius = |round: &str| {
        let selector = format!("document.querySelector('[data-round={round}]')");
        let k = shown.browser.number("document.querySelector('#stage').dataset.k").unwrap();
        shown.browser.number(&format!("{selector}.getAttribute('r')")).unwrap() / k
    };
    assert!((radius("H") - 0.2).abs() < 1e-4 && (radius("P") - 0.1).abs() < 1e-4);
    // The ring of the bead is a line: nothing is hatched but the floor.
    assert_eq!(shown.browser.number("document.querySelectorAll('.scenery .solid').length").unwrap(), 1.0);
    assert_eq!(shown.browser.number("document.querySelectorAll('.scenery .guide').length").unwrap(), 1.0);
}
