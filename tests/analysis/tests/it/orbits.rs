//! Periodic orbits against closed forms and a walker with equations of its own.

mod walker;

use core::f64::consts::{FRAC_PI_2, PI, TAU};
use liftoff::prelude::*;
use liftoff_analysis::{BranchEnd, Orbit, OrbitError, OrbitStability, ReturnMap, Section, Special};
use liftoff_core::scalar::Dual4;
use liftoff_core::system::varied;
use liftoff_fixtures::Belt;

fn state_names<M: BarSystem>() -> Vec<String> {
    let names = M::LAYOUT.coordinates.iter().map(|coordinate| coordinate.name);
    names.clone().map(str::to_owned).chain(names.map(|name| format!("{name}'"))).collect()
}

/// Does something with the return map of a section.
fn with_map<M: BarSystem, T>(
    model: fn(&[f64]) -> M,
    (section, drifting): (&str, &[usize]),
    ask: impl FnOnce(&ReturnMap<'_>) -> T,
) -> T {
    let simulate = |parameters: &[f64], state: &[f64]| {
        let named = state_names::<M>().into_iter().zip(state);
        let pose = named.fold(Pose::nominal(), |pose, (name, x)| pose.with(name, *x));
        let simulation = Simulation::new(&model(parameters)).map_err(|error| error.to_string())?;
        Ok(simulation.tolerance(1e-13).start(pose).map_err(|error| error.to_string())?.limit(50.0))
    };
    let section = Section::parse(M::LAYOUT, section).unwrap();
    let varied = |parameters: &[Dual4]| Ok(varied::<M>(parameters));
    ask(&ReturnMap { simulate: &simulate, model: &varied, section, drifting: drifting.to_vec() })
}

/// A rimless wheel of which five spokes touch the ground one after the other.
#[derive(BarSystem)]
#[gravity(g)]
#[body(
    wheel,
    points(
        H = (0, 0),
        A = (-l * sin(alpha), -l * cos(alpha)),
        B = (l * sin(alpha), -l * cos(alpha)),
        C = (l * sin(3 * alpha), -l * cos(3 * alpha)),
        D = (l * sin(5 * alpha), -l * cos(5 * alpha)),
        E = (l * sin(7 * alpha), -l * cos(7 * alpha)),
    ),
    mass = m,
    inertia = j,
    centre = (0, 0),
)]
#[support(A = slope(-gamma), friction = mu)]
#[support(B = slope(-gamma), friction = mu)]
#[support(C = slope(-gamma), friction = mu)]
#[support(D = slope(-gamma), friction = mu)]
#[support(E = slope(-gamma), friction = mu)]
#[figure(A = (0, 0), B = (2 * l * sin(alpha) * cos(gamma), -2 * l * sin(alpha) * sin(gamma)))]
#[coordinate(phi = angle(wheel), from = right)]
#[coordinate(x = x(H))]
#[coordinate(y = y(H))]
struct Wheel {
    m: f64,
    j: f64,
    l: f64,
    alpha: f64,
    gamma: f64,
    mu: f64,
    g: f64,
}

fn wheel(p: &[f64]) -> Wheel {
    Wheel { m: p[0], j: p[1], l: p[2], alpha: p[3], gamma: p[4], mu: p[5], g: p[6] }
}

/// On feet A and B, turning about B.
fn on_two_feet([l, alpha, gamma]: [f64; 3], rate: f64) -> Vec<f64> {
    let (sin, cos) = (alpha - gamma).sin_cos();
    let arm = [-l * sin, l * cos];
    let hub = |foot: [f64; 2]| [foot[0] + arm[0], foot[1] + arm[1]];
    let [x, y] = hub([2.0 * l * alpha.sin() * gamma.cos(), -2.0 * l * alpha.sin() * gamma.sin()]);
    vec![-gamma, x, y, rate, -rate * arm[1], rate * arm[0]]
}

