//! What is refused, and how it is said.

use liftoff::method::MethodId;
use liftoff::prelude::*;
use liftoff::{ContactError, ModelError, RunCause, StartError};
use liftoff_fixtures::FallingPair;
use liftoff_fixtures::Ladder;
use liftoff_fixtures::Zigzag;

/// A point mass at the end of a massless bar that nothing holds at its other end.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = bar, length = l)]
#[mass(B, m)]
#[figure(A = (0, 0), B = (l, 0))]
struct Tail {
    bar: f64,
    m: f64,
    l: f64,
    g: f64,
}

/// A ball at the end of a bar, over the floor.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(OP, mass = m, inertia = j, length = l)]
#[pin(O = (0, 2 * l))]
#[disc(P, radius = r)]
#[support(P = floor)]
#[figure(P = (0, l))]
#[coordinate(phi = angle(OP), from = down)]
struct Cradle {
    m: f64,
    j: f64,
    r: f64,
    l: f64,
    g: f64,
}

fn pair() -> Simulation {
    Simulation::new(&FallingPair { m: 1.0, l: 1.0, g: 1.0 }).unwrap()
}

fn message<T, E: std::fmt::Display>(result: Result<T, E>) -> String {
    result.map(|_| ()).map_err(|error| error.to_string()).unwrap_err()
}

#[test]
fn models() {
    for (m, l, g, expected) in [
        (f64::NAN, 1.0, 1.0, "parameter `m` is NaN"),
        (1.0, 1.0, f64::INFINITY, "parameter `g` is inf"),
        (-1.0, 1.0, 1.0, "mass of bar AD is negative: -1"),
        (1.0, 0.0, 1.0, "length of bar AD is 0; it must be positive"),
        (0.0, 1.0, 1.0, "the total mass is zero"),
    ] {
        assert_eq!(message(Simulation::new(&FallingPair { m, l, g })), expected);
    }
}

/// Balls and bars that are lost beside others touch nothing that can be told; alone they may be of
/// any size.
#[test]
fn entries_lost_beside_the_largest() {
    let cradle =
        |r: f64, l: f64| message(Simulation::new(&Cradle { m: 0.1, j: 1e-3 * l * l, r, l, g: 9.81 }));
    assert_eq!(
        cradle(0.02, 1e8),
        "the radius of the disc about P, 2e-2, is below the roundoff of 1e8: contacts and joints cannot be resolved"
    );
    let light = Cradle { m: 1e9, j: 1e-7, r: 0.02, l: 1.0, g: 9.81 };
    assert!(matches!(Simulation::new(&light), Err(ModelError::Spread { .. })));
    for unit in [1e-200, 1.0, 1e100] {
        let model = Cradle { m: 0.1, j: 1e-3 * unit * unit, r: 1e-6 * unit, l: unit, g: 9.81 };
        assert!(Simulation::new(&model).is_ok(), "{unit:e}");
    }
}

#[test]
fn starts() {
    for (pose, expected) in [
        (Pose::new("phj", 0.1), "no coordinate `phj`; did you mean `phi`?"),
        (Pose::new("phi", f64::NAN), "`phi` starts at NaN"),
        (Pose::new("phi", 0.1).with("phi", 0.2), "`phi` is given twice"),
        (Pose::new("phi", 0.1).with("y", -1.0), "support P, Q is penetrated by 9.451e-1"),
        (Pose::new("phi", 1.2), "the contact P, Q lies beyond the end of its bar by 3.79"),
    ] {
        let told = message(pair().start(pose));
        assert!(told.starts_with(expected), "{told}");
    }
    let told = message(pair().start(Pose::new("phi", 0.1)).unwrap().on_energy_of(Pose::new("phi", 0.2)));
    assert!(told.starts_with("the start lies 3.539"), "{told}");
    let free = Pose::new("phi", 0.1).with("y", 1.0);
    let told = message(pair().start(free.clone()).unwrap().on_energy_of(free));
    assert_eq!(told, "an energy level determines the rate of one degree of freedom, but there are 2");
}

