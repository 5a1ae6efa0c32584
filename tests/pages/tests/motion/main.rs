//! The page of a motion, driven as a reader does.

mod drawing;
mod models;
mod playing;
mod scrubbing;
mod views;

use liftoff::Trajectory;
use liftoff_pages::{Browser, Screen};
use liftoff_studio::animation::{About, page};
use std::io::Write;

/// A run, with its page in a browser.
struct Shown {
    record: Trajectory,
    browser: Browser,
    file: tempfile::NamedTempFile,
}

impl Shown {
    /// The page of a run, at rest at its start.
    fn at_rest(record: Trajectory) -> Self {
        Self::with(record, &[("prefers-reduced-motion", "reduce")])
    }

    /// The page of a run to a reader who prefers these things.
    fn with(record: Trajectory, preferences: &[(&str, &str)]) -> Self {
        let about = About { title: "A model", outputs: &["2 * E".to_owned()], ..About::default() };
        let html = page(&record, &about).unwrap();
        let mut file = tempfile::Builder::new().suffix(".html").tempfile().unwrap();
        file.write_all(html.as_bytes()).unwrap();
        let browser = Browser::open().unwrap();
        browser.screen(Screen::Desk).unwrap();
        browser.prefer(preferences).unwrap();
        browser.load(file.path()).unwrap();
        // Keys go where a reader has last clicked.
        browser.click("h1").unwrap();
        Self { record, browser, file }
    }

    /// The time that the page shows.
    fn t(&self) -> f64 {
        self.browser.number("document.querySelector('#clock').dataset.t").unwrap()
    }

    /// Waits until the page shows this time, so closely: what hands do takes effect when the
    /// browser comes to it.
    #[track_caller]
    fn comes_to(&self, t: f64, within: f64) {
        let distance = format!("Math.abs(Number(document.querySelector('#clock').dataset.t) - {t:e})");
        let came = self.browser.wait(&format!("{distance} <= {within:e}"));
        assert!(came.is_ok(), "it shows {} in place of {t}", self.t());
    }

    /// Goes to a time as a link to it does.
    fn go(&self, t: f64) {
        self.browser.script(&format!("location.hash = ''; location.hash = '#t={t:e}'")).unwrap();
        self.comes_to(t, 0.0);
    }

    fn events(&self) -> Vec<f64> {
        self.record.events().iter().map(|event| event.t).collect()
    }

    /// The place of a point of the model's plane on the picture.
    fn on_screen(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let view = |name: &str| {
            self.browser.number(&format!("document.querySelector('#stage').dataset.{name}")).unwrap()
        };
        [view("x") + view("k") * x, view("y") - view("k") * y]
    }

    /// The ends of the first path that a selector finds.
    fn ends(&self, selector: &str) -> [[f64; 2]; 2] {
        let path =
            self.browser.text(&format!("document.querySelector({selector:?}).getAttribute('d')")).unwrap();
        let numbers: Vec<f64> = path
            .split(|c: char| !(c.is_ascii_digit() || c == '.' || c == '-'))
            .filter_map(|number| number.parse().ok())
            .collect();
        let [x0, y0, x1, y1] = numbers[..] else { panic!("{path} is no line") };
        [[x0, y0], [x1, y1]]
    }

    /// Whether an element is there to be seen.
    fn visible(&self, selector: &str) -> bool {
        self.browser
            .script(&format!("return document.querySelector({selector:?}).style.display !== 'none'"))
            .unwrap()
            == true
    }
}

/// Whether two places are within so many pixels.
fn near(a: [f64; 2], b: [f64; 2], pixels: f64) -> bool {
    (a[0] - b[0]).hypot(a[1] - b[1]) <= pixels
}