/// ω⁺² = c² (ω⁺² + (4 g/l)(m l²/(m l² + j)) sin α sin γ), c = (m l² cos 2α + j)/(m l² + j): its
/// multiplier is c².
#[test]
fn a_rimless_wheel_rolls_at_the_rate_of_its_closed_form() {
    for (j, alpha, gamma) in [(0.01, 0.3, 0.15), (0.2, 0.25, 0.1)] {
        let (m, l, g) = (1.3, 0.8, 9.0);
        let parameters = [m, j, l, alpha, gamma, 2.0, g];
        let start = on_two_feet([l, alpha, gamma], -1.0);
        let orbit = with_map(wheel, ("impact", &[0, 1, 2]), |map| map.orbit(&parameters, &start));
        let orbit = orbit.unwrap_or_else(|error| panic!("{error}"));
        let inertia = m * l * l + j;
        let c = (m * l * l * (2.0 * alpha).cos() + j) / inertia;
        let gained = 4.0 * m * g * l / inertia * alpha.sin() * gamma.sin();
        let rate = -(c * c * gained / (1.0 - c * c)).sqrt();
        assert!((orbit.state[3] / rate - 1.0).abs() < 1e-10, "{} or {rate}", orbit.state[3]);
        assert_eq!(orbit.multipliers.len(), 1);
        let error = (orbit.multipliers[0].re - c * c).abs() + orbit.multipliers[0].im.abs();
        assert!(error < 1e-10, "{} or {}", orbit.multipliers[0], c * c);
        assert!((orbit.shift[0] + 2.0 * alpha).abs() < 1e-10 && orbit.stability() == OrbitStability::Stable);
    }
}

/// Along γ feet move on circles, which a step along a tangent leaves. ω is as above, to ten times
/// what the orbits of a branch may miss by.
#[test]
fn a_rimless_wheel_is_followed_to_a_steeper_slope() {
    let (m, j, l, alpha, g) = (1.3, 0.01, 0.8, 0.3, 9.0);
    let [from, to] = [0.15, 0.2];
    let start = on_two_feet([l, alpha, from], -1.0);
    let branch = with_map(wheel, ("impact", &[0, 1, 2]), |map| {
        let orbit = map.orbit(&[m, j, l, alpha, from, 2.0, g], &start)?;
        map.branch(&orbit, 4, to)
    });
    let branch = branch.unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(branch.end, BranchEnd::Reached);
    let inertia = m * l * l + j;
    let c = (m * l * l * (2.0 * alpha).cos() + j) / inertia;
    for point in &branch.points {
        let gamma = point.orbit.parameters[4];
        let gained = 4.0 * m * g * l / inertia * alpha.sin() * gamma.sin();
        let rate = -(c * c * gained / (1.0 - c * c)).sqrt();
        assert!((point.orbit.state[3] / rate - 1.0).abs() < 1e-8, "{} or {rate}", point.orbit.state[3]);
    }
    assert!((branch.points[branch.points.len() - 1].orbit.parameters[4] / to - 1.0).abs() < 1e-9);
}

/// What depends on a coordinate that is said to drift, and what never comes back.
#[test]
fn sections_that_do_not_fit_are_refused() {
    let parameters = [1.0, 0.0, 1.0, 0.3, 0.15, 2.0, 9.0];
    let start = on_two_feet([1.0, 0.3, 0.15], -2.0);
    let refused = |section: &str, drifting: &[usize]| {
        with_map(wheel, (section, drifting), |map| map.orbit(&parameters, &start)).unwrap_err()
    };
    assert!(matches!(refused("y > 5", &[]), OrbitError::NoReturn { .. } | OrbitError::Run(_)));
    let error = Section::parse(Wheel::LAYOUT, "impact Z").unwrap_err();
    assert!(matches!(error, OrbitError::Event(_)), "{error}");
    let error = Section::parse(Wheel::LAYOUT, "phi >").unwrap_err();
    assert!(matches!(error, OrbitError::Section { .. }), "{error}");
}

