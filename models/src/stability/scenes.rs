//! Scenes that no model of the program shows, declared here.

use liftoff_studio::RunSpec;
use liftoff_studio::registry::Entry;
use liftoff_studio::source::embedded;
use std::sync::LazyLock;

static SCENES: LazyLock<Vec<Entry>> = LazyLock::new(|| {
    let scene = |name, text| embedded(name, text, RunSpec::with(&[]));
    vec![
        scene(
            "buffer",
            "/// A mass that falls onto a spring without mass.
            #[derive(BarSystem)] #[gravity(g)] #[particle(P, mass = m)] #[slider(P = vertical(0))]
            #[figure(P = (0, 1))] #[coordinate(y = y(P))] #[force(P = (0, -k * y(P)), while(\"y < 0\"))]
            struct Buffer { m: f64, k: f64, g: f64 }",
        ),
        scene(
            "block",
            "/// A block on a rough floor.
            #[derive(BarSystem)] #[gravity(g)] #[particle(P, mass = m)] #[support(P = floor, friction = mu)]
            #[figure(P = (0, 0))] #[coordinate(x = x(P))] #[coordinate(y = y(P))]
            struct Block { m: f64, mu: f64, g: f64 }",
        ),
        scene(
            "free-crank",
            "/// A crank that turns freely and moves a piston, seen from above.
            #[derive(BarSystem)] #[bar(OA, mass = a, length = r)] #[bar(AB, mass = b, length = l)] #[mass(B, c)]
            #[pin(O = (0, 0))] #[slider(B = horizontal(0))] #[figure(A = (0, r), B = (sqrt(l * l - r * r), 0))]
            #[coordinate(phi = angle(OA))] #[coordinate(psi = angle(AB))]
            struct FreeCrank { a: f64, b: f64, c: f64, r: f64, l: f64 }",
        ),
        pulses("pulses-32", ".powi(32)"),
        pulses("pulses-512", ".powi(32).powi(16)"),
        pulses("pulses-8192", ".powi(64).powi(32).powi(4)"),
    ]
});

/// A mass under a force that is narrower the higher its power is.
fn pulses(name: &'static str, power: &str) -> Entry {
    let text = format!(
        "/// A mass under a force sinⁿ t.
        #[derive(BarSystem)] #[particle(P, mass = 1)] #[slider(P = horizontal(0))] #[figure(P = (0, 0))]
        #[coordinate(x = x(P))] #[force(P = (f * sin(t){power}, 0))] #[liftoff(dimensionless)]
        struct Pulses {{ f: f64 }}"
    );
    embedded(name, text.leak(), RunSpec::with(&[]))
}

/// A scene of the list.
pub(super) fn find(name: &str) -> Option<&'static Entry> {
    SCENES.iter().find(|scene| scene.name() == name)
}
