use std::hint::black_box;
use std::time::Instant;

type State = ([f64; N], [f64; N]);
type Rhs = Box<dyn FnMut(&[State]) -> [f64; N]>;

/// Evaluates it at every state; gives the accelerations at the last.
macro_rules! prepared {
    ($name:ident) => {{
        let rhs = $name::Rhs::prepare(black_box(9.81));
        Box::new(move |states: &[State]| {
            let mut a = [0.0; N];
            for (q, u) in states {
                rhs.rhs(q, u, &mut a);
                black_box(&a);
            }
            a
        }) as Rhs
    }};
}

fn states() -> Vec<State> {
    let value = |i: usize, j: usize| ((1 + i * 2 * N + j) as f64 * 0.618_033_988_749_895).fract() - 0.5;
    let state = |i: usize| {
        (core::array::from_fn(|j| 6.0 * value(i, j)), core::array::from_fn(|j| 4.0 * value(i, N + j)))
    };
    (0..64).map(state).collect()
}

fn main() {
    let states = states();
    let mut variants: Vec<Rhs> = vec![VARIANTS];
    let results: Vec<[f64; N]> = variants.iter_mut().map(|rhs| rhs(&states)).collect();
    for result in &results {
        let size = results[0].iter().fold(0.0f64, |size, x| size.max(x.abs()));
        let bound = 100.0 * (N * N) as f64 * f64::EPSILON * size;
        for (k, (x, y)) in result.iter().zip(&results[0]).enumerate() {
            assert!((x - y).abs() <= bound, "bar {k}: {x} and {y}");
        }
    }
    let passes = 1 + 400 / N / N.ilog2().max(1) as usize;
    let mut least = vec![f64::INFINITY; variants.len()];
    for _ in 0..300 {
        for (rhs, least) in variants.iter_mut().zip(&mut least) {
            let start = Instant::now();
            for _ in 0..passes {
                black_box(rhs(black_box(&states)));
            }
            *least = least.min(start.elapsed().as_secs_f64() * 1e9 / (passes * states.len()) as f64);
        }
    }
    least.iter().for_each(|time| println!("{time}"));
}
