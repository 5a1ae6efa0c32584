/// A ball bounces until it rests.
#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[support(P = floor, restitution = e)]
#[figure(P = (0, 1))]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
#[run(start = "x = 0, y = 1", limit = 5)]
struct BouncingBall {
    #[value(1, unit = "kg")]
    m: f64,
    #[value(9.81, unit = "m/s²")]
    g: f64,
    #[value(0.8)]
    e: f64,
}
