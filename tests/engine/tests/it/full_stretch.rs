//! Two bars that a drive stretches fully, once: there its row vanishes, and nothing but the motion
//! before says how they go on.

use liftoff::method::MethodId;
use liftoff::prelude::*;

macro_rules! stretched {
    ($name:ident, $length:expr) => {
        #[derive(BarSystem)]
        #[liftoff(dimensionless)]
        #[gravity(g)]
        #[bar(OA, mass = 1, length = 1)]
        #[bar(AB, mass = 1, length = 1)]
        #[pin(O = (0, 0))]
        #[drive(distance(O, B) = $length)]
        #[coordinate(phi = angle(OA), from = down)]
        #[figure(A = (0.866, -0.5), B = (0, -1))]
        struct $name {
            g: f64,
        }
    };
}

stretched!(Parabola, 2 - (t - 1) * (t - 1));
stretched!(Cosine, 2 * cos(t - 1));
stretched!(Sine, 1 + sin(t));

/// The angle between the bars, 2 cos(d/2) = length, along its smooth branch, d = 4 asin(s(t)).
type Angle = fn(f64) -> f64;

/// φ at a time by Runge and Kutta's method, from the one equation that a given d leaves: (5/3 + cos
/// d) a″ = −g (3/2 cos a + 1/2 cos(a + d)) + sin d d′ a′ + 1/2 sin d d′² − (1/3 + 1/2 cos d) d″.
fn integrate(d: Angle, g: f64, [phi, rate]: [f64; 2], end: f64) -> f64 {
    const STEPS: usize = 20_000;
    // The differences' errors, 1e-4⁴ and 1e-16/1e-4², are some 1e-8.
    let differences = |t: f64| {
        let h = 1e-3;
        let [a, b, c, e, f] = [-2.0, -1.0, 0.0, 1.0, 2.0].map(|k| d(t + k * h));
        (
            c,
            (a - 8.0 * b + 8.0 * e - f) / (12.0 * h),
            (-a + 16.0 * b - 30.0 * c + 16.0 * e - f) / (12.0 * h * h),
        )
    };
    let slope = |t: f64, [a, w]: [f64; 2]| {
        let (d, d1, d2) = differences(t);
        let weight = -g * (1.5 * a.cos() + 0.5 * (a + d).cos());
        let turning = d.sin() * d1 * w + 0.5 * d.sin() * d1 * d1 - (1.0 / 3.0 + 0.5 * d.cos()) * d2;
        [w, (weight + turning) / (5.0 / 3.0 + d.cos())]
    };
    let (h, mut t) = (end / STEPS as f64, 0.0);
    let mut y = [phi - core::f64::consts::FRAC_PI_2, rate];
    for _ in 0..STEPS {
        let moved = |k: [f64; 2], h: f64| [y[0] + h * k[0], y[1] + h * k[1]];
        let k1 = slope(t, y);
        let k2 = slope(t + 0.5 * h, moved(k1, 0.5 * h));
        let k3 = slope(t + 0.5 * h, moved(k2, 0.5 * h));
        let k4 = slope(t + h, moved(k3, h));
        for i in 0..2 {
            y[i] += h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]);
        }
        t += h;
    }
    y[0] + core::f64::consts::FRAC_PI_2
}

fn passes<M: BarSystem>(model: &M, d: Angle, (g, end): (f64, f64)) {
    for method in MethodId::ALL {
        for tolerance in [1e-4, 1e-9, 1e-12] {
            let simulation = Simulation::new(model).unwrap().tolerance(tolerance).method(method);
            let run = simulation.start(Pose::new("phi", 1.0)).unwrap().limit(end).run();
            let run = run.unwrap_or_else(|error| panic!("{} at {tolerance:e}: {error}", method.name()));
            assert!(run.audit().is_clean(), "{} at {tolerance:e}: {}", method.name(), run.audit());
            let value = |name: &str, t: f64| run.value(&run.output(name).unwrap(), t);
            let (expected, found) = (integrate(d, g, [1.0, value("phi'", 0.0)], end), value("phi", end));
            assert!(
                (found - expected).abs() < 1e-6 + 30.0 * tolerance,
                "{}: {found}, not {expected}",
                method.name()
            );
        }
    }
}

#[test]
fn bars_go_on_along_their_branch() {
    for g in [0.0, 9.81] {
        passes(&Parabola { g }, |t| 4.0 * (0.5 * (t - 1.0)).asin(), (g, 1.5));
        passes(&Cosine { g }, |t| 2.0 * (t - 1.0), (g, 1.5));
        let sine = |t: f64| 4.0 * ((0.5 * (t - core::f64::consts::FRAC_PI_2)).sin() * 0.5_f64.sqrt()).asin();
        passes(&Sine { g }, sine, (g, 2.2));
    }
}
