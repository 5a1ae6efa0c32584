use liftoff::BarSystem;

#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = 5)]
#[pin(A = (0, 0))]
#[figure(B = (3, 4))]
#[support(ball = circle((0, 0), 6), under = B, restitution = 1.5)]
#[ground(O = (0, 1))]
#[thread(OB, length = 4)]
#[spring(spring = O -> B, stiffness = -2)]
#[section(S = AB, at = 6)]
struct Rod {
    m: f64,
    g: f64,
}

fn main() {}