/// Two stiff legs and a hip on tiles, as the model `compass-walker`.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(HA, mass = m, length = a + b, centre = b, inertia = j)]
#[bar(HB, mass = m, length = a + b, centre = b, inertia = j)]
#[mass(H, hip)]
#[support(A = slope(-gamma), rough, while("cos(pi * x(A) / s) > 0"))]
#[support(B = slope(-gamma), rough, while("cos(pi * x(B) / s) < 0"))]
#[constant(h = s / (2 * cos(gamma)))]
#[constant(k = sqrt((a + b).powi(2) - h.powi(2)))]
#[figure(A = (0, 0), H = (h * cos(gamma) + k * sin(gamma), k * cos(gamma) - h * sin(gamma)), B = (s, -2 * h * sin(gamma)))]
#[coordinate(left = angle(HA), from = down)]
#[coordinate(right = angle(HB), from = down)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
struct Compass {
    m: f64,
    hip: f64,
    j: f64,
    a: f64,
    b: f64,
    gamma: f64,
    s: f64,
    g: f64,
}

fn compass(p: &[f64]) -> Compass {
    Compass { m: p[0], hip: p[1], j: p[2], a: p[3], b: p[4], gamma: p[5], s: p[6], g: p[7] }
}

fn gait() -> Orbit {
    let gamma = PI / 60.0;
    let parameters = [5.0, 10.0, 0.0, 0.5, 0.5, gamma, 0.535, 9.8];
    let start = [0.2187, -2.0 * gamma - 0.2187, 0.0, 0.0, -1.0918, -0.3772, 0.0, 0.0];
    let orbit = with_map(compass, ("impact A", &[2, 3]), |map| map.orbit(&parameters, &start));
    orbit.unwrap_or_else(|error| panic!("{error}"))
}

/// Against equations, integration, heel strikes and differences that share nothing with it.
#[test]
#[ignore = "takes minutes: `.ci/long promises orbits`"]
fn a_walker_has_the_gait_of_its_own_equations() {
    let orbit = gait();
    let own = walker::Walker { m: 5.0, hip: 10.0, a: 0.5, b: 0.5, gamma: PI / 60.0, g: 9.8 };
    let state = [orbit.state[0], orbit.state[4], orbit.state[5]];
    let (back, period) = own.gait(state);
    for (back, state) in back.iter().zip(state) {
        assert!((back - state).abs() < 1e-9, "{back} or {state}");
    }
    assert!((orbit.period - period).abs() < 1e-9);
    let mut expected: Vec<_> = own.slopes(state).complex_eigenvalues().iter().copied().collect();
    expected.sort_by(|a, b| b.norm().total_cmp(&a.norm()).then(b.im.total_cmp(&a.im)));
    assert_eq!(orbit.multipliers.len(), 3);
    for (found, expected) in orbit.multipliers.iter().zip(expected) {
        assert!((found - expected).norm() < 1e-9, "{found} or {expected}");
    }
    assert_eq!(orbit.stability(), OrbitStability::Stable);
}

/// A bar that swings: a family of orbits, one for each energy.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(OA, mass = m, length = l)]
#[pin(O = (0, 0))]
#[figure(A = (0, -l))]
#[coordinate(phi = angle(OA), from = down)]
struct Swing {
    m: f64,
    l: f64,
    g: f64,
}

/// T = 4 √(2l/3g) K(m = ½) from 90°, and the multiplier 1 of a family.
#[test]
fn a_pendulum_has_a_family_of_orbits() {
    let model = |p: &[f64]| Swing { m: p[0], l: p[1], g: p[2] };
    let orbit =
        with_map(model, ("phi > 0", &[]), |map| map.orbit(&[1.0, 1.0, 1.0], &[FRAC_PI_2, 0.0])).unwrap();
    assert!((orbit.period - 6.055_382_539_204_989).abs() < 1e-10, "{}", orbit.period);
    assert_eq!(orbit.multipliers.len(), 1);
    assert!((orbit.multipliers[0] - 1.0).norm() < 1e-8, "{}", orbit.multipliers[0]);
    assert_eq!(orbit.stability(), OrbitStability::Neutral);
    let branch = with_map(model, ("phi > 0", &[]), |map| map.branch(&orbit, 1, 2.0));
    assert_eq!(branch, Err(OrbitError::Family));
}

