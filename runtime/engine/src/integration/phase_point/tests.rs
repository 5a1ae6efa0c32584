//! A pendulum whose pivot is driven, x = a (1 − cos ω t): time in the state, a row with drift, an
//! odd reduced state. l φ̈ = −g sin φ − ẍ cos φ, with φ from the vertical.

use crate::model::*;
use crate::prelude::*;
use crate::scalar::{Real, Scalar};
use crate::{Output, Simulation};
use liftoff_core::kernel;

/// A point mass P at the distance `l` from the pivot.
struct Driven {
    a: f64,
}

const L: f64 = 0.5;
const G: f64 = 9.81;
const OMEGA: f64 = 3.0;
const M: f64 = 2.0;

static LAYOUT: Layout = Layout::new("Driven")
    .parameters(&["a"])
    .dimensions(&[None])
    .coordinates(&[Coordinate { name: "x", is_angle: false }, Coordinate { name: "phi", is_angle: true }])
    .joints(&[Joint { name: "drive x", is_angle: false }])
    .timed(true)
    .quantities(&[
        Quantity { name: "drive(x)", kind: QuantityKind::DriveForce },
        Quantity { name: "px", kind: QuantityKind::Momentum },
    ])
    .points(&["P"])
    .closed_forms(&[ContactSet::EMPTY]);

fn n<S: Real>(x: f64) -> S {
    S::from_f64(x)
}

/// f, ḟ and f̈ of the drive.
fn drive<S: Real>(a: S, t: S) -> [S; 3] {
    let (s, c) = (n::<S>(OMEGA) * t).sin_cos();
    let w = n::<S>(OMEGA);
    [a * (n::<S>(1.0) - c), a * w * s, a * w * w * c]
}

fn embed<S: Real>(a: &S, [phi, u, t]: &[S; 3]) -> [S; 5] {
    let [x, v, _] = drive(*a, *t);
    [x, *phi, v, *u, *t]
}

impl BarSystem for Driven {
    const LAYOUT: &'static Layout = &LAYOUT;
    type Constants<S: Real> = S;
    type State<S: Real> = [S; 5];
    type Reactions<S: Real> = [S; 0];
    type Accelerations<S: Real> = [S; 2];
    type Multipliers<S: Real> = [S; 1];
    type Kernel<S: Real> = Kernel<S, 2, 1, 3>;
    type Points<S: Real> = [S; 2];
    type Feet<S: Real> = [S; 0];

    type Parameters<S: Real> = [S; 1];
    type Measures = [Measure; 3];
    type Numbers = [f64; 0];

    fn parameters(&self) -> [f64; 1] {
        [self.a]
    }

    fn from_parameters(values: &[f64]) -> Self {
        Self { a: values[0] }
    }

    fn measures(&self) -> [Measure; 3] {
        let of = |kind, value| Measure { of: "pendulum", kind, value };
        [of(MeasureKind::Mass, M), of(MeasureKind::Length, L), of(MeasureKind::Gravity, G)]
    }

    fn numbers(&self) -> [f64; 0] {
        []
    }

    fn nominal(&self) -> [f64; 2] {
        [0.0, 0.3]
    }

    fn constants_of<S: Real>([a]: &[S; 1], _: &ContactSet) -> S {
        *a
    }

    fn kernel<S: Real>(a: &S, [x, phi, _, u, t]: &[S; 5]) -> Kernel<S, 2, 1, 3> {
        let (s, c) = phi.sin_cos();
        let [f, rate, acceleration] = drive(*a, *t);
        let coupling = n::<S>(M * L) * c;
        Kernel {
            mass: [[n(M), coupling], [coupling, n(M * L * L)]],
            force: [n::<S>(M * L) * s * *u * *u, -(n::<S>(M * G * L) * s)],
            gap: [*x - f],
            jacobian: [[n(1.0), n(0.0)]],
            bias: [-acceleration],
            prescribed_gap_rate: [-rate],
            friction: [S::ratio(0, 1)],
        }
    }

    fn energy<S: Real>(_: &S, [_, phi, v, u, _]: &[S; 5]) -> Energy<S> {
        let (s, c) = phi.sin_cos();
        let (across, up) = (*v + n::<S>(L) * c * *u, n::<S>(L) * s * *u);
        Energy { kinetic: n::<S>(0.5 * M) * (across * across + up * up), potential: -(n::<S>(M * G * L) * c) }
    }

    fn points<S: Real>(_: &S, [x, phi, ..]: &[S; 5]) -> [S; 2] {
        let (s, c) = phi.sin_cos();
        [*x + n::<S>(L) * s, -(n::<S>(L) * c)]
    }

    fn feet<S: Real>(_: &S, _: &[S; 5]) -> [S; 0] {
        []
    }

    fn quantity<S: Real>(_: &S, entry: usize, state: &[S; 5], _: &[S; 2], multipliers: &[S; 1]) -> S {
        let [_, phi, v, u, _] = *state;
        match entry {
            0 => multipliers[0],
            1 => n::<S>(M) * (v + n::<S>(L) * phi.sin_cos().1 * u),
            _ => n(f64::NAN),
        }
    }

