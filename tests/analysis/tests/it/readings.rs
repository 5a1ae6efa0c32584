//! Derivatives of outputs at given times and behind events, against central differences of runs by
//! the engine's own methods.

use liftoff::prelude::*;
use liftoff_core::scalar::Dual4;
use liftoff_core::system::varied;
use liftoff_fixtures::{Belt, Block, BouncingBar, Zigzag};
use liftoff_replay::{Moment, Reading, ReplayError, replay_outputs};

/// Half the step of the differences, relative: its sixth power is 1e-18, and rounding of runs at
/// 1e-13 gives 1e-10.
const STEP: f64 = 1e-3;
/// Ten times that, as derivatives of outputs that turn fast have larger parts of higher order.
const AGREES: f64 = 1e-8;

/// A model with four parameters that are varied and a start in which none of them enters.
struct Case {
    values: [f64; 4],
    run: fn([f64; 4]) -> Trajectory,
    model: fn(&[Dual4]) -> liftoff_core::system::ModelOn<Dual4>,
    /// The places of the four among the parameters.
    parameters: [usize; 4],
    outputs: &'static [&'static str],
}

impl Case {
    /// Of every output by every parameter at `moment`, relative to the largest.
    fn check(&self, moments: &[Moment]) {
        let run = (self.run)(self.values);
        let outputs: Vec<Output> = self.outputs.iter().map(|text| run.output(text).unwrap()).collect();
        for &moment in moments {
            let readings: Vec<_> =
                outputs.iter().map(|output| Reading { moment, output: Some(output) }).collect();
            let found = self.replay(&run, &readings).unwrap_or_else(|error| panic!("{error}"));
            for (output, found) in outputs.iter().zip(found) {
                let exact = self.by_differences(output, moment);
                let largest = exact.iter().fold(1.0, |most: f64, x| most.max(x.abs()));
                let scaled = |k: usize| found.gradient()[k] * self.values[k];
                for k in 0..4 {
                    let error = (scaled(k) - exact[k]).abs() / largest;
                    assert!(error < AGREES, "{output} at {moment:?} by {k}: {} {}", scaled(k), exact[k]);
                }
            }
        }
    }

