//! Poses of four-bars given by the crank alone, against intersections of circles: round full turns,
//! near change points, and past what the bars reach.

use core::f64::consts::{FRAC_PI_2, TAU};

use liftoff::method::MethodId;
use liftoff::prelude::*;

#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[bar(OA, mass = m, length = a)]
#[bar(AB, mass = m, length = b)]
#[bar(QB, mass = m, length = c)]
#[pin(O = (0, 0))]
#[pin(Q = (d, 0))]
#[figure(
    A = (0, a),
    B = (
        (b * b - c * c + a * a + d * d) * d / (2 * (a * a + d * d))
            + sqrt(4 * b * b * (a * a + d * d) - (b * b - c * c + a * a + d * d).powi(2)) * a / (2 * (a * a + d * d)),
        a - (b * b - c * c + a * a + d * d) * a / (2 * (a * a + d * d))
            + sqrt(4 * b * b * (a * a + d * d) - (b * b - c * c + a * a + d * d).powi(2)) * d / (2 * (a * a + d * d))
    )
)]
#[coordinate(phi = angle(OA))]
#[coordinate(psi = angle(QB))]
#[coordinate(chi = angle(AB))]
struct FourBar {
    m: f64,
    a: f64,
    b: f64,
    c: f64,
    d: f64,
    g: f64,
}

fn four_bar([a, b, c, d]: [f64; 4]) -> FourBar {
    FourBar { m: 1.0, a, b, c, d, g: 9.81 }
}

/// The angles of rocker and coupler, the coupler's end to the left of the diagonal; none where the
/// circles do not meet.
fn angles(of: &FourBar, phi: f64) -> Option<[f64; 2]> {
    let [ax, ay] = [of.a * phi.cos(), of.a * phi.sin()];
    let diagonal = (of.d - ax).hypot(ay);
    let along = (of.b * of.b - of.c * of.c + diagonal * diagonal) / (2.0 * diagonal);
    let square = of.b * of.b - along * along;
    let beside = (square >= 0.0).then(|| square.sqrt())?;
    let [x, y] = [(of.d - ax) / diagonal, -ay / diagonal];
    let [bx, by] = [ax + along * x - beside * y, ay + along * y + beside * x];
    Some([by.atan2(bx - of.d), (by - ay).atan2(bx - ax)])
}

/// The same, turns counted, on a way of the crank from upright; none where it is blocked.
fn followed(of: &FourBar, phi: f64) -> Option<[f64; 2]> {
    let steps = ((phi - FRAC_PI_2).abs() / 1e-3).ceil().max(1.0) as usize;
    let mut found = angles(of, FRAC_PI_2)?;
    for step in 1..=steps {
        let next = angles(of, FRAC_PI_2 + (phi - FRAC_PI_2) * step as f64 / steps as f64)?;
        for (found, next) in found.iter_mut().zip(next) {
            *found += next - *found - TAU * ((next - *found) / TAU).round();
        }
    }
    Some(found)
}

fn start(of: &FourBar, pose: Pose) -> Result<Vec<f64>, String> {
    let simulation = Simulation::new(of).unwrap().start(pose);
    let run = simulation.map_err(|error| error.to_string())?.limit(1e-9).run();
    let run = run.map_err(|error| error.to_string())?;
    Ok(run.events()[0].state[..3].to_vec())
}

/// Cranks that go round, also past positions where the bars are nearly in one line: there a step of
/// the crank by 11° would come onto the other branch.
#[test]
fn a_crank_takes_its_rocker_round_without_a_jump() {
    for beside in [0.3, 0.1, 0.05, 0.02, 0.01, 1e-3, 1e-4, 1e-5] {
        for lengths in
            [[1.0, 2.0, 1.0 + beside, 2.0], [1.0, 3.0, 2.0, 2.0 + beside], [1.0, 2.5, 1.5 + beside, 3.0]]
        {
            let of = four_bar(lengths);
            for k in 0..60 {
                let phi = -12.3 + 0.41 * f64::from(k);
                let [psi, chi] = followed(&of, phi).unwrap();
                let found = start(&of, Pose::new("phi", phi)).unwrap();
                assert!((found[1] - psi).abs() < 1e-8, "{of:?} {phi}: {} for {psi}", found[1]);
                assert!((found[2] - chi).abs() < 1e-8, "{of:?} {phi}: {} for {chi}", found[2]);
            }
        }
    }
}