/// Contacts that the given coordinates contradict are open; those that they do not mention stay
/// closed.
#[test]
fn poses_are_completed() {
    for form in [Form::Reduced, Form::Multipliers] {
        let start = |pose| {
            let run =
                Simulation::new(&Ladder { m: 1.0, l: 1.0, g: 1.0 }).unwrap().form(form).start(pose).unwrap();
            run.limit(1e-3).run().unwrap().events()[0].clone()
        };
        let off_wall = start(Pose::new("theta", 1.0).with("x", 0.5));
        assert_eq!(off_wall.reactions[1].value, 0.0);
        assert!((off_wall.state[2] - 0.5 * 1f64.sin()).abs() < 1e-15);
        let sliding = start(Pose::new("theta", 1.0).with("theta'", -0.5));
        for (computed, expected) in
            sliding.state[3..].iter().zip([-0.5, 0.25 * 1f64.sin(), -0.25 * 1f64.cos()])
        {
            assert!((computed - expected).abs() < 1e-15);
        }
        let leaving = start(Pose::new("theta", 1.0).with("x'", 0.3).with("theta'", 0.0));
        assert_eq!((leaving.reactions[1].value, leaving.state[4]), (0.0, 0.3));
    }
}

#[test]
fn runs_keep_what_they_computed() {
    let started = || pair().start(Pose::new("phi", 0.1)).unwrap();
    assert!(matches!(started().tolerance(f64::NAN).run().unwrap_err().cause(), RunCause::Tolerance(_)));
    assert!(matches!(started().limit(-1.0).run().unwrap_err().cause(), RunCause::Limit(_)));
    let free = pair().start(Pose::new("phi", 0.1).with("y", 1.0)).unwrap();
    let error = free.hold("P").unwrap().run().unwrap_err();
    assert!(matches!(error.cause(), RunCause::Start(StartError::HeldOpen { .. })));
    // A step so short that time cannot resolve it.
    let error = started().until("sqrt(0.5 - phi) = -1").unwrap().run().unwrap_err();
    let run = error.trajectory();
    assert!(run.end_time() > 1.0 && run.state(run.end_time())[0] < 0.5, "{error}");
}

#[test]
fn massless_motion_is_singular() {
    let tail = |bar| Simulation::new(&Tail { bar, m: 1.0, l: 1.0, g: 1.0 }).unwrap();
    let error = tail(0.0).limit(1.0).run().unwrap_err();
    let singular = "singular: the mass matrix does not determine the accelerations with no contact closed: \
        no mass resists theta_AB, y_A (without mass: bar AB)";
    assert_eq!(error.cause().to_string(), singular);
    assert_eq!(error.trajectory().final_state().len(), 6);
    assert_eq!(tail(1e-12).limit(1.0).run().unwrap().events().len(), 2);
}

/// Without inner masses det M ∝ sin² φ_inner once C is open; the rates grow beyond all bounds.
///
/// The inner bars then pull at nothing, the outer ones fall for themselves, each about its foot: by
/// hand, N (1 + 3 cos² φ) = m (g − ½ l φ̇² sin φ), and no foot leaves the floor before the inner
/// bars are straight. That the run comes to φ_inner = 1e-3, where rounding ε/φ² is 2e-10 of N, is
/// the tolerance of 1e-6.
#[test]
fn no_contact_opens_where_the_inertia_vanishes() {
    for method in MethodId::ALL {
        let zigzag = Simulation::new(&Zigzag { m1: 0.0, m2: 1.0, l: 1.0, g: 1.0 }).unwrap().method(method);
        let error = zigzag.start(Pose::new("phi_inner", 0.8)).unwrap().run().unwrap_err();
        let told = error.cause().to_string();
        assert!(told.ends_with("no mass resists phi_inner, y (without mass: bar BC, bar CD)"), "{told}");
        let run = error.trajectory();
        let opened: Vec<_> = run.events().iter().skip(1).map(|event| &event.supports[..]).collect();
        assert_eq!(opened, [["C"]], "{}", method.name());
        let near = Output::parse(run.layout(), "phi_inner").unwrap();
        let t = run.times().into_iter().filter(|t| run.value(&near, *t) > 1e-3).fold(0.0, f64::max);
        let at = |name: &str| run.value(&Output::parse(run.layout(), name).unwrap(), t);
        let (phi, rate) = (at("phi_outer"), at("phi_outer'"));
        let by_hand = (1.0 - 0.5 * rate.powi(2) * phi.sin()) / (1.0 + 3.0 * phi.cos().powi(2));
        assert!((at("N(A)") - by_hand).abs() < 1e-6, "{} {by_hand}", at("N(A)"));
    }
}

