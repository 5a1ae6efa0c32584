//! Runs computed once more in double-double, against values of 30 digits by mpmath: quadrature for
//! the falling pair, a Taylor method for the double pendulum, closed forms for impacts. Parameters
//! and starts are the doubles given.

use liftoff::EventKind;
use liftoff::Scales;
use liftoff::method::Dop853;
use liftoff::prelude::*;
use liftoff_core::scalar::{DoubleDouble, Scalar};
use liftoff_core::system::precise;
use liftoff_fixtures::BouncingBar;
use liftoff_fixtures::DoublePendulum;
use liftoff_fixtures::PairOnCorners;
use liftoff_fixtures::StruckChain;
use liftoff_verification::{Reference, ReferenceError, ReplayError, Source};

type Outcome = Result<(), Box<dyn std::error::Error>>;

/// A bouncing point.
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[particle(P, mass = m)]
#[support(P = floor, restitution = e)]
#[figure(P = (0, 1))]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
struct Ball {
    m: f64,
    g: f64,
    e: f64,
}

/// The number with these digits, of which 30 decimals are kept.
fn digits(text: &str) -> DoubleDouble {
    let hi: f64 = text.parse().expect("a number");
    let places = |text: &str| -> i128 {
        let (whole, part) = text.split_once('.').expect("decimals");
        format!("{whole}{part:0<30.30}").parse().expect("digits")
    };
    let low = places(text) - places(&format!("{hi:.40}"));
    DoubleDouble::new(hi, low as f64 * 1e-30)
}

/// Far below what doubles tell: the judge's roots of reactions are known to some 1e-20.
fn assert_near(value: DoubleDouble, text: &str) {
    let error = (value - digits(text)).abs().to_f64();
    assert!(error < 1e-19 * value.abs().to_f64().max(1.0), "{error:e} of {text}: {value:?}");
}

fn times(reference: &Reference) -> Vec<Option<DoubleDouble>> {
    reference.events().iter().map(|event| event.t).collect()
}

fn assert_falls_as_quadrature_says(form: Form) -> Outcome {
    let model = PairOnCorners { m: 1.0, l: 1.0, g: 9.81 };
    let run = Simulation::new(&model)?.start(Pose::new("phi", 0.1))?.until("phi = pi/2")?.form(form).run()?;
    let reference = Reference::compute(&run, &[], precise::<PairOnCorners>)?;
    let [Some(start), Some(opens), Some(ends)] = times(&reference)[..] else { panic!("start, opening, end") };
    assert_eq!(reference.source(), &Source::Judge);
    assert_eq!(start, DoubleDouble::ZERO);
    assert_near(opens, "0.8293618472282603385075869045481");
    assert_near(ends, "1.2444614831645270239490916626288");
    assert_near(reference.state()[0], "1.5707963267948966192313216916398");
    assert_near(reference.state()[1], "2.14327884142647309014667176559");
    assert_near(reference.state()[2], "1.6965824086554231443865255639253");
    // The run's tolerance is 1e-12.
    assert!(reference.bound() < 1e-18 && reference.state_error(&run.final_state()) < 1e-11);
    assert!(reference.time_error(1, run.events()[1].t).is_some_and(|error| error < 1e-11));
    Ok(())
}

#[test]
fn lift_off_and_end_of_the_falling_pair() -> Outcome {
    assert_falls_as_quadrature_says(Form::Reduced)
}

/// By multipliers and projection the motion is the same but for the rounding of its start.
#[test]
fn the_same_without_closed_forms() -> Outcome {
    let model = PairOnCorners { m: 1.0, l: 1.0, g: 9.81 };
    let run = |form| -> Result<_, Box<dyn std::error::Error>> {
        let start = Simulation::new(&model)?.start(Pose::new("phi", 0.1))?;
        Ok(Reference::compute(&start.until("phi = pi/2")?.form(form).run()?, &[], precise::<PairOnCorners>)?)
    };
    let (closed, projected) = (run(Form::Reduced)?, run(Form::Multipliers)?);
    for (a, b) in times(&closed).iter().zip(times(&projected)) {
        let (a, b) = (a.expect("no touch"), b.expect("no touch"));
        assert!((a - b).abs().to_f64() < 4.0 * f64::EPSILON, "{a:?} {b:?}");
    }
    assert!(projected.bound() < 1e-17, "{:e}", projected.bound());
    Ok(())
}

