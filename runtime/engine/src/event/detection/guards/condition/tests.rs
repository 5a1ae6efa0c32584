//! What decides of a condition over a piece, from its values.

use super::*;
use crate::event::detection::tests::given::from_function;
use crate::model::Layout;
use crate::system::Model;

use liftoff_fixtures::Particle;

fn layout() -> &'static Layout {
    Model::new(&Particle { m: 1.0, g: 1.0, e: 0.0 }).layout()
}

fn comparing() -> [Condition; 3] {
    ["y = 1", "y < 1", "y > 1"].map(|text| Condition::parse(layout(), text).expect("a condition"))
}

/// 1/(θ − p)² + c keeps its sign beside its pole where it does not come near to zero; a line has
/// none.
#[test]
fn a_pole_between_the_places_looked_at_may_hide_a_root() {
    let hides = |value: &dyn Fn(f64) -> f64| may_hide(value, PieceRegularity::Finite);
    for sign in [1.0, -1.0] {
        assert!(!hides(&|theta| sign * (1.0 + theta)));
        assert!(hides(&|theta| sign * (1.0 + theta + 0.01 * (9.0 * theta).sin())));
        assert!(!hides(&|theta| sign * (1.0 + theta + 0.001 * (9.0 * theta).sin())));
        // As towards a pole of even order, and infinite there.
        assert!(!hides(&|theta| sign * (1.0 + 7.1 * (3.2 * theta).sin())));
        assert!(hides(&|theta| sign * (1.0 + 6.9 * (core::f64::consts::PI * theta).sin())));
        for (inner, is_hidden) in [(POLE, false), (0.999 * POLE, true)] {
            assert_eq!(hides(&|theta| sign * if theta == 0.5 { inner } else { 1.0 }), is_hidden);
        }
        // A thousandth of the ends is no bend yet.
        for (inner, is_bent) in [(1001.0, false), (1001.1, true), (999.0, false), (998.9, true)] {
            assert_eq!(hides(&|theta| sign * if theta == 0.5 { inner } else { 1000.0 }), is_bent, "{inner}");
        }
        assert!(!hides(&|theta| if theta == 0.5 { f64::NAN } else { sign * (1.0 + theta) }));
        for known in [PieceRegularity::Finite, PieceRegularity::Pole] {
            assert!(!may_hide(&|theta| sign * (theta - 0.3), known));
            for end in [0.0, 1.0] {
                let infinite = |theta: f64| if theta == end { sign * f64::INFINITY } else { sign };
                assert!(!may_hide(&infinite, known), "{end}");
            }
        }
        // Where bounds are infinite a line may hide it as well.
        assert!(may_hide(&|theta| sign * (1.0 + theta), PieceRegularity::Pole));
        assert!(!may_hide(
            &|theta| sign * (1.0 + 9.0 * (core::f64::consts::PI * theta).sin()),
            PieceRegularity::Pole
        ));
    }
}

#[test]
fn ends_on_different_sides_are_a_passage() {
    for (first, last, found) in [
        (1.0, -1.0, Some(true)),
        (-1.0, 1.0, Some(true)),
        (1.0, 1.0, Some(false)),
        (-1.0, -1.0, Some(false)),
        (0.4, -1.0, None),
        (1.0, -0.4, None),
        (0.5, 1.0, None),
        (-0.5, 1.0, None),
        (1.0, 0.5, None),
        (1.0, -0.5, None),
        (0.51, -0.51, Some(true)),
    ] {
        assert_eq!(passed(&|theta| if theta == 0.0 { first } else { last }, 0.5), found, "{first} {last}");
    }
}

#[test]
fn a_passage_is_wanted_in_one_direction() {
    let [equal, less, greater] = comparing();
    let (rises, falls) = (|theta: f64| theta - 0.5, |theta: f64| 0.5 - theta);
    assert!(is_wanted(&equal, &rises) && is_wanted(&equal, &falls));
    assert!(!is_wanted(&less, &rises) && is_wanted(&less, &falls));
    assert!(is_wanted(&greater, &rises) && !is_wanted(&greater, &falls));
    assert!(!is_wanted(&less, &|_| 1.0) && !is_wanted(&greater, &|_| 1.0) && is_wanted(&equal, &|_| 1.0));
    assert!(!was_false(&equal, Some(true)) && !was_false(&equal, Some(false)));
    for sign in [None, Some(true), Some(false)] {
        assert_eq!(was_false(&less, sign), sign == Some(true));
        assert_eq!(was_false(&greater, sign), sign == Some(false));
    }
}

