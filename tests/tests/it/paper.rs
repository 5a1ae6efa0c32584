//! The paper's equations as restated in `liftoff_tests::paper`, against the 25-digit references and
//! one another.
//!
//! Tolerance 1e-13 relative to the larger of the value and 0.1: a few hundred roundings of f64, for
//! what is evaluated or bisected; located maxima of μ carry the square root of rounding in φ, 1e-8.

use std::collections::BTreeMap;
use std::f64::consts::FRAC_PI_2;

use liftoff_tests::numerics::root;
use liftoff_tests::paper::{FallingPair, Zigzag};

const ROUNDING: f64 = 1e-13;

struct References(BTreeMap<String, serde_json::Value>);

impl References {
    fn load() -> Self {
        let text = include_str!("../../../models/data/references.json");
        Self(serde_json::from_str(text).expect("references.json is an object"))
    }

    fn check(&self, id: &str, computed: f64, tolerance: f64) {
        let text = self.0[id]["value"].as_str().expect("values are strings");
        let reference: f64 = text.parse().expect("numeric reference");
        let error = (computed - reference).abs() / reference.abs().max(0.1);
        assert!(error <= tolerance, "{id}: {computed:e} for {reference:e}, {error:.1e}");
    }
}

fn close(left: f64, right: f64, scale: f64) {
    assert!((left - right).abs() <= ROUNDING * scale.abs(), "{left:e} is not {right:e}");
}

/// Central difference: error h² f‴/6 plus rounding ε f/h, both below 1e-9 of an O(1…10) function at
/// h = 1e-5.
fn derivative(f: impl Fn(f64) -> f64, x: f64) -> f64 {
    (f(x + 1e-5) - f(x - 1e-5)) / 2e-5
}

const EARTH: FallingPair = FallingPair { m: 1.0, l: 1.0, g: 9.80665 };

fn lift_off(pair: &FallingPair) -> f64 {
    root(|phi| pair.reaction(phi, pair.rate_squared(phi).sqrt()), 0.5, 1.0).expect("N changes sign")
}

#[test]
fn falling_pair_meets_the_references() {
    let references = References::load();
    let phi = lift_off(&EARTH);
    let rate = EARTH.rate_squared(phi).sqrt();
    references.check("fig1a.phi1", phi, ROUNDING);
    references.check("fig1a.omega1", rate, ROUNDING);
    references.check("fig1a.alpha1", EARTH.acceleration(phi), ROUNDING);
    let unit = FallingPair { g: 1.0, ..EARTH };
    let rate = unit.rate_squared(phi).sqrt();
    references.check("fig1a.flight_time", unit.flight_time(phi, rate, FRAC_PI_2), ROUNDING);
    references.check("fig1a.omega_end", unit.free_rate(phi, rate, FRAC_PI_2), ROUNDING);
    let travel = unit.free_drop(phi, rate, FRAC_PI_2);
    references.check("fig1a.travel_D", travel, ROUNDING);
    let cosine = 2f64.powf(-1.0 / 3.0);
    let highest = (cosine.acos().tan() - 2.0 * cosine.acos().sin()) / 2.0;
    references.check("fig1a.height_ends", travel - 1.0 - highest, ROUNDING);
}

#[test]
fn falling_pair_lifts_off_at_one_angle_whatever_its_parameters() {
    let phi = lift_off(&EARTH);
    for (m, l, g) in [(3.0, 0.25, 1.0), (0.01, 7.0, 1.62)] {
        close(lift_off(&FallingPair { m, l, g }), phi, 1.0);
    }
}

#[test]
fn falling_pair_equations_agree_with_each_other() {
    let pair = FallingPair { m: 0.7, l: 1.3, g: 9.81 };
    for phi in [0.05, 0.3, 0.6, 0.8] {
        let rate = pair.rate_squared(phi).sqrt();
        let slope = derivative(|angle| pair.rate_squared(angle), phi) / 2.0;
        assert!((pair.acceleration(phi) - slope).abs() < 1e-8 * pair.g);
        let drop_rate = 0.5 * pair.l / phi.cos().powi(2) * rate;
        let energy = pair.constrained_energy(phi, rate);
        close(pair.free_energy(phi, rate, drop_rate), energy, 10.0 * energy);
        let fallen = pair.drop(phi) - 0.5 * pair.l * phi.sin();
        close(energy, 2.0 * pair.m * pair.g * fallen, 10.0 * energy);
        let [turn, _] = pair.free_accelerations(phi, rate);
        close(pair.free_residual(phi, rate, turn), 0.0, 1.0 + rate * rate);
    }
    let phi = lift_off(&pair);
    let rate = pair.rate_squared(phi).sqrt();
    close(pair.free_accelerations(phi, rate)[0], pair.acceleration(phi), 100.0);
}

#[test]
fn falling_pair_keeps_its_digits_near_the_equilibrium() {
    for phi in [1e-4_f64, 1e-8, 1e-12] {
        let leading = 6.0 * EARTH.g * phi.powi(3);
        let relative = EARTH.rate_squared(phi) / leading - 1.0;
        assert!(relative.abs() < 10.0 * phi * phi + 1e-15, "{relative:e} at {phi:e}");
    }
}

