//! Housner's block on rough corners, plastic impacts: ω⁺/ω⁻ = 1 − (3/2) sin² α, tan α = b/h
//! (catalogue 8).

use liftoff::prelude::*;
use liftoff_fixtures::Block;

fn rock(alpha: f64, tilt: f64, tolerance: f64) -> Trajectory {
    let block = Block { m: 1.0, b: alpha.sin(), h: alpha.cos(), g: 1.0 };
    // Tilted about A, which stays at (−b, 0).
    let (s, c) = tilt.sin_cos();
    let pose = Pose::new("theta", tilt)
        .with("x", -block.b + c * block.b - s * block.h)
        .with("y", s * block.b + c * block.h);
    Simulation::new(&block).unwrap().tolerance(tolerance).start(pose).unwrap().limit(60.0).run().unwrap()
}

#[test]
fn a_block_rocks_and_comes_to_rest() {
    let alpha = 20f64.to_radians();
    let run = rock(alpha, 0.1, 1e-12);
    let impacts: Vec<_> = run.events().iter().filter(|e| e.kind == EventKind::Impact).collect();
    let ratio = 1.0 - 1.5 * alpha.sin().powi(2);
    let mut before: Option<f64> = None;
    for (k, impact) in impacts.iter().enumerate() {
        assert_eq!(impact.supports, [["B"], ["A"]][k % 2], "{impact}");
        let spin = impact.state[3].abs();
        if let Some(before) = before {
            // Energy is kept between impacts, so the rate before one is that after the last; of the
            // height, some spin²/g, the rounding of a gap is lost.
            let rounding = 1e-10 + 4.0 * f64::EPSILON / (spin * spin);
            assert!((spin / before / ratio - 1.0).abs() < rounding, "{k} {impact}");
        }
        before = Some(spin);
    }
    let value = |text: &str, t: f64| run.value(&Output::parse(Block::LAYOUT, text).unwrap(), t);
    let first = impacts[0];
    let fall = value("E", 0.0) - alpha.cos();
    // (I + m r²) ω²/2 with r = 1: 2/3 ω².
    assert!((first.state[3].abs() / (1.5 * fall).sqrt() / ratio - 1.0).abs() < 1e-11, "{first}");
    let settle = run.events().iter().find(|e| e.kind == EventKind::Settle).unwrap();
    assert!([0, 3, 4, 5].iter().all(|&i| run.final_state()[i].abs() < 1e-14), "{:?}", run.final_state());
    assert!((value("N(A)", 60.0) - 0.5).abs() < 1e-12 && (value("N(B)", 60.0) - 0.5).abs() < 1e-12);
    let coarse = rock(alpha, 0.1, 1e-10);
    let again = coarse.events().iter().find(|e| e.kind == EventKind::Settle).unwrap();
    println!("{} {} {:e}", impacts.len(), settle.t, settle.t - again.t);
    assert!((settle.t - again.t).abs() < 1e-8);
}

/// A squat block, sin² α > ⅔, stays flat after its first impact.
#[test]
fn a_squat_block_falls_flat() {
    let run = rock(60f64.to_radians(), 0.1, 1e-12);
    let kinds: Vec<_> = run.events().iter().map(|e| e.kind).collect();
    assert_eq!(kinds, [EventKind::Start, EventKind::Impact, EventKind::End]);
    assert!(run.final_state()[3..].iter().all(|u| u.abs() < 1e-15));
}

/// Catalogue 3: a rod toppling about a rough point from rest upright: N = (mg/4)(1 − 3 cos θ)²
/// touches zero at cos θ = ⅓, where the point still drags it by F = ¾ m g sin θ (3 cos θ − 2), and
/// does not lift.
#[test]
fn a_toppling_rod_keeps_its_rough_point() {
    let rod = Block { m: 1.0, b: 0.0, h: 0.5, g: 1.0 };
    let (tilt, spin) = (0.5f64, (3.0 * (1.0 - 0.5f64.cos())).sqrt());
    let (s, c) = tilt.sin_cos();
    let pose = [("theta", tilt), ("x", -0.5 * s), ("y", 0.5 * c), ("theta'", spin)];
    let pose = pose.iter().fold(Pose::nominal(), |pose, (name, value)| pose.with(name, *value));
    let run = Simulation::new(&rod).unwrap().tolerance(1e-13).start(pose).unwrap();
    let run = run.release("B", 0.0).unwrap().until("theta = 1.4").unwrap().run().unwrap();
    let kinds: Vec<_> = run.events().iter().map(|e| e.kind).collect();
    assert_eq!(kinds, [EventKind::Start, EventKind::Release, EventKind::Touch, EventKind::Stop]);
    let touch = &run.events()[2];
    assert!((touch.state[0].cos() - 1.0 / 3.0).abs() < 1e-5, "{touch}");
    let normal = Output::parse(Block::LAYOUT, "N(A)").unwrap();
    let expected = 0.25 * (1.0 - 3.0 * 1.4f64.cos()).powi(2);
    assert!((run.value(&normal, run.end_time()) - expected).abs() < 1e-11);
    let foot = Output::parse(Block::LAYOUT, "x(A)").unwrap();
    assert!(run.value(&foot, run.end_time()).abs() < 1e-14);
}