/// The same, how long it takes.
#[test]
fn creeping_towards_a_singularity_ends() {
    let zigzag = Simulation::new(&Zigzag { m1: 0.0, m2: 1.0, l: 1.0, g: 1.0 }).unwrap();
    let error = zigzag.start(Pose::new("phi_inner", 0.8)).unwrap().run().unwrap_err();
    let RunCause::Contact { source: ContactError::Singular { .. }, .. } = error.cause() else {
        panic!("{:?}", error.cause())
    };
    let run = error.trajectory();
    assert_eq!(run.events()[1].supports, ["C"]);
    assert!(run.final_state()[0] < 1e-3 && run.statistics().steps < 5000, "{:?}", run.statistics());
}

#[test]
fn names_and_conditions() {
    assert_eq!(message(pair().hold("q")), "no support `q`; did you mean `Q`?");
    assert_eq!(message(pair().release("P", -1.0)), "support `P` cannot be released at t = -1");
    let told = message(pair().until("phi =< 1"));
    assert_eq!(told, "expected a number, a name or `(`, found `<` at column 6");
    assert_eq!(
        message(Output::parse(FallingPair::LAYOUT, "phi = 1")),
        "expected an operator or the end, found `=` at column 5"
    );
}

/// A block on a belt whose friction depends on the slip velocity.
#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[support(P = floor, friction = mu + c * v * v, static = limit, moving = w)]
#[force(P = (f, 0))]
#[figure(P = (0, 0))]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
struct Stribeck {
    m: f64,
    mu: f64,
    c: f64,
    limit: f64,
    w: f64,
    f: f64,
    g: f64,
}

const STRIBECK: Stribeck = Stribeck { m: 1.0, mu: 0.2, c: 0.5, limit: 0.3, w: 0.0, f: 0.0, g: 10.0 };

/// Static friction is compared with that of sliding at v = 0, however fast the belt is: μ(1) = 0.7 >
/// μₛ, and μ(−1) = 0.1 < μₛ.
#[test]
fn static_friction_is_that_of_no_slip() {
    for w in [0.0, 1.0, -1.0, 30.0] {
        assert!(Simulation::new(&Stribeck { w, ..STRIBECK }).is_ok(), "{w}");
        let told = message(Simulation::new(&Stribeck { w, mu: 0.4, c: -0.3, ..STRIBECK }));
        let expected = "static friction 0.3 of P is below its sliding friction 0.4 at v = 0; it must be at least as large";
        assert_eq!(told, expected, "{w}");
        let told = message(Simulation::new(&Stribeck { w, mu: -0.4, limit: 0.5, ..STRIBECK }));
        assert_eq!(told, "friction of P is -0.4: a coefficient of friction is a number ≥ 0", "{w}");
    }
}

/// μ = 0.2 − 0.05 v² vanishes at v = 2, where f = 4 has brought it: m v̇ = f − μ m g = 2 + v²/2, t =
/// atan 1.
#[test]
fn friction_that_becomes_negative_ends_a_run() {
    for method in [MethodId::Auto, MethodId::Taylor, MethodId::Dop853, MethodId::Radau] {
        let block = Stribeck { c: -0.05, f: 4.0, ..STRIBECK };
        let start = Pose::new("x", 0.0).with("x'", 1e-3);
        let run = Simulation::new(&block).unwrap().start(start).unwrap().method(method).limit(5.0).run();
        let error = run.map(|_| ()).unwrap_err();
        let RunCause::NegativeFriction { t, contact, velocity } = error.cause() else { panic!("{error}") };
        assert!((t - (1.0_f64.atan() - 5e-4_f64.atan())).abs() < 1e-9, "{method:?} {t}");
        assert!(contact == "P" && (velocity - 2.0).abs() < 1e-9, "{method:?} {error}");
    }
    // At once where it starts so fast.
    let block = Stribeck { c: -0.05, ..STRIBECK };
    let start = Simulation::new(&block).unwrap().start(Pose::new("x", 0.0).with("x'", 3.0)).unwrap();
    let told = message(start.limit(1.0).run());
    assert!(told.contains("friction of P is negative at this slip velocity: -0.25"), "{told}");
}
