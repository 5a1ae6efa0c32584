//! Playing, pausing, stepping.

use super::Shown;
use super::models::{double_pendulum, dropped_bar};
use liftoff_pages::Key;
use std::thread::sleep;
use std::time::Duration;

#[test]
#[ignore = "needs chromium and chromedriver"]
fn it_plays_by_itself_unless_motion_is_unwelcome() {
    let shown = Shown::with(double_pendulum(), &[]);
    shown.browser.wait("Number(document.querySelector('#clock').dataset.t) > 0.05").unwrap();
    let calm = Shown::at_rest(double_pendulum());
    sleep(Duration::from_millis(300));
    assert_eq!(calm.t(), 0.0);
}

#[test]
#[ignore = "needs chromium and chromedriver"]
fn play_moves_time_and_pause_stops_it() {
    let shown = Shown::at_rest(double_pendulum());
    shown.browser.click("#play").unwrap();
    shown.browser.wait("Number(document.querySelector('#clock').dataset.t) > 0.2").unwrap();
    shown.browser.click("#play").unwrap();
    shown.browser.wait("!document.body.classList.contains('playing')").unwrap();
    let t = shown.t();
    sleep(Duration::from_millis(200));
    assert_eq!(shown.t(), t);
    assert_eq!(
        shown.browser.text("document.querySelector('#play').getAttribute('aria-label')").unwrap(),
        "Play"
    );
}

/// Ten seconds take ten seconds: real time, while the page is drawn.
#[test]
#[ignore = "needs chromium and chromedriver"]
fn it_plays_in_real_time_and_at_the_speed_chosen() {
    let shown = Shown::at_rest(double_pendulum());
    let pace = || {
        shown
            .browser
            .script(
                "const clock = document.querySelector('#clock'), [t, now] = [clock.dataset.t, performance.now()];
                 return new Promise((done) => setTimeout(() => done((clock.dataset.t - t) / (performance.now() - now) * 1000), 1000));",
            )
            .unwrap()
            .as_f64()
            .unwrap()
    };
    shown.browser.press(&[Key::Sign(' ')]).unwrap();
    let real = pace();
    shown.browser.press(&[Key::Sign('+')]).unwrap();
    let twice = pace();
    // A loaded machine drops frames; the page then falls behind, never ahead.
    assert!(real > 0.5 && real < 1.1, "{real}");
    assert!(twice > 1.2 * real, "{twice} after {real}");
    assert_eq!(shown.browser.text("document.querySelector('#speed').textContent").unwrap(), "2 ×");
}

#[test]
#[ignore = "needs chromium and chromedriver"]
fn the_end_stops_it_and_a_loop_does_not() {
    let shown = Shown::at_rest(dropped_bar());
    shown.go(2.9);
    shown.browser.press(&[Key::Sign(' ')]).unwrap();
    shown.browser.wait("Number(document.querySelector('#clock').dataset.t) === 3").unwrap();
    shown.browser.wait("!document.body.classList.contains('playing')").unwrap();
    shown.browser.press(&[Key::Sign('l')]).unwrap();
    shown.go(2.9);
    shown.browser.press(&[Key::Sign(' ')]).unwrap();
    shown.browser.wait("Number(document.querySelector('#clock').dataset.t) < 1").unwrap();
}

#[test]
#[ignore = "needs chromium and chromedriver"]
fn keys_step_by_frames_and_events() {
    let shown = Shown::at_rest(dropped_bar());
    let events = shown.events();
    let press = |keys: &[Key]| shown.browser.press(keys).unwrap();
    press(&[Key::Right]);
    shown.comes_to(1.0 / 30.0, 1e-12);
    press(&[Key::Left]);
    shown.comes_to(0.0, 0.0);
    press(&[Key::Shift, Key::Right]);
    shown.comes_to(events[1], 0.0);
    press(&[Key::Shift, Key::Right]);
    shown.comes_to(events[2], 0.0);
    press(&[Key::Shift, Key::Left]);
    shown.comes_to(events[1], 0.0);
    press(&[Key::End]);
    shown.comes_to(3.0, 0.0);
    press(&[Key::Home]);
    shown.comes_to(0.0, 0.0);
}

#[test]
#[ignore = "needs chromium and chromedriver"]
fn buttons_step_by_frames_and_events() {
    let shown = Shown::at_rest(dropped_bar());
    let events = shown.events();
    shown.browser.click("#to-next").unwrap();
    shown.comes_to(events[1], 0.0);
    shown.browser.click("#back").unwrap();
    shown.comes_to(events[1] - 1.0 / 30.0, 1e-12);
    shown.browser.click("#forth").unwrap();
    shown.browser.click("#to-previous").unwrap();
    shown.comes_to(0.0, 0.0);
}

#[test]
#[ignore = "needs chromium and chromedriver"]
fn help_opens_and_closes() {
    let shown = Shown::at_rest(dropped_bar());
    shown.browser.press(&[Key::Sign('?')]).unwrap();
    shown.browser.wait("document.querySelector('#keys').open").unwrap();
    shown.browser.click("#keys button").unwrap();
    shown.browser.wait("!document.querySelector('#keys').open").unwrap();
}