#[test]
fn a_double_pendulum_after_ten_seconds() -> Outcome {
    let model = DoublePendulum { m: 1.0, l: 1.0, g: 9.81 };
    let start = Pose::new("a", 2.0).with("b", 1.0);
    let run = Simulation::new(&model)?.start(start)?.until("t = 10")?.run()?;
    let reference = Reference::compute(&run, &[], precise::<DoublePendulum>)?;
    assert_eq!(reference.source(), &Source::Judge);
    let expected = [
        "0.993000786578872811843386338785",
        "-20.1322585272673241379417894021",
        "2.25617695617845328036387291061",
        "-5.67298406502007279024217017691",
    ];
    reference.state().iter().zip(expected).for_each(|(&value, text)| assert_near(value, text));
    Ok(())
}

/// tₙ = √(2h/g) (1 + 2e + … + 2eⁿ).
#[test]
fn impacts_keep_their_digits() -> Outcome {
    let model = Ball { m: 1.0, g: 9.81, e: 0.8 };
    let start = Pose::new("y", 1.0).with("x", 0.0);
    let run = Simulation::new(&model)?.start(start)?.until("t = 2.5")?.run()?;
    let reference = Reference::compute(&run, &[], precise::<Ball>)?;
    let times: Vec<_> = times(&reference).into_iter().map(|t| t.expect("no touch")).collect();
    let expected = [
        "0.45152364098573089300438960606833",
        "1.173961466562900361914768366573",
        "1.7519117270246359691257556876129",
        "2.2142719353940244805606929945539",
    ];
    assert_eq!(times.len(), 6);
    times[1..5].iter().zip(expected).for_each(|(&t, text)| assert_near(t, text));
    assert_near(reference.state()[1], "0.11795005964214820531258281700668");
    assert_near(reference.state()[3], "-0.98869085614313927624287317156911");
    Ok(())
}

/// A blow J across the bars at C: hinge impulse J/4, so that α̇ = −3J/2ml, β̇ = 9J/2ml and ẏ = −J/m
/// at B.
#[test]
fn a_blow_keeps_its_digits() -> Outcome {
    let run = Simulation::new(&StruckChain { m: 1.0, l: 1.0 })?.impulse("C", [0.0, 1.0], 0.5)?;
    let reference = Reference::compute(&run.until("t = 0.5")?.run()?, &[], precise::<StruckChain>)?;
    assert_eq!(reference.source(), &Source::Judge);
    let rates: Vec<f64> = reference.state()[4..].iter().map(|rate| rate.to_f64()).collect();
    assert_eq!(rates, [-1.5, 4.5, 0.0, -1.0]);
    for rate in &reference.state()[4..] {
        assert!(rate.lo().abs() < 1e-22, "{rate:?}");
    }
    Ok(())
}

#[test]
fn without_a_motion_there_is_no_reference() -> Outcome {
    let run =
        Simulation::new(&PairOnCorners { m: 1.0, l: 1.0, g: 9.81 })?.start(Pose::new("phi", 0.0))?.run();
    assert!(run.is_err_and(|error| {
        Reference::compute(error.trajectory(), &[], precise::<PairOnCorners>)
            == Err(ReplayError::Empty.into())
    }));
    Ok(())
}

/// tₙ as above to the end at √(2h/g) (1 + e)/(1 − e), whatever a run sums up in it.
#[test]
fn infinitely_many_impacts_have_their_end() -> Outcome {
    let model = Ball { m: 1.0, g: 9.81, e: 0.5 };
    let simulation = Simulation::new(&model)?.start(Pose::new("y", 1.0).with("x", 0.0))?.until("t = 2")?;
    let run = simulation.clone().tolerance(1e-13).run()?;
    let reference = Reference::compute(&run, &[], precise::<Ball>)?;
    assert_eq!(reference.source(), &Source::Judge);
    let settles = reference.events().iter().find(|event| event.kind == EventKind::Settle).expect("an end");
    assert_near(settles.t.expect("a time"), "1.354570922957192679013168818205");
    for tolerance in [1e-4, 1e-8, 1e-12] {
        let run = simulation.clone().tolerance(tolerance).run()?;
        let late = reference.lateness(run.events().iter());
        assert!(late.is_some_and(|late| late < 100.0 * tolerance.max(1e-9)), "{tolerance:e}: {late:?}");
    }
    assert!(matches!(
        Reference::replayed(&run, precise::<Ball>),
        Err(ReferenceError::Replay(ReplayError::Settles { .. }))
    ));
    Ok(())
}

