//! The same in other units: by a power of two nothing but the unit changes, to the last bit.

use super::super::{
    Accuracy, Crossing, ExtremumKind, RootStart, TERMS, extrema, rest, stays_above, tail, watch, watch_series,
};
use super::known::sine_series;
use super::{all_extrema, bend, first_root, first_root_series};

const UNITS: [i32; 5] = [-300, -60, -3, 50, 300];

/// What is told of a function, values in its unit.
#[derive(Debug, PartialEq)]
struct Told {
    falls: [Option<Crossing>; 2],
    root: Option<Option<f64>>,
    turns: Vec<(f64, f64, ExtremumKind)>,
}

fn in_unit(verdict: Crossing, unit: f64) -> Crossing {
    match verdict {
        Crossing::Touch { theta, value } => Crossing::Touch { theta, value: value / unit },
        other => other,
    }
}

fn of_values(g: &dyn Fn(f64) -> f64, start: RootStart, delta: f64, unit: f64) -> Told {
    let falls = [false, true].map(|is_noisy| {
        let accuracy = Accuracy { delta: unit * delta, is_noisy };
        watch(|theta| unit * g(theta), start, accuracy).ok().map(|verdict| in_unit(verdict, unit))
    });
    let root = first_root(|theta| unit * g(theta), start, unit * delta).ok();
    let mut turns = Vec::new();
    let _ = extrema(|theta| unit * g(theta), unit * delta, |e| turns.push((e.theta, e.value / unit, e.kind)));
    Told { falls, root, turns }
}

fn of_series(c: &[f64], start: RootStart, delta: f64, unit: f64) -> Told {
    let scaled: Vec<f64> = c.iter().map(|c| unit * c).collect();
    let fall = watch_series(&scaled, start, unit * delta).ok().map(|verdict| in_unit(verdict, unit));
    let root = first_root_series(&scaled, start, unit * delta).ok();
    Told { falls: [fall, None], root, turns: Vec::new() }
}

const STARTS: [RootStart; 5] = [
    RootStart::Free,
    RootStart::Root,
    RootStart::Order(1),
    RootStart::Continues { positive: true },
    RootStart::Continues { positive: false },
];

#[test]
fn functions_are_followed_alike_in_every_unit() {
    let hash = |theta: f64| (theta.to_bits().wrapping_mul(0x9E37_79B9_7F4A_7C15) >> 11) as f64;
    let functions: [&dyn Fn(f64) -> f64; 10] = [
        &|theta| (9.0 * theta).sin() + 0.3,
        &|theta| (theta - 0.3) * (theta - 0.31) * bend(0.4, theta),
        &|theta| theta * (0.6 - theta) * bend(0.1, theta),
        &|theta| (theta - 0.7).abs() * bend(0.2, theta) - 1e-3,
        &|theta| (theta - 0.7).abs() * bend(0.2, theta) + 1e-12,
        &|theta| 1.0 / (theta - 0.123_4),
        &|theta| if theta < 0.4 { 1.5 - theta } else { -1.0 },
        &|theta| 1.0 - (200.0 * theta).sin(),
        &|theta| 3.0 * (theta - 1.000_01).powi(2),
        &|theta| (theta - 0.5).powi(2) + 1e-13 * (hash(theta) / (1u64 << 52) as f64 - 1.0),
    ];
    for (k, g) in functions.iter().enumerate() {
        for delta in [1e-5, 1e-9, 1e-11] {
            for start in STARTS {
                let expected = of_values(g, start, delta, 1.0);
                for unit in UNITS {
                    let found = of_values(g, start, delta, 2f64.powi(unit));
                    assert_eq!(found, expected, "{k} {delta} {start:?} 2^{unit}");
                }
            }
        }
    }
}

#[test]
fn series_are_followed_alike_in_every_unit() {
    let mut cubic = [0.0; TERMS];
    cubic[..4].copy_from_slice(&[0.0, 0.35, -1.2, 1.0]);
    let series = [
        sine_series(4.0, 0.2),
        sine_series(1.0, 3.0),
        sine_series(2.0, 1.0),
        cubic,
        sine_series(2.0, 1.57).map(|c| -c),
    ];
    for mut c in series {
        for raised in [0.0, 1.0, 1.0 - 1e-10] {
            c[0] += raised;
            for delta in [1e-5, 1e-9, 1e-12] {
                for start in STARTS {
                    let expected = of_series(&c, start, delta, 1.0);
                    for unit in UNITS {
                        assert_eq!(of_series(&c, start, delta, 2f64.powi(unit)), expected, "2^{unit} {c:?}");
                    }
                }
            }
        }
        for unit in UNITS.map(|unit| 2f64.powi(unit)) {
            let scaled = c.map(|c| unit * c);
            assert_eq!(tail(&scaled), unit * tail(&c));
            assert_eq!(rest(&scaled, 0.3), rest(&c, 0.3).map(|c| unit * c));
            for level in [-1.0, 0.0, 0.5] {
                assert_eq!(stays_above(&scaled, unit * level), stays_above(&c, level));
            }
        }
    }
}

/// Half of δ, or the noise, is what a minimum beyond the end may be lower by: k (θ − 1 − d)² falls
/// on by k d².
#[test]
fn a_minimum_beyond_the_end_is_seen_to_half_of_its_bound() {
    let delta = 1e-6_f64;
    for k in [0.25, 3.0] {
        for (part, is_seen) in [(0.98, true), (1.02, false)] {
            let d = (part * 0.5 * delta / k).sqrt();
            let g = |theta: f64| k * (theta - 1.0 - d) * (theta - 1.0 - d);
            let series = [k * (1.0 + d) * (1.0 + d), -2.0 * k * (1.0 + d), k];
            for verdict in [watch(g, RootStart::Free, delta), watch_series(&series, RootStart::Free, delta)] {
                let touches = matches!(verdict, Ok(Crossing::Touch { theta: 1.0, .. }));
                assert_eq!(touches, is_seen, "{k} {part} {verdict:?}");
            }
            for root in
                [first_root(g, RootStart::Free, delta), first_root_series(&series, RootStart::Free, delta)]
            {
                assert_eq!(root, Ok(is_seen.then_some(1.0)), "{k} {part}");
            }
            // The noise of one that is looked for is the bound itself.
            let [least, most] = [0.99, 1.01].map(|by| all_extrema(g, by * k * d * d).len());
            assert_eq!((least, most), (0, 1), "{k} {part}");
        }
    }
}
