//! Threads and supports at rest, and what happens when one is taken away.

use super::{CLOSE, evaluate_output, pose};
use crate::common::{kinds, prepared};
use approx::assert_abs_diff_eq;
use liftoff::LoggedDecision;
use liftoff::prelude::*;
use liftoff_compiled::*;
use liftoff_tests::catalogue::{vanishing_support, zigzag_thread};

#[test]
fn the_thread_of_fig_1b_bears_the_bars_until_it_is_cut() {
    let (l, g) = (1.0, 9.81);
    for (m1, m2, phi) in [(0.5, 0.5, 1.2_f64), (0.75, 0.25, 0.9), (0.2, 0.8, 0.5)] {
        let model = ZigzagThread { m1, m2, l, s: 2.0 * l * phi.cos(), g };
        let start = pose(&[("phi_inner", phi), ("phi_outer", phi)]);
        let run = prepared(&model, start, &[]).cut("BD", "t = 0.5").unwrap().run().unwrap();
        assert_eq!(kinds(&run)[..2], [(EventKind::Start, vec![]), (EventKind::Cut, vec!["BD"])]);
        let [outer, inner] = zigzag_thread::reactions(m1, m2, g);
        for t in [0.0, 0.3] {
            assert_abs_diff_eq!(
                evaluate_output(&run, "N(BD)", t),
                zigzag_thread::tension(m1, m2, g, phi),
                epsilon = CLOSE
            );
            assert_abs_diff_eq!(evaluate_output(&run, "N(A)", t), outer, epsilon = CLOSE);
            assert_abs_diff_eq!(evaluate_output(&run, "N(C)", t), inner, epsilon = CLOSE);
            assert_abs_diff_eq!(evaluate_output(&run, "phi_inner", t), phi, epsilon = CLOSE);
        }
        let [last, other] = [run.events().last().unwrap().kind, run.events()[2].kind];
        assert_eq!((other, last), (EventKind::Open, EventKind::Close));
    }
}

/// Cut at once, the bars fall as those of `zigzag` started at rest.
#[test]
fn once_cut_the_bars_fall_freely() {
    let (m1, m2, l, g, phi) = (0.5, 0.5, 1.0, 9.81, 1.3_f64);
    let start = pose(&[("phi_inner", phi), ("phi_outer", phi)]);
    let thread = ZigzagThread { m1, m2, l, s: 2.0 * l * phi.cos(), g };
    let cut = prepared(&thread, start.clone(), &[]).cut("BD", "t = 0.25").unwrap().run().unwrap();
    let free = prepared(&Zigzag { m1, m2, l, g }, start, &[]).run().unwrap();
    assert_eq!(cut.events()[2..].len(), free.events()[1..].len());
    for (a, b) in cut.events()[2..].iter().zip(&free.events()[1..]) {
        assert_eq!((a.kind, &a.supports), (b.kind, &b.supports));
        assert_abs_diff_eq!(a.t - 0.25, b.t, epsilon = CLOSE);
        assert_abs_diff_eq!(a.state[..], b.state[..], epsilon = CLOSE);
    }
}

/// A level bar on two points; one vanishes.
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[point(P = AB, at = l / 2 - d)]
#[point(Q = AB, at = l / 2 + d)]
#[support(P = floor)]
#[support(Q = floor)]
#[figure(A = (-l / 2, 0), B = (l / 2, 0))]
struct Shelf {
    m: f64,
    l: f64,
    d: f64,
    g: f64,
}

#[test]
fn a_support_vanishes() {
    for d in [0.5, 0.3, 0.1] {
        let model = Shelf { m: 1.0, l: 1.0, d, g: 1.0 };
        let start = Pose::new("theta_AB", 0.0);
        let run = prepared(&model, start, &["t = 0.6"]).release("Q", 0.5).unwrap().run().unwrap();
        let release = &run.events()[1];
        assert_eq!((release.kind, &release.supports[..], release.t), (EventKind::Release, &["Q"][..], 0.5));
        assert_abs_diff_eq!(evaluate_output(&run, "N(P)", 0.25), 0.5, epsilon = 1e-14);
        assert_abs_diff_eq!(
            evaluate_output(&run, "N(P)", 0.5),
            vanishing_support::reaction(d, 1.0),
            epsilon = 1e-14
        );
    }
}

/// Three reactions, two equations: their sum, their balance and the rest are determined.
#[test]
fn three_supports_bear_a_rod_in_many_ways() {
    let model = RodOnThree { m: 2.0, l: 1.0, g: 9.81 };
    let start = Pose::new("phi", 0.0);
    let run = prepared(&model, start, &["t = 1"]).release("A", 0.5).unwrap().run().unwrap();
    assert!(
        run.log().iter().any(|entry| entry.decision == LoggedDecision::ReactionsNotUnique),
        "{:?}",
        run.log()
    );
    let reactions = |t| ["N(A)", "N(C)", "N(B)"].map(|output| evaluate_output(&run, output, t));
    let [a, c, b] = reactions(0.25);
    assert!(a >= 0.0 && b >= 0.0 && c >= 0.0);
    assert_abs_diff_eq!(a + b + c, 2.0 * 9.81, epsilon = 1e-13);
    assert_abs_diff_eq!(a, b, epsilon = 1e-13);
    // without A the rod is balanced on C
    for (found, expected) in reactions(0.75).iter().zip([0.0, 2.0 * 9.81, 0.0]) {
        assert_abs_diff_eq!(*found, expected, epsilon = 1e-13);
    }
    for output in ["phi", "y", "phi''", "ay(C)"] {
        assert_eq!(evaluate_output(&run, output, 1.0), 0.0, "{output}");
    }
}
