use liftoff_core::BarSystem as System;
use liftoff_derive::BarSystem;

#[derive(BarSystem)]
#[liftoff(crate = liftoff_core)]
#[bar(AB, mass = m, length = l)]
enum Rod {}

#[derive(BarSystem)]
#[liftoff(crate = liftoff_core)]
#[bar(AB, mass = m, length = l)]
struct Pair(f64, f64);

fn needs<M: System>() {}

fn main() {
    needs::<Rod>();
    needs::<Pair>();
}
