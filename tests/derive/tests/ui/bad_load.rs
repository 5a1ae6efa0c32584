use liftoff::BarSystem;

#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[pin(A = (0, 0))]
#[coordinate(phi = angle(AB), from = down)]
#[force(B = (c * vx(C), sinh(t)))]
#[couple(AB = c * rate(phj))]
#[drive(phi = c * y(B))]
struct Pendulum {
    m: f64,
    l: f64,
    g: f64,
    c: f64,
}

fn main() {}
