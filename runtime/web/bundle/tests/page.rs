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
        choose(&browser, name);
        moved(&browser, before as u32 + 1);
        assert_eq!(browser.text("document.querySelector('#wrong').textContent").unwrap(), "", "{k} {name}");
    }
    browser.script("document.querySelector('[aria-controls=derived]').click()").unwrap();
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

/// Chooses a model, as its list does.
fn choose(browser: &Browser, name: &str) {
    let body = format!(
        "const list = document.querySelector('#gallery'); list.value = {name:?}; list.dispatchEvent(new Event('change'));"
    );
    browser.script(&body).unwrap();
}

/// Whatever scrolls, nothing around it does, and the page itself stands still.
#[test]
#[ignore = "needs chromium, chromedriver and the page"]
fn it_fits_its_screen_and_nothing_scrolls_within_what_scrolls() {
    for screen in [Screen::Desk, Screen::Phone] {
        let browser = opened(screen);
        for view in ["text", "moving", "happened", "derived", "drawing"] {
            browser.script(&format!("document.querySelector('[aria-controls={view}]').click()")).unwrap();
            let excess = browser.text(
                "[document.documentElement.scrollWidth - innerWidth, document.documentElement.scrollHeight - innerHeight]",
            );
            assert_eq!(excess.unwrap(), "0,0", "{view} on a {screen:?}");
            let nested = browser.text(
                "[...document.querySelectorAll('body *')].filter((node) => {
                   const scrolls = (box) => box && box !== document.documentElement
                     && (/auto|scroll/.test(getComputedStyle(box).overflowY) && box.scrollHeight > box.clientHeight + 1 || scrolls(box.parentElement) === true);
                   const frame = node.tagName === 'IFRAME', own = getComputedStyle(node).overflowY;
                   return (frame || /auto|scroll/.test(own) && node.scrollHeight > node.clientHeight + 1) && scrolls(node.parentElement);
                 }).map((node) => node.id || node.tagName).join()",
            );
            assert_eq!(nested.unwrap(), "", "{view} on a {screen:?}");
            let seen = format!("getComputedStyle(document.querySelector('#{view}')).visibility");
            assert_eq!(browser.text(&seen).unwrap(), "visible", "{view} on a {screen:?}");
        }
    }
}

#[test]
#[ignore = "needs chromium, chromedriver and the page"]
fn what_is_typed_outlives_a_reload_and_is_undone_and_done_again() {
    let browser = opened(Screen::Desk);
    let text = || browser.text("editor.text()").unwrap();
    let lambda =
        || browser.text("document.querySelector('input[type=range][data-name=lambda]')?.value").unwrap();
    let first = text();
    slide(&browser, "lambda", 0.25);
    browser.script("document.querySelector('#sliders').dispatchEvent(new Event('change'))").unwrap();
    browser.script("editor.replace(`// mine\n${editor.text()}`)").unwrap();
    browser.script("location.reload()").unwrap();
    browser.wait("document.querySelector('#undo')?.disabled === false").unwrap();
    moved(&browser, 1);
    assert_eq!((text(), lambda()), (format!("// mine\n{first}"), "0.25".to_owned()));
    assert_eq!(
        browser.text("document.querySelector('#gallery').selectedOptions[0].label").unwrap(),
        "(your text)"
    );
    choose(&browser, "Ladder");
    browser.wait("editor.text().includes('struct Ladder')").unwrap();
    moved(&browser, 2);
    browser.click("#undo").unwrap();
    assert_eq!(text(), format!("// mine\n{first}"));
    browser.wait("document.querySelector('input[type=range][data-name=lambda]')?.value === '0.25'").unwrap();
    browser.click("#undo").unwrap();
    assert_eq!(text(), first);
    browser.click("#undo").unwrap();
    browser.wait("document.querySelector('input[type=range][data-name=lambda]')?.value === '0.5'").unwrap();
    assert_eq!(browser.text("document.querySelector('#undo').disabled").unwrap(), "true");
    for _ in 0..3 {
        browser.click("#redo").unwrap();
    }
    browser.wait("editor.text().includes('struct Ladder')").unwrap();
    assert_eq!(browser.complaints().unwrap(), [""; 0]);
}

