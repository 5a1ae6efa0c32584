//! What a passage through zero is told by.

use super::*;

/// Across 10⁻⁹ a slope of m and a jump J: farther away the values differ by J + 2 · 10⁻³ m, of
/// which the jump is at most half where the function passes through zero.
#[test]
fn a_jump_is_reported_from_a_steep_passage() {
    let width = 1e-9;
    for sign in [1.0, -1.0] {
        for unit in [1e-12, 1.0, 1e12] {
            for (jump, is_continuous_there) in [(1.999e-3, true), (2.001e-3, false)] {
                let side = |theta: f64| if theta < 0.5 { -0.5 } else { 0.5 };
                let g = |theta: f64| sign * unit * (theta - 0.5 + jump * side(theta));
                let ends =
                    [0.5 - 0.5 * width, 0.5 + 0.5 * width].map(|theta| Point { theta, value: g(theta) });
                let [a, b] = ends;
                for ends in [[a, b], [b, a]] {
                    let told = is_continuous(&mut |theta| g(theta), ends, 0.0);
                    assert_eq!(told, is_continuous_there, "{sign} {unit} {jump}");
                    // Within the rounding, or at zero itself, nothing has to be compared.
                    let apart = (a.value - b.value).abs();
                    assert!(is_continuous(&mut |_| f64::NAN, ends, apart));
                    assert!(!is_continuous(&mut |_| 0.0, ends, 0.999 * apart));
                    let at_zero = [Point { value: 0.0, ..ends[0] }, ends[1]];
                    assert!(is_continuous(&mut |_| f64::NAN, at_zero, 0.0));
                    assert!(!is_continuous(&mut |_| 0.0, [ends[0], Point { value: 0.0, ..ends[1] }], 0.0));
                }
            }
        }
    }
}

/// No place outside of the step is asked for.
#[test]
fn values_are_compared_within_the_step() {
    for theta in [0.0, 1.0] {
        let ends = [theta, 0.5].map(|theta| Point { theta, value: theta - 0.75 });
        let mut asked = Vec::new();
        let mut value = |theta: f64| {
            asked.push(theta);
            theta
        };
        is_continuous(&mut value, ends, 0.0);
        assert_eq!(asked, [0.0, 1.0]);
    }
}

/// At the end an extremum counts where no more than the noise, or than what is to stand out, is
/// left to it.
#[test]
fn an_extremum_at_the_end_is_reported_to_the_noise() {
    for (noise, delta, left, is_told) in [
        (0.0, 0.25, 0.25, true),
        (0.0, 0.25, 0.251, false),
        (0.25, 0.0, 0.25, true),
        (0.25, 0.0, 0.251, false),
        (0.25, 0.125, 0.25, true),
    ] {
        let (mut zigzag, mut told) = (Zigzag::default(), Vec::new());
        for (theta, value, beyond) in [(0.0, 1.0, f64::INFINITY), (1.0, 0.0, left)] {
            let node = Node { point: Point { theta, value }, noise, beyond, smooth: true };
            turn(&mut zigzag, node, delta, &mut |extremum| told.push(extremum.theta));
        }
        assert_eq!(told, if is_told { vec![1.0] } else { vec![] }, "{noise} {delta} {left}");
    }
}