/// A crank that does not go round stands where its bars reach, and on the branch of the figure;
/// elsewhere it is refused.
#[test]
fn a_crank_that_does_not_go_round_stands_where_its_bars_reach() {
    for lengths in [[1.0, 2.1, 1.0, 1.95], [1.0, 2.0, 1.0, 2.1], [2.0, 1.0, 2.5, 3.2], [2.5, 3.0, 1.0, 3.2]] {
        let of = four_bar(lengths);
        if angles(&of, FRAC_PI_2).is_none() {
            continue;
        }
        let mut met = [0; 2];
        for k in 0..60 {
            let phi = -12.3 + 0.41 * f64::from(k);
            // On one of the two ways round, if on any.
            let near = phi - TAU * ((phi - FRAC_PI_2) / TAU).round();
            let ways = [near, near - TAU.copysign(near - FRAC_PI_2)];
            let reached: Vec<_> = ways.iter().filter_map(|&phi| followed(&of, phi)).collect();
            met[usize::from(reached.is_empty())] += 1;
            match start(&of, Pose::new("phi", phi)) {
                Ok(found) => assert!(
                    reached.iter().any(|way| way.iter().zip(&found[1..]).all(|(a, b)| (a - b).abs() < 1e-8)),
                    "{of:?} {phi}: {found:?} for {reached:?}"
                ),
                Err(error) => assert!(reached.is_empty(), "{of:?} {phi}: {error}"),
            }
        }
        assert!(met[0] > 0 && met[1] > 0, "{of:?} {met:?}");
    }
}

/// The rocker of a figure that is 0.01 rad of its crank away from the rocker's dead centre, from
/// beside that to beside the other.
#[test]
fn a_rocker_leaves_its_dead_centre_behind() {
    let of = four_bar([0.975595010710919, 1.7136266537842157, 2.8724470378755127, 1.0404557080921482]);
    let mut last = 1.55;
    for k in 0..40 {
        let psi = 1.94 + 0.061 * f64::from(k);
        let [phi, _, chi] = start(&of, Pose::new("psi", psi)).unwrap()[..] else {
            panic!("three coordinates")
        };
        let x = of.a * phi.cos() + of.b * chi.cos() - of.d - of.c * psi.cos();
        let y = of.a * phi.sin() + of.b * chi.sin() - of.c * psi.sin();
        assert!(x.hypot(y) < 1e-9, "{psi} {phi} {chi}");
        assert!((phi - last).abs() < 0.5, "{psi} {phi} {last}");
        last = phi;
    }
}

/// Flat, with rates that neither the parallelogram nor the other branch has: what has to jump is
/// named.
#[test]
fn rates_of_no_branch_are_refused_by_the_names_of_the_joints() {
    let flat = Pose::new("phi", 0.0).with("psi", 0.0).with("chi", 0.0);
    let simulation = Simulation::new(&four_bar([1.0, 2.0, 1.0, 2.0])).unwrap();
    let simulation = simulation.start(flat.with("phi'", 5.0).with("psi'", -2.0)).unwrap().limit(0.1);
    let error = simulation.run().unwrap_err().cause().to_string();
    assert!(error.contains("pin Q (x), pin Q (y)"), "{error}");
}

/// A crank that is longer than its rocker by ε, the coupler as long as the ground: flat it does not
/// close, so that it turns back before, however small ε is.
#[test]
fn a_crank_just_longer_than_its_rocker_does_not_pass_its_flat_position() {
    let end = |longer: f64| {
        let of = FourBar { g: 1.0, ..four_bar([1.0 + longer, 2.0, 1.0, 2.0]) };
        let start = Pose::new("phi", 1.0).with("phi'", -1.0);
        let run = Simulation::new(&of).unwrap().start(start).unwrap().limit(4.0).run().unwrap();
        let phi = run.value(&Output::parse(run.layout(), "phi").unwrap(), 4.0);
        assert!(phi > 0.0 && phi < core::f64::consts::PI, "{longer:e}: {phi}");
        phi
    };
    // Seen there without a singular position near.
    let right = end(1e-5);
    for longer in [1e-12, 1e-11, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6] {
        let phi = end(longer);
        assert!((phi - right).abs() < 5e-3, "{longer:e}: {phi} for {right}");
    }
}

/// Where it turns back its angles change in a time of √ε or so: the step of Gauss's method there
/// would serve to the end of the run.
#[test]
fn a_constant_step_past_a_flat_position_is_refused() {
    for longer in [1e-13, 1e-12, 1e-11] {
        let of = FourBar { g: 1.0, ..four_bar([1.0 + longer, 2.0, 1.0, 2.0]) };
        let simulation = Simulation::new(&of).unwrap().method(MethodId::Gauss);
        let start = Pose::new("phi", 1.0).with("phi'", -1.0);
        let error = simulation.start(start).unwrap().limit(4.0).run().unwrap_err().to_string();
        assert!(error.contains("auto, radau and dop853"), "{longer:e}: {error}");
    }
}