#[test]
#[ignore = "needs chromium, chromedriver and the page"]
fn angles_are_in_degrees_and_values_are_reset() {
    let browser = opened(Screen::Desk);
    let number = |name: &str| {
        browser
            .text(&format!("document.querySelector('input[type=number][data-name={name}]').value"))
            .unwrap()
    };
    assert_eq!([number("phi_inner"), number("lambda"), number("y")], ["85", "0.5", ""]);
    assert_eq!(browser.text("document.querySelector('#reset').hidden").unwrap(), "true");
    for (name, value) in [("phi_inner", 60.0), ("phi_outer", 60.0), ("lambda", 0.25)] {
        slide(&browser, name, value);
    }
    assert_eq!(browser.number("chosen.start.phi_inner").unwrap(), 60_f64.to_radians());
    browser.wait(&format!("{EVENTS}.includes('start at t = 0, phi_inner = 1.047')")).unwrap();
    browser.click("#reset").unwrap();
    browser.wait(&format!("{EVENTS}.includes('start at t = 0, phi_inner = 1.484')")).unwrap();
    assert_eq!([number("phi_inner"), number("lambda"), number("y")], ["85", "0.5", ""]);
    assert_eq!(browser.text("document.querySelector('#reset').hidden").unwrap(), "true");
}

#[test]
#[ignore = "needs chromium, chromedriver and the page"]
fn the_motion_is_downloaded_as_it_is_shown() {
    let browser = opened(Screen::Desk);
    slide(&browser, "lambda", 0.25);
    browser
        .script(
            "URL.createObjectURL = (blob) => (blob.text().then((text) => (window.saved = text)), 'blob:none')",
        )
        .unwrap();
    browser.script("document.querySelector('#csv').click()").unwrap();
    browser.wait("window.saved").unwrap();
    let csv = browser.text("window.saved").unwrap();
    let [head, first, ..] = csv.lines().collect::<Vec<_>>()[..] else { panic!("{csv}") };
    assert!(head.starts_with("t [s],phi_inner [rad],"), "{head}");
    assert!(first.starts_with(&format!("0,{},", 85_f64.to_radians())), "{first}");
}

/// The picture stays in sight beside its graphs: at a desk in a column, on a phone above them.
#[test]
#[ignore = "needs chromium, chromedriver and the page"]
fn the_motion_is_beside_its_graphs() {
    for (screen, columns) in [(Screen::Desk, 2), (Screen::Phone, 1)] {
        let browser = opened(screen);
        // The frame is sealed: its own page in a frame of that size.
        let boxes = browser.script(
            "const sealed = document.querySelector('#player iframe'), open = sealed.cloneNode();
             open.removeAttribute('sandbox'); const loaded = new Promise((done) => (open.onload = done));
             sealed.after(open); sealed.style.display = 'none'; await loaded;
             const told = await ask({ ask: 'run', ...chosen });
             open.contentWindow.postMessage(told.played, '*');
             const page = open.contentDocument, box = (id) => page.querySelector(id).getBoundingClientRect();
             while (!page.querySelector('#panels figure')) await new Promise(requestAnimationFrame);
             await new Promise((done) => setTimeout(done, 100));
             open.contentWindow.scrollBy(0, page.querySelectorAll('#panels figure')[1].getBoundingClientRect().top - box('.stage').height - 20);
             await new Promise((done) => setTimeout(done, 100));
             const [stage, graph] = [box('.stage'), page.querySelectorAll('#panels figure')[1].getBoundingClientRect()];
             return [stage.top, stage.bottom, graph.top, graph.bottom, open.clientHeight, stage.right, graph.left];",
        );
        let boxes = boxes.unwrap();
        let at = |k: usize| boxes[k].as_f64().expect("a place");
        assert!(at(0) >= 0.0 && at(1) <= at(4), "the picture is out of sight on a {screen:?}: {boxes}");
        assert!(at(2) >= 0.0 && at(3) <= at(4) + 1.0, "the graph is out of sight on a {screen:?}: {boxes}");
        match columns {
            2 => assert!(at(6) >= at(5), "{boxes}"),
            _ => assert!(at(2) >= at(1), "{boxes}"),
        }
    }
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