/// A change of sign is found to the spacing of doubles; it counts where values beside it are near
/// zero, as beside a pole they are not.
#[test]
fn a_change_of_sign_is_halved() {
    let [equal, less, greater] = comparing();
    for (p, sign) in [(0.3, 1.0), (0.62, -1.0), (1e-3, 1.0)] {
        let line = |theta: f64| sign * (theta - p);
        let [low, high] = halved(&line);
        assert!(low <= p && p <= high && high - low <= 2.0 * f64::EPSILON, "{p} {low} {high}");
        let found = changed(&equal, &line, 1e-9);
        assert!(found.is_some_and(|at| (at - p).abs() <= 2.0 * f64::EPSILON), "{p} {found:?}");
        assert_eq!(changed(&less, &line, 1e-9).is_some(), sign < 0.0);
        assert_eq!(changed(&greater, &line, 1e-9).is_some(), sign > 0.0);
        assert_eq!(changed(&equal, &|theta| sign / (theta - p), 1e-9), None);
        let jump = |theta: f64| if theta < p { -sign } else { sign };
        assert_eq!(changed(&equal, &jump, 1e-9), None);
        assert_eq!(changed(&equal, &jump, 0.9), None);
        assert_eq!(changed(&equal, &line, 0.999 * p.min(1.0 - p)), found);
        assert_eq!(changed(&equal, &line, 1.001 * p.max(1.0 - p)), None);
    }
}

/// Within the bound, or a hundredth of the lesser end.
#[test]
fn near_zero_is_less_than_the_ends() {
    for ends in [[2.0, 5.0], [-5.0, 2.0], [5.0, -2.0]] {
        let near = |value: f64, bound: f64| {
            let of = |theta: f64| {
                if theta == 0.0 {
                    ends[0]
                } else if theta == 1.0 {
                    ends[1]
                } else {
                    value
                }
            };
            is_near(&of, 0.5, bound)
        };
        for sign in [1.0, -1.0] {
            assert!(near(sign * 0.0199, 0.0) && !near(sign * 0.0201, 0.0), "{ends:?}");
            assert!(near(sign * 0.5, 0.5) && !near(sign * 0.51, 0.5), "{ends:?}");
        }
    }
}

#[test]
fn a_known_root_lasts_until_it_is_left() {
    let [equal, less, greater] = comparing();
    for value in [0.1, -0.1] {
        let positive = value > 0.0;
        for condition in [&equal, &less, &greater] {
            assert_eq!(after(condition, RootStart::Root, (None, value), 0.1), RootStart::Root);
            let left = if *condition == equal { RootStart::Continues { positive } } else { RootStart::Free };
            assert_eq!(after(condition, RootStart::Root, (None, value), 0.09), left);
            assert_eq!(after(condition, RootStart::Free, (None, value), 1.0), left);
            // What a comparison was false by it comes to zero from.
            for side in [true, false] {
                let is_root = *condition == less && side || *condition == greater && !side;
                let at_root = if is_root { RootStart::Root } else { left };
                assert_eq!(after(condition, RootStart::Free, (Some(side), value), 0.1), at_root);
                assert_eq!(after(condition, RootStart::Free, (Some(side), value), 0.09), left);
            }
        }
    }
}