fn belt(p: &[f64]) -> Belt {
    Belt { m: p[0], g: p[1], k: p[2], mu: p[3], mu_s: p[4], w: p[5] }
}

/// A block that sticks to a belt and slips back, seen where it turns back while it slips. With ω² =
/// k/m and k d = (μ_s − μ) m g it slips for (π + 2 atan(w/(ω d)))/ω and sticks for 2 d/w, and what
/// it did before is forgotten where it sticks.
#[test]
fn a_cycle_of_stick_and_slip_is_followed_to_a_faster_belt() {
    let [m, g, k, mu, mu_s] = [1.3, 9.0, 4.0, 0.2, 0.5];
    let [from, to] = [0.7, 1.4];
    let branch = with_map(belt, ("x' < 0", &[]), |map| {
        let orbit = map.orbit(&[m, g, k, mu, mu_s, from], &[0.1, 0.0, from, 0.0])?;
        map.branch(&orbit, 5, to)
    });
    let branch = branch.unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(branch.end, BranchEnd::Reached);
    assert!(branch.points.len() > 3);
    let (frequency, d) = ((k / m).sqrt(), (mu_s - mu) * m * g / k);
    for point in &branch.points {
        let orbit = &point.orbit;
        let w = orbit.parameters[5];
        let period = (PI + 2.0 * (w / (frequency * d)).atan()) / frequency + 2.0 * d / w;
        assert!((orbit.period / period - 1.0).abs() < 1e-9, "{w}: {} or {period}", orbit.period);
        let farthest = mu * m * g / k + d.hypot(w / frequency);
        assert!((orbit.state[0] / farthest - 1.0).abs() < 1e-9 && orbit.state[2].abs() < 1e-9);
        assert_eq!((orbit.multipliers.len(), orbit.stability()), (1, OrbitStability::Stable));
        assert!(orbit.multipliers[0].norm() < 1e-8, "{}", orbit.multipliers[0]);
    }
    assert!((branch.points[branch.points.len() - 1].orbit.parameters[5] / to - 1.0).abs() < 1e-9);
}

/// At exactly φ = 0 the condition is about to hold.
#[test]
fn an_orbit_is_found_from_the_edge_of_its_section() {
    let model = |p: &[f64]| Swing { m: p[0], l: p[1], g: p[2] };
    // (l/3) φ'² = g at the bottom of a swing to 90°.
    let start = [0.0, 3.0f64.sqrt()];
    let orbit = with_map(model, ("phi > 0", &[]), |map| map.orbit(&[1.0, 1.0, 1.0], &start)).unwrap();
    assert!((orbit.period - 6.055_382_539_204_989).abs() < 1e-10, "{}", orbit.period);
}

/// No orbit is so short, and the equilibrium comes back after any time.
#[test]
fn an_equilibrium_is_no_orbit() {
    let model = |p: &[f64]| Swing { m: p[0], l: p[1], g: p[2] };
    let found = with_map(model, ("t = 1", &[]), |map| map.orbit(&[1.0, 1.0, 1.0], &[0.3, 0.0]));
    assert_eq!(found, Err(OrbitError::AtRest));
}

/// A ball on a floor that moves as a sin(ωt − 1.5), in the frame of the floor: no impact is near t = 0.
#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[slider(P = vertical(0))]
#[force(P = (0, m * a * w * w * sin(w * t - 1.5)))]
#[support(P = floor, restitution = e)]
#[figure(P = (0, 1))]
#[coordinate(y = y(P))]
struct Juggled {
    m: f64,
    a: f64,
    w: f64,
    e: f64,
    g: f64,
}