/// Velocities of points, reactions and energies end runs: y = 1 − gt²/2 falls at the speed 2 after
/// 2/g.
#[test]
fn conditions_are_found_by_the_judge() -> Outcome {
    let model = Ball { m: 2.0, g: 9.81, e: 0.0 };
    let start = Pose::new("y", 1.0).with("x", 0.0);
    let end = |condition: &str| -> Result<(Reference, f64), Box<dyn std::error::Error>> {
        let run = Simulation::new(&model)?.start(start.clone())?.until(condition)?.limit(5.0).run()?;
        let reference = Reference::compute(&run, &[], precise::<Ball>)?;
        let t = reference.events().last().and_then(|event| event.t).expect("a time").to_f64();
        Ok((reference, t))
    };
    for condition in ["vy(P) = -2", "T = 4", "y' < -2", "y < 1 - 2/g", "-2*vy(P)*y' + 8 = 0"] {
        let (reference, t) = end(condition)?;
        assert_eq!(reference.source(), &Source::Judge);
        assert!((t - 2.0 / 9.81).abs() < 1e-15, "{condition}: {t}");
    }
    // At rest on the floor from √(2/g) on.
    let (reference, t) = end("t = 1")?;
    assert_eq!((reference.source(), t), (&Source::Judge, 1.0));
    // What the judge cannot read is replayed, and said to be so.
    let (reference, t) = end("abs(y') = 2")?;
    assert!(matches!(reference.source(), Source::Replay { why } if why.contains("absolute values")));
    assert!((t - 2.0 / 9.81).abs() < 1e-15, "{t}");
    Ok(())
}

/// A bar that comes down turned by half: level with B to the left of A, while the figure has it on
/// the right.
#[test]
fn the_other_branch_of_a_closed_form_is_followed() -> Outcome {
    let bar = BouncingBar { m: 1.0, l: 1.0, g: 9.81, e: 0.0 };
    let start = Pose::new("phi", core::f64::consts::PI).with("x", 0.0).with("y", 1.0);
    let run = Simulation::new(&bar)?.start(start)?.limit(5.0).run()?;
    let reference = Reference::compute(&run, &[], precise::<BouncingBar>)?;
    assert!(reference.state_error(&run.final_state()) < 1e-10);
    Ok(())
}

/// A point that gravity and a spring pull to the floor.
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[particle(P, mass = m)]
#[ground(O = (0, 0))]
#[spring(OP, stiffness = k)]
#[support(P = floor, restitution = e)]
#[figure(P = (0, 1))]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
struct SprungBall {
    m: f64,
    k: f64,
    g: f64,
    e: f64,
}

/// ÿ = −y − 1: from an impact on y = v sin s + cos s − 1, to the next at s = 2 arctan v. In the
/// middles of 32 parts, but for those between an event of the run and its true time, whatever the
/// run sums up.
#[test]
fn the_error_over_a_run_that_settles_is_that_against_a_closed_form() -> Outcome {
    let (e, end) = (0.7, 8.0);
    let model = SprungBall { m: 1.0, k: 1.0, g: 1.0, e };
    let simulation = Simulation::new(&model)?.start(Pose::new("y", 1.0).with("x", 0.0))?.until("t = 8")?;
    let reference =
        Reference::compute(&simulation.clone().tolerance(1e-13).run()?, &[], precise::<SprungBall>)?;
    let speeds = (1..150).map(|n| 3f64.sqrt() * e.powi(n));
    let flights = speeds.scan(core::f64::consts::FRAC_PI_3, |t, v| {
        let begins = *t;
        *t += 2.0 * v.atan();
        Some((begins, v))
    });
    let flights: Vec<(f64, f64)> = flights.collect();
    let rest = flights[flights.len() - 1].0;
    let state = |t: f64| match flights.iter().take_while(|(begins, _)| *begins <= t).last() {
        _ if t >= rest => [0.0, 0.0],
        None => [2.0 * t.cos() - 1.0, -2.0 * t.sin()],
        Some((begins, v)) => {
            let (sine, cosine) = (t - begins).sin_cos();
            [v * sine + cosine - 1.0, v * cosine - sine]
        }
    };
    for tolerance in [1e-3, 1e-4, 1e-5, 1e-6] {
        let run = simulation.clone().method(Dop853).tolerance(tolerance).run()?;
        let Scales { length, time, .. } = run.scales();
        let of_kind = |kind| run.events().iter().filter(move |event| event.kind == kind).map(|event| event.t);
        let impacts = of_kind(EventKind::Impact).zip(flights.iter().map(|(begins, _)| *begins));
        let pairs: Vec<_> = impacts.chain(of_kind(EventKind::Settle).map(|t| (t, rest))).collect();
        let mut largest = 0.0_f64;
        for t in (0..32).map(|k| end * (f64::from(k) + 0.5) / 32.0) {
            if pairs.iter().all(|(own, known)| (own - t) * (known - t) > 0.0) {
                let (found, [y, v]) = (run.state(t), state(t));
                let errors = [(found[1] - y) / length, (found[3] - v) / (length / time)];
                largest = errors.into_iter().fold(largest, |most, error| most.max(error.abs()));
            }
        }
        let error = reference.run_error(&run).expect("the same events");
        assert!((error / largest - 1.0).abs() < 1e-4, "{tolerance:e}: {error:e}, not {largest:e}");
    }
    Ok(())
}
