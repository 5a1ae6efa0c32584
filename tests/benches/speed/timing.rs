//! Minima of many short repeats.

use std::time::Instant;

/// Repeats of which the least counts.
const REPEATS: usize = 200;

/// A repeat lasts about so many seconds.
const REPEAT: f64 = 2e-5;

/// Nanoseconds that one call of each takes; they take turns.
pub fn nanoseconds<const K: usize>(mut calls: [&mut dyn FnMut(); K]) -> [f64; K] {
    let counts = calls.each_mut().map(|call| count(*call));
    let mut least = [f64::INFINITY; K];
    for _ in 0..REPEATS {
        for ((call, count), least) in calls.iter_mut().zip(counts).zip(&mut least) {
            *least = least.min(seconds(*call, count) / count as f64);
        }
    }
    least.map(|seconds| seconds * 1e9)
}

fn count(call: &mut dyn FnMut()) -> usize {
    let mut count = 1;
    while seconds(call, count) < REPEAT {
        count *= 2;
    }
    count
}

fn seconds(call: &mut dyn FnMut(), count: usize) -> f64 {
    let start = Instant::now();
    (0..count).for_each(|_| call());
    start.elapsed().as_secs_f64()
}
