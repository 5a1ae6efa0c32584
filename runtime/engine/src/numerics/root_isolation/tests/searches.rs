//! The first root of a sequence of points, at the borders of what is known of the function.

use super::super::RootStart;
use super::super::partition::Node;
use super::super::search::{RootSearch, SearchResult};
use super::histories::{DELTA, node};

fn found(mut search: RootSearch, nodes: &[Node]) -> Option<[f64; 2]> {
    nodes.iter().for_each(|node| search.follow(*node));
    match search.found()? {
        SearchResult::At(theta) | SearchResult::Tangent { theta, .. } => Some([theta; 2]),
        SearchResult::Between { ends: [a, b], smooth } => {
            assert!(smooth);
            Some([a.theta, b.theta])
        }
    }
}

fn roots(start: RootStart, points: &[[f64; 2]]) -> Option<[f64; 2]> {
    let nodes: Vec<Node> = points.iter().map(|&[theta, value]| node(theta, value)).collect();
    found(RootSearch::new(start, DELTA), &nodes)
}

#[test]
fn the_first_change_of_sign_is_found() {
    for sign in [1.0, -1.0] {
        let of = |start, points: &[[f64; 2]]| {
            roots(start, &points.iter().map(|[theta, value]| [*theta, sign * value]).collect::<Vec<_>>())
        };
        let positive = sign > 0.0;
        assert_eq!(of(RootStart::Free, &[[0.0, 1.0], [0.5, -1.0], [1.0, 1.0]]), Some([0.0, 0.5]));
        assert_eq!(of(RootStart::Free, &[[0.0, 1.0], [0.5, 0.0], [1.0, 1.0]]), Some([0.5; 2]));
        assert_eq!(of(RootStart::Free, &[[0.0, 0.0], [0.5, 1.0], [1.0, -1.0]]), Some([0.5, 1.0]));
        assert_eq!(of(RootStart::Free, &[[0.0, 0.0], [0.5, 1.0], [1.0, 1.0]]), None);
        assert_eq!(of(RootStart::Free, &[[0.0, 1.0], [1.0, 0.0]]), Some([1.0; 2]));
        // The sign that the step before ended with.
        assert_eq!(
            of(RootStart::Continues { positive: !positive }, &[[0.0, 1.0], [1.0, 2.0]]),
            Some([0.0; 2])
        );
        assert_eq!(of(RootStart::Continues { positive }, &[[0.0, 1.0], [1.0, 2.0]]), None);
        assert_eq!(of(RootStart::Continues { positive }, &[[0.0, 0.0], [1.0, -2.0]]), None);
    }
}

/// Up to its bound the function is at the known root, whose sign is not known; with the root
/// divided out it has one.
#[test]
fn signs_behind_a_known_root_count_beyond_the_bound() {
    for sign in [1.0, -1.0] {
        for (top, seen) in [(DELTA, false), (DELTA.next_up(), true)] {
            for start in [RootStart::Root, RootStart::Order(2)] {
                let points = [[0.0, 0.0], [0.5, sign * top], [1.0, -sign]];
                let expected = seen.then_some([0.5, 1.0]);
                assert_eq!(roots(start, &points), expected, "{start:?} {top}");
                let nodes = points.map(|[theta, value]| node(theta, value));
                let series = found(RootSearch::of_series(start, DELTA), &nodes);
                let divided = matches!(start, RootStart::Order(_));
                assert_eq!(series, (seen || divided).then_some([0.5, 1.0]), "{start:?} {top}");
            }
        }
    }
}

/// An extremum on the way to zero counts within δ, one that turns away from zero does not.
#[test]
fn an_extremum_within_the_bound_is_a_root() {
    for sign in [1.0, -1.0] {
        let of = |points: &[f64]| {
            let points = points.iter().enumerate();
            roots(RootStart::Free, &points.map(|(k, x)| [0.25 * k as f64, sign * x]).collect::<Vec<_>>())
        };
        assert_eq!(of(&[1.0, DELTA, 1.0]), Some([0.25; 2]));
        assert_eq!(of(&[1.0, DELTA.next_up(), 1.0]), None);
        assert_eq!(of(&[0.1, 0.2, 0.15, 0.2]), Some([0.5; 2]));
        assert_eq!(of(&[0.1, 0.2, 0.1]), None);
    }
}

/// At the end a value within the noise is zero, and so is an extremum beyond which there is less
/// than the noise, or half of δ.
#[test]
fn a_root_at_the_end_is_seen_to_the_noise() {
    for sign in [1.0, -1.0] {
        let of = |last: [f64; 2], noise: f64, beyond: f64| {
            let end = Node { noise, beyond, ..node(1.0, sign * last[1]) };
            found(RootSearch::new(RootStart::Free, DELTA), &[node(0.0, sign * last[0]), end])
        };
        let at_end = Some([1.0; 2]);
        assert_eq!(of([1.0, 0.125], 0.125, f64::INFINITY), at_end);
        assert_eq!(of([1.0, 0.125], 0.1249, f64::INFINITY), None);
        assert_eq!(of([1.0, DELTA], 9.0, f64::INFINITY), at_end);
        assert_eq!(of([1.0, 0.26], 9.0, f64::INFINITY), None);
        for (noise, beyond, counts) in
            [(0.0, 0.125, true), (0.0, 0.1251, false), (0.2, 0.2, true), (0.2, 0.2001, false)]
        {
            assert_eq!(of([1.0, DELTA], noise, beyond), at_end.filter(|_| counts), "{noise} {beyond}");
            assert_eq!(of([0.22, DELTA], noise, beyond), None, "it leaves zero");
        }
        // What began at zero has no side.
        assert_eq!(of([0.0, 0.0], 0.1, 0.0), None);
    }
}
