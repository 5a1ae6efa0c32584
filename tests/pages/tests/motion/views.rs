//! Screens and hands: phones, pinches, followed systems, graphs chosen.

use super::models::{double_pendulum, dropped_bar, falling_pair};
use super::{Shown, near};
use liftoff::Trajectory;
use liftoff_pages::{Browser, Screen, check};
use liftoff_studio::registry::Configuration;

#[test]
#[ignore = "needs chromium and chromedriver"]
fn it_loads_without_complaint_and_fits_its_screen() {
    let records: [Trajectory; 3] = [dropped_bar(), falling_pair(), double_pendulum()];
    for record in records {
        let shown = Shown::at_rest(record);
        check(&shown.browser, shown.file.path()).unwrap();
    }
}

/// A page that breaks each rule in turn is caught, or the check above would say nothing.
#[test]
#[ignore = "needs chromium and chromedriver"]
fn flaws_of_pages_are_seen() {
    let browser = Browser::open().unwrap();
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("page.html");
    let flaw = |style: &str, body: &str| {
        let page = format!(
            "<!doctype html><meta name=viewport content=\"width=device-width\"><style>{style}</style>{body}"
        );
        std::fs::write(&file, page).unwrap();
        check(&browser, &file).map_err(|flaw| flaw.to_string())
    };
    let sound = ":root { color-scheme: light dark } body { background: #fff; color: #000 }
        @media (prefers-color-scheme: dark) { body { background: #000; color: #fff } }";
    assert_eq!(flaw(sound, "<p>Text"), Ok(()));
    let said = |style: &str, body: &str| flaw(style, body).unwrap_err();
    assert!(said(sound, "<script>nothing.there()</script>").contains("nothing is not defined"));
    assert!(
        said(sound, "<script>fetch('http://127.0.0.1:9/').catch(() => 0)</script>").contains("127.0.0.1")
    );
    assert!(said(sound, "<div style='width: 3000px'>wide</div>").contains("too wide: DIV"));
    assert!(said("body { background: #fff; color: #aaa }", "<p>Text").contains("stands out"));
    assert!(said("body { background: #fff; color: #000 }", "<p>Text").contains("the other scheme"));
}

#[test]
#[ignore = "needs chromium and chromedriver"]
fn buttons_are_large_enough_to_touch() {
    let shown = Shown::at_rest(dropped_bar());
    shown.browser.screen(Screen::Phone).unwrap();
    let least = shown
        .browser
        .number("Math.min(...[...document.querySelectorAll('.controls button')].map((button) => Math.min(button.offsetWidth, button.offsetHeight)))")
        .unwrap();
    assert!(least >= 36.0, "{least}");
}

#[test]
#[ignore = "needs chromium and chromedriver"]
fn two_fingers_zoom_about_their_middle() {
    let shown = Shown::at_rest(double_pendulum());
    shown.browser.screen(Screen::Phone).unwrap();
    shown.browser.load(shown.file.path()).unwrap();
    let scale = || shown.browser.number("document.querySelector('#stage').dataset.k").unwrap();
    let at = |x: f64| shown.browser.within("#stage", [x, 0.5]).unwrap();
    let before = scale();
    shown.browser.pinch([[at(0.4), at(0.3)], [at(0.6), at(0.7)]]).unwrap();
    let grown = scale() / before;
    assert!((grown - 2.0).abs() < 0.15, "{grown}");
}

#[test]
#[ignore = "needs chromium and chromedriver"]
fn a_system_that_is_followed_stays_in_place() {
    let shown = Shown::at_rest(dropped_bar());
    let middle = |t: f64| {
        let points = Configuration::from_run(&shown.record, t).points;
        [0, 1].map(|axis| points.iter().map(|point| point[axis]).sum::<f64>() / points.len() as f64)
    };
    let held = shown.on_screen(middle(0.0));
    shown.browser.click("#follow").unwrap();
    shown.go(0.4);
    assert!(near(shown.on_screen(middle(0.4)), held, 0.1));
    shown.browser.click("#follow").unwrap();
    shown.go(0.2);
    assert!(!near(shown.on_screen(middle(0.2)), held, 5.0));
}

#[test]
#[ignore = "needs chromium and chromedriver"]
fn graphs_and_curves_are_chosen() {
    let shown = Shown::at_rest(dropped_bar());
    let panels = || {
        shown
            .browser
            .number("[...document.querySelectorAll('.panel')].filter((panel) => panel.clientHeight).length")
            .unwrap()
    };
    let before = panels();
    shown.browser.script("[...document.querySelectorAll('#groups button')].find((button) => button.textContent === 'Gaps').id = 'gaps'").unwrap();
    shown.browser.click("#gaps").unwrap();
    assert_eq!(panels(), before + 1.0);
    let curve = "document.querySelector('[data-quantity=\"gap(A)\"]').closest('.panel').querySelector('.paper .curve').getAttribute('d')";
    assert!(shown.browser.text(curve).unwrap().starts_with('M'));
    shown.browser.click("[data-quantity=\"gap(A)\"]").unwrap();
    assert_eq!(shown.browser.text(curve).unwrap(), "");
    shown.browser.click("#gaps").unwrap();
    assert_eq!(panels(), before);
}
