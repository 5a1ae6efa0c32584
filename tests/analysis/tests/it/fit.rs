//! Fits to data of closed forms: parameters found again, intervals that cover, and what is refused.

use liftoff::__private::event::Occurrence;
use liftoff::EventFilter;
use liftoff::prelude::*;
use liftoff_analysis::{Datum, Ending, Fit, FitError, Fitted, Place, TrialError, Variable};
use liftoff_core::system::varied;
use liftoff_fixtures::Ladder;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

/// A ball that falls on a floor and bounces.
#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[slider(P = vertical(0))]
#[support(P = floor, restitution = e)]
#[figure(P = (0, 1))]
#[coordinate(y = y(P))]
struct Ball {
    m: f64,
    e: f64,
    g: f64,
}

/// A uniform rod that swings.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(OA, mass = m, length = l)]
#[pin(O = (0, 0))]
#[figure(A = (0, -l))]
#[coordinate(phi = angle(OA), from = down)]
struct Rod {
    m: f64,
    l: f64,
    g: f64,
}

/// A model and its start by values of parameters and then of the start, with the names of those
/// that are varied.
struct Case<M> {
    known: Vec<(&'static str, f64)>,
    vary: &'static [&'static str],
    simulate: fn(&[f64]) -> Result<Simulation, String>,
    model: core::marker::PhantomData<M>,
}

