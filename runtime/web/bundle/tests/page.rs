//! The page in a browser, as a reader uses it. It is that of `target/liftoff/web`, which `cargo run --release -p liftoff-web-bundle` writes,
//! or the one that `LIFTOFF_WEB` names.

use liftoff_pages::{Browser, Screen};
use liftoff_studio::animation::About;
use liftoff_studio::animation::live::{Engine, Packed, page};
use liftoff_studio::source;
use liftoff_web_bundle::gallery;
use std::path::PathBuf;

fn file() -> PathBuf {
    let made = concat!(env!("CARGO_MANIFEST_DIR"), "/../../../target/liftoff/web/index.html");
    std::env::var_os("LIFTOFF_WEB").map_or_else(|| made.into(), PathBuf::from)
}

fn opened(screen: Screen) -> Browser {
    let browser = Browser::open().unwrap();
    browser.screen(screen).unwrap();
    browser.load(&file()).unwrap();
    moved(&browser, 1);
    browser
}

const MOTIONS: &str = "Number(document.body.dataset.motions ?? 0)";
const EVENTS: &str = "document.querySelector('#happened').textContent";

/// Waits until so many motions have been shown.
#[track_caller]
fn moved(browser: &Browser, least: u32) {
    browser.wait(&format!("{MOTIONS} >= {least}")).unwrap();
}

/// Puts a value into the slider of a name, as dragging it does.
fn slide(browser: &Browser, name: &str, value: f64) {
    let body = format!(
        "const slider = document.querySelector('input[type=range][data-name=\"{name}\"]');
         slider.value = {value}; slider.dispatchEvent(new Event('input', {{ bubbles: true }}));"
    );
    browser.script(&body).unwrap();
}

#[test]
#[ignore = "needs chromium, chromedriver and the page"]
fn the_first_support_to_open_changes_as_the_slider_is_dragged() {
    let browser = opened(Screen::Desk);
    let second = || browser.text(&format!("{EVENTS}.split('start')[1] ?? ''")).unwrap();
    browser.wait(&format!("{EVENTS}.includes('C open')")).unwrap();
    slide(&browser, "lambda", 0.1);
    browser.wait(&format!("/φ|phi/.test({EVENTS}) && {EVENTS}.indexOf('A, E open') >= 0 && {EVENTS}.indexOf('A, E open') < ({EVENTS}.indexOf('C open') + 1 || 1e9)")).unwrap();
    assert!(second().contains("A, E open"), "{}", second());
    slide(&browser, "lambda", 0.75);
    browser
        .wait(&format!(
            "{EVENTS}.indexOf('C open') >= 0 && {EVENTS}.indexOf('C open') < {EVENTS}.indexOf('A, E open')"
        ))
        .unwrap();
    assert_eq!(browser.complaints().unwrap(), [""; 0]);
    let asked = browser.requests().unwrap();
    assert!(
        asked.iter().all(|at| ["file:", "blob:", "data:", "about:"].iter().any(|own| at.starts_with(own))),
        "{asked:?}"
    );
}

#[test]
#[ignore = "needs chromium, chromedriver and the page"]
fn every_model_of_the_gallery_moves() {
    let browser = opened(Screen::Desk);
    for (k, (name, _)) in gallery().iter().enumerate().skip(1) {
        let before = browser.number(MOTIONS).unwrap();
        let body = format!(
            "const list = document.querySelector('#gallery'); list.value = {name:?}; list.dispatchEvent(new Event('change'));"
        );
        browser.script(&body).unwrap();
        moved(&browser, before as u32 + 1);
        assert_eq!(browser.text("document.querySelector('#wrong').textContent").unwrap(), "", "{k} {name}");
    }
    browser.script("document.querySelector('#derived').open = true").unwrap();
    browser.wait("document.querySelector('#equations math')").unwrap();
    assert_eq!(browser.complaints().unwrap(), [""; 0]);
}

#[test]
#[ignore = "needs chromium, chromedriver and the page"]
fn mistakes_are_reported_under_their_words_and_the_motion_stays() {
    let browser = opened(Screen::Desk);
    browser.script("editor.replace(editor.text().replace('from = horizontal', 'from = nowhere'))").unwrap();
    browser.wait("document.querySelector('#wrong').textContent.includes('nowhere')").unwrap();
    browser.wait("document.querySelector('.cm-lintRange-error')").unwrap();
    assert!(browser.script("return document.querySelectorAll('#player iframe').length").unwrap() == 1);
    browser.script("editor.replace(editor.text().replace('nowhere', 'horizontal'))").unwrap();
    browser.wait("document.querySelector('#wrong').hidden").unwrap();
}

