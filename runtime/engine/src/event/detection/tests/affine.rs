//! Guards that are affine functions of the reduced state, of contacts of every kind.

use super::super::affine::KnownAffineGuards;
use super::given::*;
use crate::model::{ContactSet, Form, Side, Slip};

/// a + b t of each guard, another one for each: series of the dense output, zero for gaps of closed
/// contacts and for the slip of those that do not slide.
#[test]
fn affine_guards_of_every_kind_have_their_series() {
    let number = |k: usize, t: f64| (k as f64 - 7.5) + (3.0 + 2.0 * k as f64) * t;
    let shown = move |t: f64| Shown {
        reactions: core::array::from_fn(|k| number(k, t)),
        gaps: core::array::from_fn(|k| number(20 + k, t)),
        slips: core::array::from_fn(|k| [number(40 + k, t), 0.5]),
        feet: core::array::from_fn(|k| number(60 + k, t)),
        ..Shown::default()
    };
    let slides = set(&[PLAIN]).slipping(RUBBING, Slip::Stick).slipping(GUIDE, Slip::Backward);
    let mut known = KnownAffineGuards::default();
    for closed in [slides.pressing(GUIDE, Side::Negative), ContactSet::EMPTY, set(&[CORNER, THREAD])] {
        let scene = Scene::new((closed, Form::Reduced), shown);
        for _ in 0..2 {
            let (from, to) = (0.25, 1.75);
            let dense = scene.dense([from, to]);
            let guards = known.find_or_compute(&*scene.phase, &scene.context).over(&dense).expect("a line");
            let near = |c: &[f64], expected: &dyn Fn(f64) -> f64| {
                [0.0, 0.4, 1.0].iter().all(|theta| {
                    let found = c.iter().rev().fold(0.0, |sum, c| sum * theta + c);
                    (found - expected(from + (to - from) * theta)).abs() < 1e-12
                })
            };
            for k in 0..CONTACTS + FRICTIONS {
                assert!(near(guards.reaction(k), &|t| shown(t).reactions[k]), "{closed:?} {k}");
            }
            for k in 0..CONTACTS {
                let is_open = !closed.contains(k);
                assert!(
                    near(guards.gap(k), &|t| if is_open { shown(t).gaps[k] } else { 0.0 }),
                    "{closed:?} {k}"
                );
            }
            for k in 0..FRICTIONS {
                let slides = k == 1 && closed.contains(GUIDE);
                let velocity = |t: f64| if slides { shown(t).slips[k][0] } else { 0.0 };
                assert!(near(guards.gap(CONTACTS + k), &velocity), "{closed:?} {k}");
            }
            for end in [0, 1] {
                assert!(near(guards.foot(0, end), &|t| shown(t).feet[end]), "{closed:?} {end}");
            }
        }
    }
}
