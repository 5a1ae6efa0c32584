//! A page of equations needs nothing beside itself.

use super::{Drawings, KATEX, page, phase_page};
use crate::equations;
use liftoff::BarSystem;

/// What a page would have to fetch; KaTeX has tags in it for what these equations do not contain.
fn fetched(page: &str) -> Vec<String> {
    let written = page.replace(KATEX, "");
    let fetching = ["link", "script src", "img", "iframe", "object"];
    let tags = written.split('<').filter(|tag| fetching.iter().any(|name| tag.starts_with(name)));
    let urls = written.split("url(").skip(1).filter(|url| !url.starts_with("data:") && !url.starts_with('#'));
    let scheme = |rest: &str| rest.starts_with("://") || rest.starts_with("s://");
    let namespace = |rest: &str| rest.starts_with("://www.w3.org/");
    let links = page.split("http").skip(1).filter(|rest| scheme(rest) && !namespace(rest));
    tags.chain(urls).chain(links).map(|place| place.chars().take(40).collect()).collect()
}

#[test]
fn nothing_is_fetched() {
    let modes =
        crate::modes::svg(&liftoff::modes(&liftoff_fixtures::Ladder { m: 1.0, l: 2.0, g: 9.81 }).unwrap());
    let drawings = Drawings { model: Some("<svg></svg>".to_owned()), modes: Some(modes) };
    let page = page(&equations(liftoff_fixtures::Ladder::LAYOUT), &drawings);
    assert_eq!(fetched(&page), Vec::<String>::new());
    assert!(page.contains("font/woff2;base64,") && page.contains("katex.render"));
}

#[test]
fn every_phase_has_its_place() {
    let equations = equations(liftoff_fixtures::Ladder::LAYOUT);
    let page = page(&equations, &Drawings::default());
    for (i, phase) in equations.phases.iter().enumerate() {
        assert!(
            page.contains(&format!("href=\"#phase-{i}\"")) && page.contains(&format!("<h2 id=phase-{i}>"))
        );
        let motion = &phase.motion[..];
        assert!(motion.iter().all(|equation| page.contains(&equation.latex().replace('&', "&amp;"))));
    }
    assert!(page.contains("id=left-out") && !page.contains("id=modes"));
    let one = phase_page(&equations.name, &equations.phases[0]);
    assert!(one.contains("<h2 id=phase-0>Free</h2>") && !one.contains("phase-1"));
}

/// A pendulum of one bar, `a < b` & c.
#[derive(BarSystem)]
#[bar(OA, mass = m, length = l)]
#[pin(O = (0, 0))]
#[figure(A = (0, -l))]
#[coordinate(phi = angle(OA), from = down)]
struct Bare {
    /// Mass, kg.
    m: f64,
    l: f64,
}

#[test]
fn what_is_not_there_is_reported_and_texts_are_escaped() {
    let equations = equations(Bare::LAYOUT);
    assert!(equations.left_out.iter().any(|text| text.starts_with("No gravity")));
    assert!(equations.left_out.iter().any(|text| text.starts_with("No one-sided contacts")));
    assert_eq!(equations.parameters[0].meaning, "Mass, kg.");
    let page = page(&equations, &Drawings::default());
    assert!(page.contains("<code>a &lt; b</code> &amp; c."));
}