/// The same by values and by series: c (θ − a)(θ − b)(θ − c).
#[test]
fn the_first_place_where_it_becomes_true() {
    let [equal, less, greater] = comparing();
    let (a, b, c) = (0.2, 0.5, 0.9);
    let series = [-a * b * c, a * b + a * c + b * c, -(a + b + c), 1.0];
    for (sign, falls, rises) in [(1.0, b, a), (-1.0, a, b)] {
        let difference = series.map(|c| sign * c);
        let value = |theta: f64| difference.iter().rev().fold(0.0, |sum, c| sum * theta + c);
        for (condition, expected) in [(&equal, a), (&less, falls), (&greater, rises)] {
            let by_series =
                of_difference(condition, &difference, (RootStart::Free, 1e-12), &|_| true).unwrap();
            let by_values = of_values(condition, &value, (RootStart::Free, 1e-12.into()), &|_| true).unwrap();
            for found in [by_series, by_values] {
                assert!(found.is_some_and(|at| (at - expected).abs() < 1e-14), "{sign} {expected} {found:?}");
            }
        }
    }
    // From a known root the first side that it leaves to.
    for (sign, holds) in [(-1.0, &less), (1.0, &greater)] {
        let difference = [0.0, sign];
        assert_eq!(of_difference(holds, &difference, (RootStart::Root, 1e-12), &|_| true), Ok(Some(0.0)));
        assert_eq!(of_difference(holds, &difference, (RootStart::Free, 1e-12), &|_| true), Ok(None));
        assert_eq!(of_difference(&equal, &difference, (RootStart::Root, 1e-12), &|_| true), Ok(None));
        let value = |theta: f64| sign * theta;
        assert_eq!(of_values(holds, &value, (RootStart::Root, 1e-12.into()), &|_| true), Ok(Some(0.0)));
        assert_eq!(of_values(holds, &value, (RootStart::Free, 1e-12.into()), &|_| true), Ok(None));
    }
}

/// Where there is no patience left it is said that it is not decided, and half of it is left for
/// the next step, but some for each.
#[test]
fn long_searches_are_undecided() {
    let scene = from_function(|t| t);
    // Bounds of the two waves add up: nothing is proved of pieces that hold a turn.
    let endless = scene.condition("sin(1e7*z) - sin(1e7*z)/2 = 0.6");
    let few = [256, 257, 258, 259, 260, 511, 512];
    for (patience, left) in
        [(10_000, 5_000), (1_000, 500), (514, 257)].into_iter().chain(few.map(|few| (few, 256)))
    {
        let (watch, mut findings) = (ConditionGuard::watch(0, &endless, false), Findings::default());
        let mut guard = ConditionGuard { patience, ..ConditionGuard::new(&endless, false) };
        let found = scene.look(|step| guard.find_event(&watch.tracking, step, &mut findings));
        assert!(found == Some(Ok(None)) && findings.undecided.is_some(), "{patience}");
        assert_eq!(guard.patience, left, "{patience}");
    }
    let decided = scene.condition("z = 2");
    let (watch, mut findings) = (ConditionGuard::watch(0, &decided, false), Findings::default());
    let mut guard = ConditionGuard::new(&decided, false);
    assert_eq!(scene.look(|step| guard.find_event(&watch.tracking, step, &mut findings)), Some(Ok(None)));
    assert_eq!((findings.undecided, guard.patience), (None, PATIENCE));
}

/// The difference at the end of a step has a sign, but a comparison that ends it at zero stays on
/// its side.
#[test]
fn a_comparison_at_zero_stays_on_its_side() {
    for (text, stays) in [("z > 0", true), ("z < 0", true), ("z = 0", false)] {
        for (sign, side) in [(1.0, false), (-1.0, true)] {
            let scene = from_function(move |t| sign * (t - 1.0));
            let condition = scene.condition(text);
            let tracking = ConditionGuard::watch(0, &condition, false).tracking;
            let mut guard = ConditionGuard::new(&condition, false);
            scene.look(|step| guard.leave_step(&tracking, step));
            assert_eq!((guard.stays, guard.sign), (stays, Some(stays && side)), "{text} {sign}");
            let scene = from_function(move |t| sign * (t - 0.5));
            scene.look(|step| guard.leave_step(&tracking, step));
            assert_eq!((guard.stays, guard.sign), (false, Some(sign > 0.0)), "{text} {sign}");
        }
    }
}

/// Equations are met at events just before their roots; nothing arrives at the end of a run.
#[test]
fn an_equation_is_met_at_an_event_just_before() {
    let scene = from_function(|t| 1.0 - t);
    for (text, precedence) in [("z = 0", SOLVED), ("z < 0", 0.0), ("z > 0", 0.0)] {
        let condition = scene.condition(text);
        let guard = ConditionGuard::new(&condition, false);
        assert_eq!(guard.precedence(), precedence);
        assert!(!scene.look(|step| guard.may_arrive(step)));
    }
}
