//! What a guard does at a sequence of points, at the borders of what is known of it.

use super::super::bracket::Point;
use super::super::partition::{Node, beyond};
use super::super::search::{RootSearch, SearchResult};
use super::super::sign_history::History;
use super::super::{Crossing, RootStart};

pub(super) const DELTA: f64 = 0.25;

pub(super) fn node(theta: f64, value: f64) -> Node {
    Node { point: Point { theta, value }, noise: 0.0, beyond: f64::INFINITY, smooth: true }
}

/// What a guard does whose turning points and ends are these, linear in between.
fn verdict(mut history: History, points: &[[f64; 2]], last: Node) -> Crossing {
    let all: Vec<[f64; 2]> = points.iter().copied().chain([[last.point.theta, last.point.value]]).collect();
    points.iter().for_each(|&[theta, value]| history.follow(node(theta, value)));
    history.follow(last);
    history.verdict(&mut |theta| {
        let [[a, x], [b, y]] =
            all.windows(2).find(|pair| theta <= pair[1][0]).map(|pair| [pair[0], pair[1]]).unwrap();
        x + (y - x) * (theta - a) / (b - a)
    })
}

fn find_crossing(points: &[[f64; 2]], last: [f64; 2]) -> Crossing {
    verdict(History::new(RootStart::Free, DELTA), points, node(last[0], last[1]))
}

const TOUCH: fn(f64, f64) -> Crossing = |theta, value| Crossing::Touch { theta, value };

#[test]
fn a_guard_at_its_bound_has_not_left_it() {
    let beyond = DELTA.next_up();
    // Below −δ only.
    assert_eq!(find_crossing(&[[0.0, 1.0]], [1.0, -DELTA]), Crossing::Clear);
    assert!(matches!(find_crossing(&[[0.0, 1.0]], [1.0, -beyond]), Crossing::At { .. }));
    // A minimum within ±δ counts once it has risen from it, and wherever it goes then.
    for lowest in [DELTA, 0.0, -DELTA] {
        assert_eq!(find_crossing(&[[0.0, 1.0], [0.5, lowest]], [1.0, 0.75]), TOUCH(0.5, lowest));
        assert_eq!(find_crossing(&[[0.0, 1.0], [0.5, lowest], [0.75, 1.0]], [1.0, -1.0]), TOUCH(0.5, lowest));
    }
    assert_eq!(find_crossing(&[[0.0, 1.0], [0.5, beyond]], [1.0, 1.0]), Crossing::Clear);
    assert!(matches!(find_crossing(&[[0.0, 1.0], [0.5, -beyond]], [1.0, 1.0]), Crossing::At { .. }));
    // Not above δ, it falls through zero after all.
    assert_eq!(
        find_crossing(&[[0.0, 1.0], [0.5, 0.0], [0.75, DELTA]], [1.0, -1.0]),
        Crossing::At { theta: 0.8 }
    );
    assert_eq!(find_crossing(&[[0.0, 1.0], [0.5, 0.0], [0.75, beyond]], [1.0, -1.0]), TOUCH(0.5, 0.0));
}

/// Of several within the band the lowest counts, of equal ones the first.
#[test]
fn the_lowest_minimum_within_the_band_is_the_touch() {
    for (first, second, third, expected) in [
        (0.1, 0.05, 0.2, (0.4, 0.05)),
        (0.1, 0.1, 0.1, (0.2, 0.1)),
        (0.05, 0.1, -0.1, (0.6, -0.1)),
        (-0.1, 0.1, 0.05, (0.2, -0.1)),
    ] {
        let points = [[0.0, 1.0], [0.2, first], [0.3, 0.24], [0.4, second], [0.5, 0.24], [0.6, third]];
        assert_eq!(
            find_crossing(&points, [1.0, 1.0]),
            TOUCH(expected.0, expected.1),
            "{first} {second} {third}"
        );
    }
}

/// Zero at the start is no place to come down from, zero on the way is one.
#[test]
fn a_guard_comes_down_from_above() {
    assert_eq!(find_crossing(&[[0.0, 0.0]], [1.0, -1.0]), Crossing::LeavesAtStart);
    assert_eq!(find_crossing(&[[0.0, -0.125]], [1.0, -1.0]), Crossing::LeavesAtStart);
    assert_eq!(find_crossing(&[[0.0, 1.0], [0.5, 0.0]], [1.0, -1.0]), Crossing::At { theta: 0.5 });
    assert_eq!(find_crossing(&[[0.0, 0.0], [0.5, 0.0]], [1.0, -1.0]), Crossing::At { theta: 0.5 });
    // The last change of sign within the band.
    let points = [[0.0, 1.0], [0.25, -0.125], [0.5, 0.125], [0.75, -0.125]];
    assert_eq!(find_crossing(&points, [1.0, -1.0]), Crossing::At { theta: 0.625 });
}

