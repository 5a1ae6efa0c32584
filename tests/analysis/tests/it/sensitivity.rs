//! Derivatives of runs against closed forms, laws of similarity and differences of runs computed in
//! double-double.

use liftoff::prelude::*;
use liftoff_analysis::{Sensitivities, SensitivityError, Variable};
use liftoff_core::scalar::{DoubleDouble, Real};
use liftoff_core::system::{ModelOn, precise, varied};
use liftoff_fixtures::{Belt, BouncingBar, FallingPair, Ladder, Zigzag};
use liftoff_replay::{ReplayError, replay};

/// A ball that falls on a floor and bounces.
#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[support(P = floor, restitution = e)]
#[figure(P = (0, h))]
#[coordinate(y = y(P))]
#[coordinate(x = x(P))]
struct Bouncing {
    m: f64,
    e: f64,
    h: f64,
    g: f64,
}

/// A run and how it is made, with other values of its variables.
struct Case<M> {
    values: Vec<(&'static str, f64)>,
    model: fn(&[f64]) -> M,
    /// The simulation of a model whose start has these values, those of the parameters first.
    simulate: fn(&M, &[f64]) -> Simulation,
}

impl<M: BarSystem> Case<M> {
    fn with_value(&self, k: usize, value: f64) -> Simulation {
        let mut values: Vec<f64> = self.values.iter().map(|(_, value)| *value).collect();
        values[k] = value;
        (self.simulate)(&(self.model)(&values), &values)
    }

    fn run(&self) -> Trajectory {
        self.with_value(0, self.values[0].1).run().unwrap_or_else(|error| panic!("{error}"))
    }

    fn variables(&self) -> Vec<Variable> {
        let layout = M::LAYOUT;
        let variable = |&(name, value): &(&str, f64)| Variable {
            name: name.to_owned(),
            parameter: layout.parameters.iter().position(|parameter| *parameter == name),
            value,
            unit: if value == 0.0 { 1.0 } else { value.abs() },
        };
        self.values.iter().map(variable).collect()
    }

    fn find_index(&self, variable: &Variable) -> usize {
        self.values.iter().position(|(name, _)| *name == variable.name).unwrap()
    }

    fn sensitivities(&self, run: &Trajectory) -> Result<Sensitivities, SensitivityError> {
        Sensitivities::compute(
            run,
            |parameters| Ok(varied::<M>(parameters)),
            &self.variables(),
            |variable, value| {
                self.with_value(self.find_index(variable), value)
                    .start_state()
                    .map_err(|error| error.to_string())
            },
        )
    }

    /// The same by central differences of the sixth order of runs computed once more in
    /// double-double.
    fn by_differences(&self, run: &Trajectory, k: usize) -> (Vec<f64>, Vec<f64>) {
        let variable = &self.variables()[k];
        let h = 2e-4 * variable.unit;
        let (mut times, mut end) = (vec![0.0; run.events().len()], vec![0.0; run.final_state().len()]);
        for (at, weight) in [(1.0, 45.0), (2.0, -9.0), (3.0, 1.0)] {
            for sign in [1.0, -1.0] {
                let simulation = self.with_value(k, variable.value + sign * at * h);
                let moved = simulation.run().unwrap_or_else(|error| panic!("{error}"));
                let on =
                    |values: &[f64]| values.iter().map(|&x| DoubleDouble::from_f64(x)).collect::<Vec<_>>();
                let parameters = moved.parameters();
                let model = ModelOn {
                    system: precise::<M>(parameters),
                    parameters: on(parameters),
                    restitution: on(&moved.model().restitution),
                };
                let replayed = replay(&moved, model, &on(&moved.events()[0].state), 1e-24, &[]).unwrap();
                let weight = sign * weight / (60.0 * h);
                let known = times.iter_mut().zip(&replayed.times);
                known.for_each(|(sum, t)| *sum += weight * t.map_or(0.0, DoubleDouble::hi));
                end.iter_mut().zip(&replayed.end).for_each(|(sum, x)| *sum += weight * x.hi());
            }
        }
        (times, end)
    }

