/// A bar falls on the floor, bounces on either end, and comes to rest.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[support(A = floor, restitution = e)]
#[support(B = floor, restitution = e)]
#[figure(A = (-l / 2, 1), B = (l / 2, 1))]
#[coordinate(phi = angle(AB))]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
#[run(start = "phi = 0.5, x = 0, y = 1", limit = 2)]
struct BouncingBar {
    #[value(1, unit = "kg")]
    m: f64,
    #[value(1, unit = "m")]
    l: f64,
    #[value(0.5)]
    e: f64,
    #[value(9.81, unit = "m/s²")]
    g: f64,
}