    fn replay(&self, run: &Trajectory, readings: &[Reading<'_>]) -> Result<Vec<Dual4>, ReplayError> {
        let seed = |i: usize| core::array::from_fn(|k| if self.parameters[k] == i { 1.0 } else { 0.0 });
        let parameters: Vec<Dual4> =
            run.parameters().iter().enumerate().map(|(i, &value)| Dual4::new(value, seed(i))).collect();
        let start: Vec<Dual4> = run.events()[0].state.iter().map(|&x| Dual4::new(x, [0.0; 4])).collect();
        replay_outputs(run, (self.model)(&parameters), &start, 1e-12, readings)
    }

    /// p ∂y/∂p.
    fn by_differences(&self, output: &Output, moment: Moment) -> [f64; 4] {
        core::array::from_fn(|k| {
            let moved = |by: f64| {
                let mut values = self.values;
                values[k] *= 1.0 + by * STEP;
                let run = (self.run)(values);
                let t = match moment {
                    Moment::Time(t) => t,
                    Moment::Event(k) => run.events()[k].t,
                };
                run.value(output, t)
            };
            let term = |by: f64, weight: f64| weight * (moved(by) - moved(-by));
            (term(1.0, 45.0) + term(2.0, -9.0) + term(3.0, 1.0)) / (60.0 * STEP)
        })
    }
}

/// Times in the middle of every phase, and every event with a motion behind it.
fn moments(run: &Trajectory) -> Vec<Moment> {
    let middle = run.segments().into_iter().map(|phase| Moment::Time(0.4 * phase.t0 + 0.6 * phase.t1));
    let behind = (1..run.events().len() - 1).filter(|&k| run.events()[k].kind != EventKind::Touch);
    behind.map(Moment::Event).chain(middle).collect()
}

/// Contacts that open one after the other, and strike; reactions and energies.
#[test]
fn outputs_of_chains_that_lift_off() {
    let case = Case {
        values: [0.3, 0.5, 1.0, 9.81],
        run: |[m1, m2, l, g]| {
            let start = Pose::new("phi_inner", 1.2).with("phi_outer", 1.2);
            let run = Simulation::new(&Zigzag { m1, m2, l, g }).unwrap().start(start).unwrap();
            run.tolerance(1e-13).limit(0.95).run().unwrap()
        },
        model: |parameters| varied::<Zigzag>(parameters),
        parameters: [0, 1, 2, 3],
        outputs: &["phi_inner", "phi_outer'", "N(A)", "T/(m1*g*l)", "y(D)"],
    };
    let run = (case.run)(case.values);
    assert!(run.events().len() >= 3);
    case.check(&moments(&run));
    // The order in which they are asked for is kept; steps of other lengths have other errors, of
    // the tolerance each.
    let output = run.output("phi_inner").unwrap();
    let at = |t: f64| Reading { moment: Moment::Time(t), output: Some(&output) };
    let [late, soon] = [0.5, 0.2].map(at);
    let found = case.replay(&run, &[late, soon]).unwrap();
    let [a, b] = [case.replay(&run, &[late]).unwrap()[0], case.replay(&run, &[soon]).unwrap()[0]];
    assert!((found[0].value() - a.value()).abs() + (found[1].value() - b.value()).abs() < 1e-10);
}

/// Sliding and sticking phases, whose first ends where friction decides.
#[test]
fn outputs_of_a_block_on_a_belt() {
    let case = Case {
        values: [1.3, 20.0, 0.3, 0.5],
        run: |[m, k, mu, mu_s]| {
            let belt = Belt { m, g: 9.0, k, mu, mu_s, w: 0.4 };
            let start = Pose::new("x", 1.05).with("y", 0.0).with("x'", 0.4);
            let run = Simulation::new(&belt).unwrap().start(start).unwrap();
            run.limit(3.0).tolerance(1e-13).run().unwrap()
        },
        model: |parameters| varied::<Belt>(parameters),
        parameters: [0, 2, 3, 4],
        outputs: &["x", "x'", "x''", "R(P)", "v(P)"],
    };
    let run = (case.run)(case.values);
    assert!(run.segments().len() >= 3);
    case.check(&moments(&run));
}

/// Impacts: rates and positions behind them.
#[test]
fn outputs_of_a_bar_that_bounces() {
    let case = Case {
        values: [1.3, 0.8, 9.0, 0.6],
        run: |[m, l, g, e]| {
            let rates = Pose::new("phi'", 1.0).with("x'", 0.1).with("y'", -0.4);
            let start = rates.with("phi", 0.4).with("x", 0.0).with("y", 1.0);
            let run = Simulation::new(&BouncingBar { m, l, g, e }).unwrap().start(start).unwrap();
            run.limit(0.9).tolerance(1e-13).run().unwrap()
        },
        model: |parameters| varied::<BouncingBar>(parameters),
        parameters: [0, 1, 2, 3],
        outputs: &["phi", "phi'", "y'", "E"],
    };
    let run = (case.run)(case.values);
    assert!(run.segments().len() >= 3);
    case.check(&moments(&run));
}

/// A block lands on a rough corner and tips on it.
#[test]
fn outputs_of_a_block_that_lands() {
    let case = Case {
        values: [1.3, 0.3, 0.7, 9.0],
        run: |[m, b, h, g]| {
            let start = Pose::new("theta", 0.2).with("x", 0.0).with("y", 2.0);
            let start = start.with("theta'", 0.1).with("x'", 0.1).with("y'", 0.0);
            let run = Simulation::new(&Block { m, b, h, g }).unwrap().start(start).unwrap();
            run.limit(0.75).tolerance(1e-13).run().unwrap()
        },
        model: |parameters| varied::<Block>(parameters),
        parameters: [0, 1, 2, 3],
        outputs: &["theta'", "R(A)", "N(A)"],
    };
    let run = (case.run)(case.values);
    assert!(run.segments().len() >= 2 && run.value(&run.output("R(A)").unwrap(), 0.7).abs() > 0.1);
    case.check(&moments(&run));
}

#[test]
fn what_cannot_be_read_is_named() {
    let run = Simulation::new(&BouncingBar { m: 1.0, l: 1.0, g: 9.0, e: 0.5 }).unwrap();
    let run =
        run.start(Pose::new("phi", 0.4).with("x", 0.0).with("y", 1.0)).unwrap().limit(0.3).run().unwrap();
    let velocity = run.output("vx(A)").unwrap();
    let start: Vec<Dual4> = run.events()[0].state.iter().map(|&x| Dual4::new(x, [0.0; 4])).collect();
    let parameters: Vec<Dual4> = run.parameters().iter().map(|&x| Dual4::new(x, [0.0; 4])).collect();
    let read = |reading: Reading<'_>| {
        replay_outputs(&run, varied::<BouncingBar>(&parameters), &start, 1e-12, &[reading])
            .unwrap_err()
            .to_string()
    };
    let told = read(Reading { moment: Moment::Time(0.1), output: Some(&velocity) });
    assert_eq!(told, "`vx(A)` needs velocities of points, which are known in double precision only");
    assert_eq!(read(Reading { moment: Moment::Time(0.4), output: None }), "t = 0.4 is not within the run");
    assert_eq!(read(Reading { moment: Moment::Event(9), output: None }), "t = 0.3 is not within the run");
}
