//! Jansen's leg by intersections of circles: lengths as published, the crank about the origin.

type Place = [f64; 2];

/// The names of the moving points, in the order of [`places`].
pub const NAMES: [&str; 6] = ["A", "B", "C", "D", "E", "F"];
const PIVOT: Place = [-38.0, -7.8];

const CRANK: f64 = 15.0;

/// The place at these distances from two others, to the left of the way from the first to the
/// second.
fn left(p: Place, from_p: f64, q: Place, from_q: f64) -> Place {
    let step = [q[0] - p[0], q[1] - p[1]];
    let d = step[0].hypot(step[1]);
    let along = (d * d + from_p * from_p - from_q * from_q) / (2.0 * d);
    let across = (from_p * from_p - along * along).sqrt();
    let unit = step.map(|x| x / d);
    [p[0] + along * unit[0] - across * unit[1], p[1] + along * unit[1] + across * unit[0]]
}

/// Where the points are while the crank is at an angle.
pub fn places(phi: f64) -> [Place; 6] {
    let a = [CRANK * phi.cos(), CRANK * phi.sin()];
    let b = left(PIVOT, 41.5, a, 50.0);
    let d = left(a, 61.9, PIVOT, 39.3);
    let c = left(PIVOT, 40.1, b, 55.8);
    let e = left(d, 36.7, c, 39.4);
    let f = left(d, 49.0, e, 65.7);
    [a, b, c, d, e, f]
}

/// The weight's work over gravity and mass of a unit of length: Σ length × height of the middle.
pub fn lift(phi: f64) -> f64 {
    let [a, b, c, d, e, f] = places(phi).map(|place| place[1]);
    let bars = [(15.0, 0.0, a), (50.0, a, b), (61.9, a, d), (39.3, PIVOT[1], d), (39.4, c, e)];
    let plates = [(137.4, PIVOT[1] + b + c), (151.4, d + e + f)];
    bars.iter().map(|(length, from, to)| length * 0.5 * (from + to)).sum::<f64>()
        + plates.iter().map(|(mass, sum)| mass * sum / 3.0).sum::<f64>()
}
