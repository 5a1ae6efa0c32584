//! Moving through the motion by hand: the bar of time, the graphs, the list of events.

use super::Shown;
use super::models::{double_pendulum, dropped_bar};
use liftoff_pages::Screen;

/// Where a graph's paper begins and ends, in its own pixels from left and right.
const PAD: [f64; 2] = [58.0, 10.0];

#[test]
#[ignore = "needs chromium and chromedriver"]
fn dragging_the_bar_of_time_moves_through_the_motion() {
    let shown = Shown::at_rest(double_pendulum());
    let at = |part: f64| shown.browser.within("#scrubber svg", [part, 0.5]).unwrap();
    let width = at(1.0)[0] - at(0.0)[0];
    shown.browser.drag(&[at(0.1), at(0.4), at(0.75)]).unwrap();
    // Pointers stand on whole pixels.
    shown.comes_to(7.5, 10.0 / width);
    shown.browser.drag(&[at(0.5), at(1.5)]).unwrap();
    shown.comes_to(10.0, 0.0);
}

#[test]
#[ignore = "needs chromium and chromedriver"]
fn a_drag_on_a_graph_moves_its_cursor_and_the_time() {
    let shown = Shown::at_rest(double_pendulum());
    let paper = |part: f64| shown.browser.within(".panel .paper", [part, 0.5]).unwrap();
    let [left, right] = [paper(0.0)[0] + PAD[0], paper(1.0)[0] - PAD[1]];
    let at = |part: f64| [left + part * (right - left), paper(0.5)[1]];
    shown.browser.drag(&[at(0.9), at(0.5), at(0.3)]).unwrap();
    shown.comes_to(3.0, 10.0 / (right - left));
    let t = shown.t();
    let cursor = shown.cursor();
    assert!((paper(0.0)[0] + cursor - (left + t / 10.0 * (right - left))).abs() < 1.0, "{cursor}");
}

impl Shown {
    /// Where the first graph's cursor stands.
    fn cursor(&self) -> f64 {
        let d = self.browser.text("document.querySelector('.cursor').getAttribute('d')").unwrap();
        d[1..].split(' ').next().and_then(|x| x.parse().ok()).unwrap()
    }
}

#[test]
#[ignore = "needs chromium and chromedriver"]
fn a_finger_drags_time_and_graphs_on_a_phone() {
    let shown = Shown::at_rest(double_pendulum());
    shown.browser.screen(Screen::Phone).unwrap();
    shown.browser.load(shown.file.path()).unwrap();
    let at = |part: f64| shown.browser.within("#scrubber svg", [part, 0.5]).unwrap();
    let width = at(1.0)[0] - at(0.0)[0];
    shown.browser.swipe(&[at(0.1), at(0.3), at(0.6)]).unwrap();
    shown.comes_to(6.0, 10.0 / width);
    let paper = |part: f64| shown.browser.within(".panel .paper", [part, 0.5]).unwrap();
    let [left, right] = [paper(0.0)[0] + PAD[0], paper(1.0)[0] - PAD[1]];
    shown.browser.swipe(&[[left, paper(0.0)[1]], [(left + right) / 2.0, paper(0.0)[1]]]).unwrap();
    shown.comes_to(5.0, 10.0 / (right - left));
}

#[test]
#[ignore = "needs chromium and chromedriver"]
fn a_click_on_an_event_goes_to_its_very_time() {
    let shown = Shown::at_rest(dropped_bar());
    let events = shown.events();
    assert!(events.len() > 8);
    for (i, t) in events.iter().enumerate().take(9) {
        let row = format!("#events li:nth-child({}) button", i + 1);
        shown.browser.click(&row).unwrap();
        shown.comes_to(*t, 0.0);
        let last = events.iter().rposition(|other| other == t).unwrap();
        let marked = shown.browser.number(
            "[...document.querySelectorAll('#events button')].findIndex((row) => row.ariaCurrent === 'true')",
        );
        assert_eq!(marked.unwrap(), last as f64);
    }
}

#[test]
#[ignore = "needs chromium and chromedriver"]
fn the_key_shows_the_values_at_the_cursor() {
    let shown = Shown::at_rest(dropped_bar());
    for t in [0.0, 0.3, 1.0, 2.5] {
        shown.go(t);
        for name in ["phi", "y", "N(A)", "E", "2 * E"] {
            let value = shown.record.function(name).unwrap()(t);
            let told = shown.browser.number(&format!(
                "document.querySelector('[data-quantity=\"{name}\"] output').dataset.value"
            ));
            let told = told.unwrap();
            // The sizes of all these are below 20.
            assert!((told - value).abs() < 20.0 * 1e-5, "{name} at {t}: {told} for {value}");
        }
    }
}
