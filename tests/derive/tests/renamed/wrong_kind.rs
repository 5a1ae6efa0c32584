use liftoff_core::model::names::{ContactName, CoordinateName, PointName, ThreadName};
use liftoff_derive::BarSystem;

#[derive(BarSystem)]
#[liftoff(crate = liftoff_core)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[support(A = floor)]
#[figure(A = (0, 0), B = (0, l))]
#[coordinate(phi = angle(AB))]
struct Rod {
    m: f64,
    l: f64,
    g: f64,
}

fn set(_: impl CoordinateName, _: f64) {}
fn hold(_: impl ContactName) {}
fn cut(_: impl ThreadName) {}
fn impulse(_: impl PointName) {}

fn main() {
    set(Rod::A, 1.0);
    hold(Rod::B);
    cut(Rod::A);
    impulse(Rod::PHI);
}