#[test]
#[ignore = "needs chromium, chromedriver and the page"]
fn a_link_is_data() {
    let browser = opened(Screen::Desk);
    slide(&browser, "lambda", 0.25);
    browser.script("document.querySelector('#share').click()").unwrap();
    browser.wait("location.hash.length > 100").unwrap();
    let hash = browser.text("location.hash").unwrap();
    let hostile = "btoa(JSON.stringify({ text: '/// </script><script>window.hurt = 1</script><img src=x onerror=\"hurt=1\">\\n\
                   #[derive(BarSystem)] #[bar(OA, mass = 1, length = 1)] #[pin(O = (0, 0))] #[gravity(1)] #[figure(A = (0, -1))] \
                   #[run(start = \"theta_OA = 0\", limit = 1)] struct Swing {}', set: { m: '<b>', __proto__: { hurt: 1 } } }))";
    let body = format!("location.hash = {hostile}; location.reload();");
    browser.script(&body).unwrap();
    moved(&browser, 1);
    assert_eq!(browser.text("window.hurt").unwrap(), "undefined");
    browser.script(&format!("location.hash = {hash:?}; location.reload();")).unwrap();
    browser
        .wait("document.querySelector('input[type=range][data-name=\"lambda\"]')?.value === '0.25'")
        .unwrap();
}

#[test]
#[ignore = "needs chromium, chromedriver and the page"]
fn what_takes_long_can_be_stopped() {
    let browser = opened(Screen::Desk);
    browser.script("editor.replace(editor.text().replace('limit = 5', 'limit = 1e7').replaceAll('stop)', 'restitution = 1)'))").unwrap();
    browser.wait("!document.querySelector('#stop').hidden").unwrap();
    browser.script("document.querySelector('#stop').click()").unwrap();
    browser.wait("document.querySelector('#told').textContent === 'stopped'").unwrap();
    let before = browser.number(MOTIONS).unwrap();
    browser.script("editor.replace(gallery[2].text)").unwrap();
    moved(&browser, before as u32 + 1);
}

#[test]
#[ignore = "needs chromium, chromedriver and the page"]
fn it_fits_a_phone() {
    let browser = opened(Screen::Phone);
    let wide = browser.number("document.documentElement.scrollWidth - innerWidth").unwrap();
    assert!(wide <= 0.0, "{wide} too wide");
}

/// The page of a motion with sliders; the engine in it or in a script beside it.
#[test]
#[ignore = "needs chromium, chromedriver and the page"]
fn a_motion_follows_its_sliders() {
    let packed = Packed::new(&std::fs::read(file()).unwrap()).unwrap();
    let models = source::models(gallery()[1].1).unwrap_or_default();
    let model = models.first().expect("a model");
    let spec = model.default_run();
    let record = model.run(&spec).unwrap();
    let about = About { title: "Two bars", parameters: &spec.parameters, ..About::default() };
    let place = tempfile::tempdir().unwrap();
    std::fs::write(place.path().join("engine.js"), packed.script()).unwrap();
    let browser = Browser::open().unwrap();
    let motion = "document.querySelector('#player iframe').contentDocument";
    for (name, engine) in [("within", Engine::Within(&packed)), ("beside", Engine::Beside("engine.js"))] {
        let at = place.path().join(format!("{name}.html"));
        std::fs::write(&at, page(model, &spec, &record, &about, engine).unwrap()).unwrap();
        browser.load(&at).unwrap();
        browser.wait(&format!("{motion}.querySelectorAll('#events li').length")).unwrap();
        let parameters =
            || browser.text(&format!("{motion}.querySelector('.parameters').textContent")).unwrap();
        let before = parameters();
        slide(&browser, "l", 1.5);
        moved(&browser, 1);
        assert!(parameters().contains("l = 1.5") && !before.contains("l = 1.5"), "{before} {}", parameters());
        // A second motion takes the place of the first, played on from there and shown as it was.
        browser
            .script(&format!(
                "{motion}.querySelector('#trails').click(); {motion}.querySelector('#play').click()"
            ))
            .unwrap();
        slide(&browser, "l", 0.5);
        moved(&browser, 2);
        assert!(parameters().contains("l = 0.5"));
        assert_eq!(browser.text(&format!("{motion}.querySelector('#trails').ariaPressed")).unwrap(), "true");
        assert_eq!(browser.text(&format!("{motion}.querySelectorAll('#stage').length")).unwrap(), "1");
        assert_eq!(browser.complaints().unwrap(), [""; 0]);
    }
}