    fn phase<S: Scalar, V: PhaseVisitor<Self, S>>(set: ContactSet, form: Form, visitor: V) -> V::Output {
        if form == Form::Reduced {
            return visitor.visit::<3>(Phase {
                set,
                form,
                coordinates: 1,
                rates: 1,
                derivative: |a, _, [phi, u, t]| {
                    let (s, c) = phi.sin_cos();
                    let [_, _, pivot] = drive(*a, *t);
                    [*u, -((n::<S>(G) * s + pivot * c) / n(L)), n(1.0)]
                },
                reactions: |_, _, _| [],
                embed,
                restrict: |state| [state[1], state[3], state[4]],
                affine: false,
            });
        }
        visitor.visit::<5>(Phase {
            set,
            form,
            coordinates: 2,
            rates: 2,
            derivative: |a, set, state| kernel::derivative(&Self::kernel(a, state), &LAYOUT, set, state),
            reactions: |_, _, _| [],
            embed: |_, state| *state,
            restrict: |state| *state,
            affine: false,
        })
    }
}

#[test]
fn both_forms_follow_the_drive_and_agree() {
    let motion = |form| {
        let run = Simulation::new(&Driven { a: 0.2 }).unwrap().form(form).tolerance(1e-13);
        run.limit(2.0).run().unwrap()
    };
    let runs = [Form::Reduced, Form::Multipliers].map(motion);
    for run in &runs {
        let state = run.state(1.3);
        assert_eq!((state.len(), run.final_state().len(), run.events()[1].state.len()), (4, 4, 4));
        assert!((state[0] - 0.2 * (1.0 - (OMEGA * 1.3).cos())).abs() < 1e-13, "{state:?}");
        let value = |text: &str| run.value(&Output::parse(Driven::LAYOUT, text).unwrap(), 1.3);
        let (speed, momentum) = (state[2] + L * state[1].cos() * state[3], value("px"));
        assert!((value("vx(P)") - speed).abs() < 1e-13 && (momentum - M * speed).abs() < 1e-13);
        // The drive alone pushes sideways.
        let (force, acceleration) = (value("drive( x )"), value("ax(P)"));
        assert!((force - M * acceleration).abs() < 1e-11, "{force} {acceleration}");
    }
    for (a, b) in runs[0].final_state().iter().zip(runs[1].final_state()) {
        assert!((a - b).abs() < 1e-11, "{a} {b}");
    }
}

#[test]
fn a_phase_is_asked_at_a_time() {
    let driven = Driven { a: 0.2 };
    let t = 0.7;
    let [x, v, pivot] = drive(0.2, t);
    let (phi, u) = (0.4f64, -1.1);
    let expected = -(G * phi.sin() + pivot * phi.cos()) / L;
    for phase in [driven.phase(&[]).unwrap(), driven.projected_phase(&[]).unwrap()] {
        let phase = phase.at_time(t);
        let accelerations = phase.accelerations(&[x, phi, v, u]);
        assert!((accelerations[0] - pivot).abs() < 1e-13 && (accelerations[1] - expected).abs() < 1e-12);
        let (matrix, forces) = (phase.mass_matrix(&[x, phi, v, u]), phase.forces(&[x, phi, v, u]));
        let last = matrix.len() - 1;
        assert!((matrix[last][last] - M * L * L).abs() < 1e-14, "{matrix:?}");
        assert_eq!((matrix.len(), forces.len()), (phase.kept().len(), phase.kept().len()));
    }
}

/// T = ½ M l² s² at rest of the drive; the level of 0.5 rad seen from 0.3 rad.
#[test]
fn an_energy_level_gives_the_free_rate() {
    for form in [Form::Reduced, Form::Multipliers] {
        let start = Simulation::new(&Driven { a: 0.2 }).unwrap().form(form);
        let start = start.start(Pose::new("phi", 0.3)).unwrap().on_energy_of(Pose::new("phi", 0.5)).unwrap();
        let run = start.limit(1e-3).run().unwrap();
        let rate = (2.0 * G / L * (0.3f64.cos() - 0.5f64.cos())).sqrt();
        assert!((run.state(0.0)[3] + rate).abs() < 1e-12, "{} {rate}", run.state(0.0)[3]);
    }
}

/// It swings from 0.3 down to −0.3 and back: the condition ceases a hundredth of a second before it
/// holds again, within one step.
#[test]
fn a_condition_that_ceases_for_a_moment_is_met() {
    let simulation = Simulation::new(&Driven { a: 0.0 }).unwrap().until("phi > -0.2999").unwrap();
    let run = simulation.limit(1.0).run().unwrap();
    let [phi, rate] = [1, 3].map(|entry| run.final_state()[entry]);
    assert_eq!(run.events()[1].kind, EventKind::Stop);
    assert!((phi + 0.2999).abs() < 1e-12 && rate > 0.0, "{phi} {rate}");
}

/// A sign that changes through a pole stops nothing; a zero that is only touched does.
#[test]
fn conditions_are_met_at_zeros_only() {
    let until = |condition: &str| {
        let run = Simulation::new(&Driven { a: 0.0 }).unwrap().until(condition).unwrap().limit(1.0).run();
        let run = run.unwrap();
        (run.events()[1].kind, run.final_state()[1])
    };
    for condition in ["1 / (phi - 0.1) = 0", "(phi - 0.1) / abs(phi - 0.1) = 0"] {
        assert_eq!(until(condition).0, EventKind::End, "{condition}");
    }
    for condition in ["abs(phi - 0.1) = 0", "0 = -2 * (phi - 0.1)^2", "abs(phi) - 0.1"] {
        let (kind, phi) = until(condition);
        assert!(kind == EventKind::Stop && (phi - 0.1).abs() < 1e-12, "{condition} {kind} {phi}");
    }
    for condition in ["2 > 1", "a = 0", "phi = phi", "t = -1", "t = 2 - 2"] {
        let refused = Simulation::new(&Driven { a: 0.0 }).unwrap().until(condition).map(|_| ()).unwrap_err();
        assert_eq!(refused.to_string(), format!("`{condition}` holds always or never: it cannot end a run"));
    }
}
