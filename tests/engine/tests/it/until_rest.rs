//! Runs until what friction brings to rest is at rest: an equation that holds from an event on is
//! met there.

use liftoff::prelude::*;

/// A block that friction stops.
#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[support(P = floor, friction = mu)]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
#[figure(P = (0, 0))]
struct Block {
    m: f64,
    mu: f64,
    g: f64,
}

/// A flywheel that friction in its pin stops.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[point(O = AB, at = l / 2)]
#[pin(O = (0, 0))]
#[pin(O, friction = mu, radius = r)]
#[coordinate(phi = angle(AB), from = right)]
#[figure(A = (-l / 2, 0), B = (l / 2, 0))]
struct Wheel {
    m: f64,
    l: f64,
    mu: f64,
    r: f64,
    g: f64,
}

/// The last event, with how it is told.
fn stopped<'a, M>(model: &'a M, start: Pose, until: &str) -> (EventKind, f64)
where
    &'a M: Into<liftoff::Scene>,
{
    let simulation = Simulation::new(model).unwrap().start(start).unwrap();
    let run = simulation.until(until).unwrap().limit(50.0).run();
    let run = run.unwrap_or_else(|error| panic!("{until}: {error}"));
    let last = run.events().last().unwrap();
    (last.kind, last.t)
}

/// t = v/(μ g) and, with the couple μ r m g, t = J ω/(μ r m g).
#[test]
fn equations_are_met_where_friction_ends_the_motion() {
    let mut seed = 11_u64;
    let mut between = |low: f64, high: f64| {
        seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        low + (high - low) * (seed >> 11) as f64 / (1_u64 << 53) as f64
    };
    for _ in 0..40 {
        let (m, mu, g) = (between(0.5, 2.0), between(0.1, 0.9), 9.81);
        let (l, r, rate) = (between(0.5, 2.0), between(0.02, 0.2), between(-3.0, 3.0));
        let block = Block { m, mu, g };
        for until in ["x' = 0", "v(P) = 0", "2 * v(P) = v(P)"] {
            let (kind, t) = stopped(&block, Pose::new("x'", rate), until);
            assert!(kind == EventKind::Stop && (t - rate.abs() / (mu * g)).abs() < 1e-10, "{until} {t}");
        }
        let wheel = Wheel { m, l, mu, r, g };
        for until in ["phi' = 0", "v(O) = 0"] {
            let (kind, t) = stopped(&wheel, Pose::new("phi", 0.0).with("phi'", rate), until);
            let known = l * l / 12.0 * rate.abs() / (mu * r * g);
            assert!(
                kind == EventKind::Stop && (t - known).abs() < 1e-10 * known.max(1.0),
                "{until} {t} {known}"
            );
        }
    }
}
