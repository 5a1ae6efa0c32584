//! Loops that no figure closes: two points are farther apart than the bars between them reach.

use super::{NEAR, Sample, Structure};

/// Among more points loops are not looked for.
const MOST: usize = 100;

/// Two points of a bar, or two pins, and a shorter way from one to the other.
pub(super) struct OpenLoop {
    /// The points on the way, from end to end.
    pub way: Vec<usize>,
    /// The distance of the ends.
    pub distance: f64,
    /// The length of the way.
    pub reach: f64,
}

/// The loop that lacks most; none where all may be closed.
pub(super) fn find_open_loop(structure: &Structure, sample: &Sample) -> Option<OpenLoop> {
    let n = structure.points.len();
    if n > MOST {
        return None;
    }
    let pair = |place| sample.numbers.pair(place);
    let pins = structure.pins.iter().map(|pin| (pin.point, pair(&pin.at))).collect();
    let bodies = (0..structure.bodies.len())
        .map(|body| structure.members(body).iter().map(|(point, local)| (*point, pair(local))).collect());
    let mut held = vec![f64::INFINITY; n * n];
    for rigid in bodies.chain([pins]) {
        let rigid: Vec<(usize, [f64; 2])> = rigid;
        for (a, [x, y]) in &rigid {
            rigid.iter().for_each(|(b, to)| held[a * n + b] = (to[0] - x).hypot(to[1] - y));
        }
    }
    let (mut reach, mut via) = (held.clone(), vec![None; n * n]);
    // Floyd's and Warshall's shortest ways.
    for k in 0..n {
        for (a, b) in (0..n * n).map(|i| (i / n, i % n)) {
            let round = reach[a * n + k] + reach[k * n + b];
            if round < reach[a * n + b] * (1.0 - NEAR) {
                (reach[a * n + b], via[a * n + b]) = (round, Some(k));
            }
        }
    }
    let lacks = |i: &usize| i / n < i % n && held[*i].is_finite() && via[*i].is_some();
    let worst =
        (0..n * n).filter(lacks).max_by(|&i, &j| (held[i] - reach[i]).total_cmp(&(held[j] - reach[j])))?;
    let mut way = vec![worst / n, worst % n];
    while let Some(i) = (1..way.len()).find(|&i| via[way[i - 1] * n + way[i]].is_some()) {
        way.insert(i, via[way[i - 1] * n + way[i]]?);
    }
    Some(OpenLoop { way, distance: held[worst], reach: reach[worst] })
}