    /// Whether derivatives and differences agree, relative to the largest of a kind.
    fn check(&self) {
        let run = self.run();
        let found = self.sensitivities(&run).unwrap_or_else(|error| panic!("{error}"));
        for (k, (name, _)) in self.values.iter().enumerate() {
            let (times, end) = self.by_differences(&run, k);
            let largest = |values: &[f64]| values.iter().fold(1e-3, |most: f64, x| most.max(x.abs()));
            for ((event, expected), told) in found.events.iter().zip(&times).zip(run.events()) {
                let Some(time) = &event.time else { continue };
                let error = (time[k] - expected).abs() / largest(&times);
                assert!(error < 1e-9, "{told} by {name}: {} or {expected}: {error:e}", time[k]);
            }
            for (row, expected) in found.end.iter().zip(&end) {
                let error = (row[k] - expected).abs() / largest(&end);
                assert!(error < 1e-9, "end by {name}: {} or {expected}: {error:e}", row[k]);
            }
        }
    }
}

fn zigzag() -> Case<Zigzag> {
    Case {
        values: vec![("m1", 0.3), ("m2", 0.5), ("l", 1.0), ("g", 9.81), ("phi_inner", 1.2)],
        model: |p| Zigzag { m1: p[0], m2: p[1], l: p[2], g: p[3] },
        simulate: |model, p| {
            let start = Pose::new("phi_inner", p[4]).with("phi_outer", p[4]);
            Simulation::new(model).unwrap().start(start).unwrap().tolerance(1e-13).limit(0.95)
        },
    }
}

/// Contacts that open one after the other, and strike.
#[test]
fn chains_that_lift_off_have_the_derivatives_of_their_differences() {
    zigzag().check();
}

/// Similarity: m₁ ∂t/∂m₁ + m₂ ∂t/∂m₂ = 0, g ∂t/∂g = −t/2, l ∂t/∂l = t/2 from a start at rest.
#[test]
fn times_scale_as_mechanics_demands() {
    let case = zigzag();
    let run = case.run();
    let found = case.sensitivities(&run).unwrap();
    assert!(run.events().len() >= 3);
    let decided = |(event, _): &(&Event, _)| event.kind != EventKind::End;
    for (event, derivatives) in run.events().iter().zip(&found.events).filter(decided) {
        let [m1, m2, l, g] = [0, 1, 2, 3].map(|k| case.values[k].1 * derivatives.time.as_ref().unwrap()[k]);
        let largest = m1.abs().max(event.t);
        for deviation in [m1 + m2, g + 0.5 * event.t, l - 0.5 * event.t] {
            assert!(deviation.abs() <= 1e-11 * largest, "{event}: {deviation:e}");
        }
    }
}

#[test]
fn bars_that_rotate_over_corners_have_the_derivatives_of_their_differences() {
    Case {
        values: vec![("m", 1.3), ("l", 0.8), ("g", 9.0), ("phi", 0.1)],
        model: |p| FallingPair { m: p[0], l: p[1], g: p[2] },
        simulate: |model, p| {
            let start = Pose::new("phi", p[3]);
            Simulation::new(model).unwrap().start(start).unwrap().limit(0.7).tolerance(1e-13)
        },
    }
    .check();
}

#[test]
fn a_ladder_that_leaves_its_wall_has_the_derivatives_of_its_differences() {
    Case {
        values: vec![("m", 1.3), ("l", 0.8), ("g", 9.0), ("theta", 1.2)],
        model: |p| Ladder { m: p[0], l: p[1], g: p[2] },
        simulate: |model, p| {
            let start = Pose::new("theta", p[3]);
            Simulation::new(model).unwrap().start(start).unwrap().limit(0.5).tolerance(1e-13)
        },
    }
    .check();
}

/// Slip and stick on a moving belt: guards of friction, sliding phases.
#[test]
fn sticking_and_slipping_have_the_derivatives_of_their_differences() {
    Case {
        values: vec![
            ("m", 1.3),
            ("g", 9.0),
            ("k", 20.0),
            ("mu", 0.3),
            ("mu_s", 0.5),
            ("w", 0.4),
            ("x", 1.05),
        ],
        model: |p| Belt { m: p[0], g: p[1], k: p[2], mu: p[3], mu_s: p[4], w: p[5] },
        simulate: |model, p| {
            let start = Pose::new("x", p[6]).with("y", 0.0).with("x'", p[5]);
            Simulation::new(model).unwrap().start(start).unwrap().limit(3.0).tolerance(1e-13)
        },
    }
    .check();
}

/// The belt with friction that falls with the speed of the slip either way.
#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[ground(O = (0, 0))]
#[spring(OP, stiffness = k)]
#[support(P = floor, friction = mu / (1 + c * abs(v)), static = mu_s, moving = w)]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
#[figure(P = (1, 0))]
struct FallingFriction {
    m: f64,
    g: f64,
    k: f64,
    mu: f64,
    mu_s: f64,
    w: f64,
    c: f64,
}

/// Of |v| derivatives are there while the block sticks, and are those of the side where it slips.
#[test]
fn friction_by_the_magnitude_of_slip_has_the_derivatives_of_its_differences() {
    Case {
        values: vec![
            ("m", 1.3),
            ("g", 9.0),
            ("k", 20.0),
            ("mu", 0.3),
            ("mu_s", 0.5),
            ("w", 0.4),
            ("c", 0.7),
            ("x", 1.05),
        ],
        model: |p| FallingFriction { m: p[0], g: p[1], k: p[2], mu: p[3], mu_s: p[4], w: p[5], c: p[6] },
        simulate: |model, p| {
            let start = Pose::new("x", p[7]).with("y", 0.0).with("x'", p[5]);
            Simulation::new(model).unwrap().start(start).unwrap().limit(3.0).tolerance(1e-13)
        },
    }
    .check();
}

/// Impacts of both ends by Newton's law, the rates of the start among the variables.
#[test]
fn a_bar_that_bounces_has_the_derivatives_of_its_differences() {
    Case {
        values: vec![("m", 1.3), ("l", 0.8), ("g", 9.0), ("e", 0.6), ("phi", 0.4), ("phi'", 1.0)],
        model: |p| BouncingBar { m: p[0], l: p[1], g: p[2], e: p[3] },
        simulate: |model, p| {
            let start = Pose::new("phi", p[4]).with("phi'", p[5]).with("x", 0.0).with("y", 1.0);
            Simulation::new(model).unwrap().start(start).unwrap().limit(0.9).tolerance(1e-13)
        },
    }
    .check();
}

/// A level bar strikes with both ends at once: with another angle one of them is first.
#[test]
fn events_that_come_apart_are_refused() {
    let case = Case {
        values: vec![("phi", 0.0)],
        model: |_| BouncingBar { m: 1.0, l: 1.0, g: 9.0, e: 0.5 },
        simulate: |model, p| {
            let start = Pose::new("phi", p[0]).with("x", 0.0).with("y", 1.0);
            Simulation::new(model).unwrap().start(start).unwrap().limit(0.6)
        },
    };
    let error = case.sensitivities(&case.run()).unwrap_err();
    assert!(matches!(error, SensitivityError::Replay(ReplayError::Simultaneous { .. })), "{error}");
}

/// t = √(2h/g) (1 + 2e), δt by every variable; an impact by Newton's law between.
#[test]
fn a_bouncing_ball_has_the_derivatives_of_its_closed_form() {
    let (m, e, h, g) = (2.0, 0.7, 1.3, 9.0);
    let case = Case {
        values: vec![("m", m), ("e", e), ("h", h), ("g", g), ("y", h)],
        model: |p| Bouncing { m: p[0], e: p[1], h: p[2], g: p[3] },
        simulate: |model, p| {
            Simulation::new(model).unwrap().start(Pose::new("y", p[4]).with("x'", 1.0)).unwrap().limit(1.5)
        },
    };
    let run = case.run();
    let found = case.sensitivities(&run).unwrap();
    let fall = (2.0 * h / g).sqrt();
    let impacts = run.events().iter().zip(&found.events).filter(|(event, _)| event.kind == EventKind::Impact);
    for ((_, derivatives), bounces) in impacts.take(2).zip([0.0, 1.0]) {
        let factor = 1.0 + 2.0 * e * bounces;
        let exact = [0.0, 2.0 * bounces * fall, 0.0, -0.5 * fall * factor / g, 0.5 * fall * factor / h];
        for (found, exact) in derivatives.time.as_ref().unwrap().iter().zip(exact) {
            assert!((found - exact).abs() < 1e-11, "{found} or {exact}");
        }
    }
    case.check();
}

/// A bar that falls on a rough floor, with its lower end first.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[support(A = floor, friction = mu, restitution = e, law = poisson)]
#[support(B = floor, friction = mu, restitution = e, law = poisson)]
#[figure(A = (0, l), B = (4 * l / 5, 8 * l / 5))]
#[coordinate(phi = angle(AB), from = horizontal)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
struct RoughBar {
    m: f64,
    l: f64,
    g: f64,
    e: f64,
    mu: f64,
}

fn rough_bar(mu: f64, speed: f64) -> Case<RoughBar> {
    Case {
        values: vec![
            ("m", 1.3),
            ("l", 0.8),
            ("g", 9.0),
            ("e", 0.6),
            ("mu", mu),
            ("phi", 0.7),
            ("phi'", 1.0),
            ("x'", speed),
        ],
        model: |p| RoughBar { m: p[0], l: p[1], g: p[2], e: p[3], mu: p[4] },
        simulate: |model, p| {
            let start =
                Pose::new("phi", p[5]).with("phi'", p[6]).with("x'", p[7]).with("x", 0.0).with("y", 0.5);
            Simulation::new(model).unwrap().start(start).unwrap().limit(0.6).tolerance(1e-13)
        },
    }
}

/// Routh's path: it slips all along, slips and then sticks, slips and then back.
#[test]
fn impacts_with_friction_have_the_derivatives_of_their_differences() {
    for (mu, speed) in [(0.1, 2.0), (1.5, 0.2), (0.3, 0.6)] {
        rough_bar(mu, speed).check();
    }
}

/// A block that falls flat but for a little on a corner, and then on the other while the first one
/// touches.
#[derive(BarSystem)]
#[gravity(g)]
#[body(block, points(A = (-b, -h), B = (b, -h), C = (0, 0)), mass = m, inertia = m * (b * b + h * h) / 3, centre = (0, 0))]
#[support(A = floor, friction = mu)]
#[support(B = floor, friction = mu)]
#[figure(A = (-b, 0), B = (b, 0))]
#[coordinate(phi = angle(block), from = right)]
#[coordinate(x = x(C))]
#[coordinate(y = y(C))]
struct RoughBlock {
    m: f64,
    b: f64,
    h: f64,
    g: f64,
    mu: f64,
}

/// Both corners in one impact, of which one lets go.
#[test]
fn a_block_that_rocks_on_friction_has_the_derivatives_of_its_differences() {
    Case {
        values: vec![("m", 1.3), ("b", 0.3), ("h", 0.7), ("g", 9.0), ("mu", 0.9), ("phi", 0.2)],
        model: |p| RoughBlock { m: p[0], b: p[1], h: p[2], g: p[3], mu: p[4] },
        simulate: |model, p| {
            Simulation::new(model).unwrap().start(Pose::new("phi", p[5])).unwrap().limit(1.5).tolerance(1e-13)
        },
    }
    .check();
}