fn unit_zigzag(lambda: f64) -> Zigzag {
    Zigzag { m1: 1.0 - lambda, m2: lambda, l: 1.0, g: 1.0, start: FRAC_PI_2 }
}

/// φ* by golden section: μ has one maximum in (0, 0.6).
fn crest(system: &Zigzag) -> f64 {
    let (mut low, mut high) = (0.0, 0.6);
    let ratio = (5f64.sqrt() - 1.0) / 2.0;
    while high - low > 1e-9 {
        let (a, b) = (high - ratio * (high - low), low + ratio * (high - low));
        if system.mu(a) > system.mu(b) { high = b } else { low = a }
    }
    0.5 * (low + high)
}

#[test]
fn zigzag_meets_table_1() {
    let references = References::load();
    for text in ["0.00", "0.25", "0.50", "0.75", "1.00"] {
        let id = |name: &str| format!("fig1b.{name}[{text}]");
        let system = unit_zigzag(text.parse().expect("number"));
        let star = crest(&system);
        references.check(&id("phi_star"), star, 2e-7);
        references.check(&id("mu"), system.mu(star), ROUNDING);
        if text == "0.00" {
            continue;
        }
        let lift = root(|phi| system.mu(phi) - 2.0, star, 1.0).expect("lifts off");
        references.check(&id("phi1"), lift, ROUNDING);
        let h = system.free_integral(lift, system.rate_squared(lift).sqrt());
        let gap = |phi: f64| system.rise(h, lift, phi) + phi.sin();
        references.check(&id("phi2"), root(gap, -0.2, 0.1).expect("lands"), ROUNDING);
    }
}

#[test]
fn zigzag_meets_figures_8_to_10() {
    let references = References::load();
    let system = unit_zigzag(0.5);
    let lift = root(|phi| system.mu(phi) - 2.0, 0.3, 1.0).expect("lifts off");
    let h = system.free_integral(lift, system.rate_squared(lift).sqrt());
    let gap = |phi: f64| system.rise(h, lift, phi) + phi.sin();
    let touch = root(gap, -0.2, 0.1).expect("lands");
    references.check("fig1b.rise_flat[0.50]", system.rise(h, lift, 0.0), ROUNDING);
    references.check("fig1b.rise_max[0.50]", system.rise(h, lift, touch), ROUNDING);
    references.check("fig1b.omega_flat[0.50]", system.free_rate(h, 0.0), ROUNDING);
    references.check("fig1b.a_C_touch[0.50]", system.free_drop_acceleration(h, touch), ROUNDING);
    let steps = (0..=100_000).map(|k| touch + (lift - touch) * f64::from(k) / 1e5);
    let least = steps.map(|phi| system.free_acceleration(h, phi)).fold(f64::INFINITY, f64::min);
    // a grid of 5e-6 misses the minimum by at most half its curvature (about 3e2) times (2.5e-6)²
    references.check("fig1b.alpha_min[0.50]", least, 1e-9);
}

#[test]
fn zigzag_equations_agree_with_each_other() {
    let system = Zigzag { m1: 0.8, m2: 1.7, l: 0.6, g: 9.81, start: 1.4 };
    for phi in [0.1, 0.4, 0.9, 1.3] {
        let rate = system.rate_squared(phi).sqrt();
        let energy = system.constrained_energy(phi, rate);
        close(energy, system.work(phi), energy);
        let slope = derivative(|angle| system.rate_squared(angle), phi) / 2.0;
        assert!((system.acceleration(phi) - slope).abs() < 1e-8 * system.g);
        let inner = system.m1 * system.l.powi(2) * rate * rate / 3.0;
        let spin = system.m2 * system.l.powi(2) * rate * rate / 12.0;
        let outer = spin + system.m2 * system.outer_speed_squared(phi, rate);
        close(inner + outer, energy, energy);
        let [x, y] = system.outer_centre(phi);
        let pull = derivative(|angle| system.outer_centre(angle)[0], phi);
        assert!((pull + x * phi.tan()).abs() < 1e-8 && (y - 0.5 * system.l * phi.sin()).abs() < 1e-15);
        let weight = 2.0 * (system.m1 + system.m2) * system.g;
        let fall = 0.5 * system.l * (rate * rate * phi.sin() - system.acceleration(phi) * phi.cos());
        close(system.reaction(phi), weight * (1.0 - fall / system.g), weight);
        close(system.free_energy(phi, rate, 0.0), energy, energy);
    }
}

#[test]
fn zigzag_flight_meets_its_equations_of_motion() {
    let system = Zigzag { m1: 0.8, m2: 1.7, l: 0.6, g: 9.81, start: 1.4 };
    let h = system.free_integral(0.4, 3.0);
    for phi in [-0.1, 0.05, 0.4] {
        let rate = system.free_rate(h, phi);
        let pair = [system.free_acceleration(h, phi), system.free_drop_acceleration(h, phi)];
        for residual in system.free_residuals(phi, rate, pair) {
            close(residual, 0.0, 1e3);
        }
    }
}