impl<M: BarSystem> Case<M> {
    fn new(
        known: &[(&'static str, f64)],
        vary: &'static [&'static str],
        simulate: fn(&[f64]) -> Result<Simulation, String>,
    ) -> Self {
        Self { known: known.to_vec(), vary, simulate, model: core::marker::PhantomData }
    }

    fn fit(&self, data: Vec<Datum>) -> Result<Fitted, FitError> {
        let place = |name: &str| self.known.iter().position(|(known, _)| *known == name).unwrap();
        let variable = |&name: &&str| {
            let value = self.known[place(name)].1;
            Variable {
                name: name.to_owned(),
                parameter: M::LAYOUT.parameters.iter().position(|parameter| *parameter == name),
                value,
                unit: if value == 0.0 { 1.0 } else { value.abs() },
            }
        };
        let simulate = |values: &[f64]| {
            let mut all: Vec<f64> = self.known.iter().map(|(_, value)| *value).collect();
            self.vary.iter().zip(values).for_each(|(name, value)| all[place(name)] = *value);
            (self.simulate)(&all)
        };
        let model = |parameters: &[liftoff_core::scalar::Dual4]| Ok(varied::<M>(parameters));
        let variables = self.vary.iter().map(variable).collect();
        Fit { simulate: &simulate, model: &model, variables, data }.solve()
    }
}

fn error_text<E: ToString>(error: E) -> String {
    error.to_string()
}

/// From y at the speed y′; m, e and g before.
fn ball(p: &[f64]) -> Result<Simulation, String> {
    let simulation = Simulation::new(&Ball { m: p[0], e: p[1], g: p[2] }).map_err(error_text)?;
    Ok(simulation.start(Pose::new("y", p[3]).with("y'", p[4])).map_err(error_text)?.limit(3.0))
}

const BALL: [(&str, f64); 5] = [("m", 2.0), ("e", 0.5), ("g", 14.0), ("y", 1.0), ("y'", 0.0)];

fn impact(n: usize) -> Place {
    Place::Event(Occurrence::Nth(n), EventFilter { kind: EventKind::Impact, support: None })
}

fn time(place: Place, value: f64) -> Datum {
    Datum { place, output: None, value, deviation: 1.0 }
}

fn series<M: BarSystem>(
    output: &str,
    deviation: f64,
    points: impl Iterator<Item = (f64, f64)>,
) -> Vec<Datum> {
    let output = Output::parse(M::LAYOUT, output).unwrap();
    let datum = |(t, value)| Datum { place: Place::Time(t), output: Some(output.clone()), value, deviation };
    points.map(datum).collect()
}

fn values(fitted: &Fitted) -> Vec<f64> {
    fitted.estimates.iter().map(|estimate| estimate.value).collect()
}

/// t₁ = √(2h/g), t₂ = t₁ (1 + 2e), t₃ = t₁ (1 + 2e + 2e²).
#[test]
fn impact_times_give_gravity_and_restitution() {
    let (e, g, h) = (0.7, 9.81, 1.0f64);
    let fall = (2.0 * h / g).sqrt();
    let times = [1.0, 1.0 + 2.0 * e, 1.0 + 2.0 * e + 2.0 * e * e];
    let data: Vec<Datum> = (1..).zip(times).map(|(n, factor)| time(impact(n), factor * fall)).collect();
    let case = Case::<Ball>::new(&BALL, &["e", "g"], ball);
    let fitted = case.fit(data).unwrap();
    let found = values(&fitted);
    // Of runs at the default tolerance of 1e-12.
    assert!((found[0] - e).abs() < 1e-10 && (found[1] - g).abs() < 1e-9, "{fitted:?}");
    assert_eq!((fitted.freedom, &fitted.ending), (1, &Ending::Converged));
    assert!(fitted.iterations > 2 && fitted.iterations < 12, "{fitted:?}");
}

/// sn(u, k) by the descending Landen transformation (Abramowitz and Stegun, 16.4), and K.
fn elliptic(k: f64) -> (impl Fn(f64) -> f64, f64) {
    let (mut a, mut b, mut ratios) = (1.0f64, (1.0 - k * k).sqrt(), Vec::new());
    while (a - b).abs() > 1e-16 * a {
        let c = 0.5 * (a - b);
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
        ratios.push(c / a);
    }
    let scale = a * 2f64.powi(ratios.len() as i32);
    let sn = move |u: f64| {
        let amplitude =
            ratios.iter().rev().fold(scale * u, |phi, ratio| 0.5 * (phi + (ratio * phi.sin()).asin()));
        amplitude.sin()
    };
    (sn, core::f64::consts::FRAC_PI_2 / a)
}

/// φ = 2 arcsin(k sn(K + ωt)), k = sin(φ₀/2), ω² = 3g/2l, over several turns.
#[test]
fn a_series_of_swings_gives_length_and_start() {
    let (l, g, phi) = (0.8, 9.81f64, 1.1f64);
    let k = (0.5 * phi).sin();
    let (sn, quarter) = elliptic(k);
    let omega = (1.5 * g / l).sqrt();
    let angle = |t: f64| 2.0 * (k * sn(quarter + omega * t)).asin();
    let data = series::<Rod>("phi", 1.0, (1..=40).map(|i| 0.05 * f64::from(i)).map(|t| (t, angle(t))));
    let known = [("m", 1.0), ("l", 0.9), ("g", g), ("phi", 0.9)];
    let case = Case::<Rod>::new(&known, &["l", "phi"], |p| {
        let simulation = Simulation::new(&Rod { m: p[0], l: p[1], g: p[2] }).map_err(error_text)?;
        simulation.start(Pose::new("phi", p[3])).map_err(error_text)
    });
    let fitted = case.fit(data).unwrap();
    let found = values(&fitted);
    assert!((found[0] - l).abs() < 1e-9 && (found[1] - phi).abs() < 1e-9, "{fitted:?}");
    assert_eq!(fitted.ending, Ending::Converged);
}

/// A ladder on smooth floor and wall leaves the wall at two thirds of the height that it starts
/// from.
#[test]
fn an_opening_gives_the_start_without_errors() {
    let theta = 1.1f64;
    let opens = Place::Event(Occurrence::Nth(1), EventFilter { kind: EventKind::Open, support: Some("B") });
    let output = Output::parse(Ladder::LAYOUT, "theta").ok();
    let datum = Datum { place: opens, output, value: (2.0 / 3.0 * theta.sin()).asin(), deviation: 1.0 };
    let case = Case::<Ladder>::new(&[("theta", 1.3)], &["theta"], |p| {
        let ladder = Ladder { m: 1.0, l: 1.0, g: 9.81 };
        Simulation::new(&ladder).map_err(error_text)?.start(Pose::new("theta", p[0])).map_err(error_text)
    });
    let fitted = case.fit(vec![datum]).unwrap();
    let [estimate] = &fitted.estimates[..] else { panic!("{fitted:?}") };
    assert!((estimate.value - theta).abs() < 1e-10, "{fitted:?}");
    assert_eq!((estimate.standard_error, estimate.interval, fitted.scatter), (None, None, None));
}

/// A pair of numbers of the standard normal distribution (Box and Muller).
fn normal(source: &mut ChaCha8Rng) -> f64 {
    let mut uniform = || ((source.next_u64() >> 11) as f64 + 0.5) * 2f64.powi(-53);
    (-2.0 * uniform().ln()).sqrt() * (core::f64::consts::TAU * uniform()).cos()
}

/// The height of a ball that was dropped, through its first impact.
fn height(t: f64, e: f64, g: f64, h: f64) -> f64 {
    let strikes = (2.0 * h / g).sqrt();
    let since = t - strikes;
    if since < 0.0 { h - 0.5 * g * t * t } else { e * g * strikes * since - 0.5 * g * since * since }
}

/// Of 200 series with noise 95 % of the intervals have the true value, within four standard
/// deviations of the binomial distribution, and s² is σ² on average; with weights that differ,
/// given up to a common factor.
#[test]
fn intervals_cover_as_often_as_they_say() {
    let (e, g, h, sigma) = (0.6, 9.81, 1.0, 0.01);
    let known = [("m", 2.0), ("e", 0.55), ("g", 9.5), ("y", 1.02), ("y'", 0.0)];
    let case = Case::<Ball>::new(&known, &["e", "g", "y"], ball);
    let mut source = ChaCha8Rng::seed_from_u64(7);
    let (mut covered, mut squares) = ([0u32; 3], 0.0);
    const REPEATS: u32 = 200;
    for _ in 0..REPEATS {
        let mut data = series::<Ball>("y", 1.0, (1..=16).map(|i| (0.05 * f64::from(i), 0.0)));
        for (i, datum) in data.iter_mut().enumerate() {
            let Place::Time(t) = datum.place else { continue };
            // Every second one is twice as good.
            datum.deviation = if i.is_multiple_of(2) { 2.0 } else { 1.0 };
            datum.value = height(t, e, g, h) + sigma * datum.deviation * normal(&mut source);
        }
        let fitted = case.fit(data).unwrap();
        assert_eq!(fitted.ending, Ending::Converged);
        squares += fitted.scatter.unwrap().powi(2) / (sigma * sigma);
        for ((estimate, truth), count) in fitted.estimates.iter().zip([e, g, h]).zip(&mut covered) {
            let [low, high] = estimate.interval.unwrap();
            *count += u32::from((low..=high).contains(&truth));
        }
    }
    let expected = 0.95 * f64::from(REPEATS);
    let deviation = (0.05 * expected).sqrt();
    for count in covered {
        assert!((f64::from(count) - expected).abs() < 4.0 * deviation, "{covered:?}");
    }
    let freedom = 13.0 * f64::from(REPEATS);
    let mean = squares / f64::from(REPEATS);
    assert!((mean - 1.0).abs() < 4.0 * (2.0 / freedom).sqrt(), "{mean}");
}

/// A straight line through data with noise has the errors of the textbooks: y′ of a ball without
/// gravity to speak of.
#[test]
fn errors_and_correlations_are_those_of_a_straight_line() {
    let points = [(0.1, 1.02), (0.2, 1.09), (0.3, 1.17), (0.4, 1.18), (0.5, 1.27)];
    let known = [("m", 1.0), ("e", 0.5), ("g", 1e-12), ("y", 1.0), ("y'", 0.0)];
    let fitted =
        Case::<Ball>::new(&known, &["y", "y'"], ball).fit(series::<Ball>("y", 1.0, points.into_iter()));
    let fitted = fitted.unwrap();
    let n = points.len() as f64;
    let mean = |of: &dyn Fn((f64, f64)) -> f64| points.iter().map(|&point| of(point)).sum::<f64>() / n;
    let (t, y) = (mean(&|(t, _)| t), mean(&|(_, y)| y));
    let [tt, ty] = [mean(&|(x, _)| (x - t).powi(2)), mean(&|(x, z)| (x - t) * (z - y))];
    let slope = ty / tt;
    let squares = n * mean(&|(x, z)| (z - y - slope * (x - t)).powi(2));
    let variance = squares / (n - 2.0);
    let [level, rate] = [variance * (1.0 / n + t * t / (n * tt)), variance / (n * tt)].map(f64::sqrt);
    // t of three degrees of freedom, from tables.
    let quantile = 3.182446305284263;
    for (estimate, (value, error)) in fitted.estimates.iter().zip([(y - slope * t, level), (slope, rate)]) {
        assert!((estimate.value - value).abs() < 1e-10, "{estimate:?} {value}");
        assert!((estimate.standard_error.unwrap() - error).abs() < 1e-9 * error, "{estimate:?} {error}");
        let [low, high] = estimate.interval.unwrap();
        assert!((0.5 * (high - low) - quantile * error).abs() < 1e-8 * error, "{estimate:?}");
    }
    let correlation = -t / (tt + t * t).sqrt();
    assert!((fitted.correlations[0][1] - correlation).abs() < 1e-9 && fitted.correlations[1][1] == 1.0);
    assert!((fitted.norm - squares.sqrt()).abs() < 1e-10);
    assert!(fitted.residuals.iter().sum::<f64>().abs() < 1e-9);
}

/// From g = 40 the first step leads to a negative g, with which nothing falls.
#[test]
fn steps_that_fail_are_shortened() {
    let known = [("m", 2.0), ("e", 0.5), ("g", 40.0), ("y", 1.0), ("y'", 0.0)];
    let fitted = Case::<Ball>::new(&known, &["g"], ball).fit(vec![time(impact(1), 0.5)]).unwrap();
    assert!((values(&fitted)[0] - 8.0).abs() < 1e-9 && fitted.ending == Ending::Converged, "{fitted:?}");
    assert!(fitted.runs > fitted.iterations + 1, "{fitted:?}");
}

/// No ball falls for 4 s where runs end after 3 s: the best is the last that strikes.
#[test]
fn a_search_that_leads_nowhere_gives_the_best_so_far() {
    let fitted = Case::<Ball>::new(&BALL, &["g"], ball).fit(vec![time(impact(1), 4.0)]).unwrap();
    let Ending::Stopped(why) = &fitted.ending else { panic!("{fitted:?}") };
    assert!(why.contains("there is no first impact in the run"), "{why}");
    assert!((values(&fitted)[0] - 2.0 / 9.0).abs() < 1e-3, "{fitted:?}");
}

/// t₂ = 3 t₁ = 1.13 at e = 1 is the latest, and e lies between 0 and 1.
#[test]
fn a_search_held_up_at_a_bound_has_not_converged() {
    for measured in [2.0, 100.0] {
        let fitted = Case::<Ball>::new(&BALL, &["e"], ball).fit(vec![time(impact(2), measured)]).unwrap();
        let Ending::Stopped(why) = &fitted.ending else { panic!("{fitted:?}") };
        assert!(why.contains("restitution"), "{why}");
        assert!((values(&fitted)[0] - 1.0).abs() < 1e-3, "{fitted:?}");
    }
}

/// y at t = 0 is that of the start, without any motion.
#[test]
fn a_series_at_the_start_gives_the_start() {
    let data = series::<Ball>("y", 1.0, [(0.0, 0.9)].into_iter());
    let fitted = Case::<Ball>::new(&BALL, &["y"], ball).fit(data).unwrap();
    assert!((values(&fitted)[0] - 0.9).abs() < 1e-10, "{fitted:?}");
}

#[test]
fn values_out_of_all_proportion_are_refused() {
    let data = series::<Ball>("y", 1.0, [(0.1, 1e308), (0.2, -1e308)].into_iter());
    let error = Case::<Ball>::new(&BALL, &["g"], ball).fit(data).unwrap_err();
    assert!(matches!(error, FitError::Start(TrialError::TooFar { .. })), "{error}");
}

#[test]
fn unidentifiable_parameters_are_refused_by_name() {
    let times = || vec![time(impact(1), 0.4), time(impact(2), 0.8), time(impact(3), 1.0)];
    let refused = |vary: &'static [&'static str], data: Vec<Datum>| {
        Case::<Ball>::new(&BALL, vary, ball).fit(data).unwrap_err().to_string()
    };
    assert_eq!(refused(&["g", "m"], times()), "the data do not determine m: nothing measured depends on it");
    // From rest t = √(2y/g): only the ratio is determined.
    assert_eq!(
        refused(&["e", "g", "y"], times()),
        "the data do not determine g, y: they are correlated: changes of some compensate changes of the others"
    );
    assert_eq!(refused(&["e", "g"], times()[..1].to_vec()), "1 measured values are too few for 2 variables");
    // Where it strikes its height is 0.
    let height = Datum { output: Some(Output::parse(Ball::LAYOUT, "y").unwrap()), ..time(impact(2), 1.0) };
    assert_eq!(refused(&["e"], vec![height]), "the data do not determine e: nothing measured depends on it");
    assert_eq!(refused(&[], times()), "nothing is varied");
    let told = refused(&["g"], vec![time(impact(90), 2.0)]);
    assert!(told.contains("there is no 90th impact in the run: it ends with `"), "{told}");
    let told = refused(&["g"], series::<Ball>("y", 1.0, [(3.5, 0.0)].into_iter()));
    assert!(told.contains("the run has no y at t = 3.5"), "{told}");
}
