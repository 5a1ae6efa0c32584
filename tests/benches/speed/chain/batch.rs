use generated_BARS::Chain;
use liftoff_core::model::BarSystem;
use liftoff_core::scalar::Real;
use liftoff_core::batch::{Batch, Side};
use std::hint::black_box;
use std::time::Instant;

const STATES: usize = 512;

type State = <Chain as BarSystem>::State<f64>;
type Accelerations = <Chain as BarSystem>::Accelerations<Side>;

fn main() {
    let batch = Batch::new(&Chain { m: 1.0, l: 1.0, g: 9.81 }, &[]).expect("a chain has a closed form");
    let value = |i: usize, j: usize| 3.0 * (((1 + i * 2 * BARS + j) as f64 * 0.618_033_988_749_895).fract() - 0.5);
    let states: Vec<State> = (0..STATES).map(|i| core::array::from_fn(|j| value(i, j))).collect();
    let packed = Batch::<Chain>::pack(&states);
    let mut accelerations: Vec<Accelerations> = vec![[Side::from_f64(0.0); BARS]; packed.len()];
    let mut least = f64::INFINITY;
    for _ in 0..1000 {
        let start = Instant::now();
        batch.reduced_accelerations(black_box(&packed), &mut accelerations);
        black_box(&accelerations);
        least = least.min(start.elapsed().as_secs_f64() * 1e9 / STATES as f64);
    }
    println!("{least}");
}