fn juggled(p: &[f64]) -> Juggled {
    Juggled { m: p[0], a: p[1], w: p[2], e: p[3], g: p[4] }
}

/// One impact a period T, at the phase θ with a ω cos θ = (g T/2)(1 − e)/(1 + e). Of its map of the
/// time and the velocity of impacts the determinant is e² and the trace 1 + e² − (1 + e)² (a ω²/g)
/// sin θ, so that it begins in a fold at θ = 0 and ends in a flip at a ω² sin θ = 2 g (1 + e²)/(1 +
/// e)².
#[test]
fn a_juggled_ball_has_the_fold_and_the_flip_of_its_closed_form() {
    let (a, w, e, g) = (0.028, 20.0, 0.6, 9.0);
    let period = TAU / w;
    let rise = 0.5 * g * period;
    let floor = rise * (1.0 - e) / (1.0 + e);
    let phase = (floor / (a * w)).acos();
    let flight = period - (phase + 1.5) / w;
    let y = a * (phase.sin() + 1.5f64.sin()) + rise * flight - 0.5 * g * flight * flight;
    // The slider keeps x_P, the first coordinate.
    let start = [0.0, y + 1e-4, 0.0, rise - g * flight - a * w * 1.5f64.cos()];
    let parameters = [1.3, a, w, e, g];
    with_map(juggled, ("t = 2 * pi / w", &[]), |map| {
        let orbit = map.orbit(&parameters, &start).unwrap_or_else(|error| panic!("{error}"));
        assert!((orbit.state[1] - y).abs() < 1e-11 && (orbit.period - period).abs() < 1e-15);
        let [first, second] = [orbit.multipliers[0], orbit.multipliers[1]];
        let trace = 1.0 + e * e - (1.0 + e).powi(2) * a * w * w / g * phase.sin();
        assert!((first * second - e * e).norm() < 1e-10 && (first + second - trace).norm() < 1e-10);
        let special = |to: f64, kind: Special| {
            let branch = map.branch(&orbit, 1, to).unwrap_or_else(|error| panic!("{error}"));
            let found = branch.points.iter().find(|point| point.special == Some(kind));
            let found = found.unwrap_or_else(|| panic!("no {kind}: {:?}", branch.end));
            (found.orbit.parameters[1], branch.end)
        };
        let (fold, _) = special(0.5 * a, Special::Fold);
        assert!((fold * w / floor - 1.0).abs() < 1e-10, "{fold}");
        let bent = 2.0 * g * (1.0 + e * e) / (1.0 + e).powi(2);
        let (flip, end) = special(1.5 * a, Special::Flip);
        assert!((flip * w / floor.hypot(bent / w) - 1.0).abs() < 1e-8, "{flip}");
        assert_eq!(end, BranchEnd::Reached);
    });
    // Of two turns the multiplier −1 is 1: the orbit of twice the period crosses there.
    with_map(juggled, ("t = 4 * pi / w", &[]), |map| {
        let orbit = map.orbit(&parameters, &start).unwrap_or_else(|error| panic!("{error}"));
        let branch = map.branch(&orbit, 1, 1.5 * a).unwrap_or_else(|error| panic!("{error}"));
        let special = branch.points.iter().filter_map(|point| Some((point.special?, point)));
        let [(kind, point)] = special.collect::<Vec<_>>()[..] else { panic!("{:?}", branch.end) };
        let bent = 2.0 * g * (1.0 + e * e) / (1.0 + e).powi(2);
        let found = point.orbit.parameters[1];
        assert_eq!(kind, Special::Branch);
        // Where branches cross, orbits are told apart by the third root of what they may miss
        // themselves by.
        assert!((found * w / floor.hypot(bent / w) - 1.0).abs() < 1e-3, "{found}");
    });
}