/// Up to its bound it is at the known root; a divided series has every sign behind it.
#[test]
fn a_guard_is_at_its_known_root_until_it_is_above_its_bound() {
    let end = node(1.0, -1.0);
    for start in [RootStart::Root, RootStart::Order(2)] {
        let of = |top: f64| verdict(History::new(start, DELTA), &[[0.0, 0.0], [0.5, top]], end);
        assert_eq!(of(DELTA), Crossing::LeavesAtStart, "{start:?}");
        assert!(matches!(of(DELTA.next_up()), Crossing::At { .. }), "{start:?}");
        let series = verdict(History::of_series(start, DELTA), &[[0.0, 0.0], [0.5, 0.125]], end);
        assert_eq!(
            matches!(series, Crossing::At { .. }),
            start == RootStart::Order(2),
            "{start:?} {series:?}"
        );
        // A minimum counts only behind.
        let dips =
            verdict(History::new(start, DELTA), &[[0.0, 0.0], [0.25, 0.2], [0.5, 0.0]], node(1.0, 1.0));
        assert_eq!(dips, Crossing::Clear, "{start:?}");
    }
}

/// At the end a minimum counts where what is beyond it is less than its noise, or than half of δ.
#[test]
fn a_minimum_at_the_end_counts_where_it_goes_on_for_less_than_the_noise() {
    for (noise, beyond, counts) in [
        (0.0, 0.125, true),
        (0.0, 0.1251, false),
        (0.1, 0.125, true),
        (0.2, 0.2, true),
        (0.2, 0.2001, false),
        (0.0, f64::INFINITY, false),
    ] {
        for value in [DELTA, 0.0, -DELTA] {
            let last = Node { noise, beyond, ..node(1.0, value) };
            let found = verdict(History::new(RootStart::Free, DELTA), &[[0.0, 1.0]], last);
            let expected = if counts { TOUCH(1.0, value) } else { Crossing::Clear };
            assert_eq!(found, expected, "{noise} {beyond} {value}");
            let rises = verdict(History::new(RootStart::Free, DELTA), &[[0.0, -DELTA]], last);
            assert_eq!(rises, Crossing::Clear, "{noise} {beyond} {value}");
        }
    }
}

/// A turn within the noise is none; of noise no more counts than half of δ.
#[test]
fn turns_within_the_noise_are_passed_over() {
    for (noise, depth, is_seen) in
        [(0.0625, 0.0625, false), (0.0625, 0.0626, true), (9.0, 0.125, false), (9.0, 0.126, true)]
    {
        let of = |theta, value| Node { noise, ..node(theta, value) };
        let mut history = History::new(RootStart::Free, DELTA);
        let mut search = RootSearch::new(RootStart::Free, DELTA);
        for [theta, value] in [[0.0, 1.0], [0.25, 0.1], [0.5, 0.1 + depth], [0.75, 0.05], [0.9, 0.05 + depth]]
        {
            history.follow(of(theta, value));
            search.follow(of(theta, value));
        }
        history.follow(of(1.0, 0.05 + depth));
        let expected = if is_seen { TOUCH(0.75, 0.05) } else { Crossing::Clear };
        assert_eq!(history.verdict(&mut |_| f64::NAN), expected, "{noise} {depth}");
        let found = matches!(search.found(), Some(SearchResult::Tangent { theta: 0.25, value: 0.1 }));
        assert_eq!(found, is_seen, "{noise} {depth}");
    }
}

/// a (θ − b)² at 1 differs from its extremum by a (1 − b)².
#[test]
fn a_parabola_goes_on_to_its_vertex() {
    for a in [3.0_f64, -3.0, 1e-20, 1e20] {
        for b in [1.25_f64, 0.75, 9.0] {
            let expected = a.abs() * (1.0 - b) * (1.0 - b);
            let found = beyond(2.0 * a * (1.0 - b), 2.0 * a);
            assert!((found / expected - 1.0).abs() < 1e-14, "{a} {b} {found}");
        }
        assert_eq!((beyond(0.0, a), beyond(a, 0.0), beyond(0.0, 0.0)), (0.0, f64::INFINITY, 0.0));
    }
}
