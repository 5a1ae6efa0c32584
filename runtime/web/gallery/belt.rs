/// A block on a moving belt, held back by a spring: it sticks, slips back, and sticks again.
#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[ground(O = (-l, 0))]
#[spring(OP, stiffness = k, length = l)]
#[support(P = floor, friction = mu, static = mu_s, moving = w)]
#[figure(P = (0, 0))]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
#[run(start = "x = 0, y = 0, x' = 0.5", limit = 12)]
struct Belt {
    #[value(1, unit = "kg")]
    m: f64,
    #[value(1, unit = "m")]
    l: f64,
    #[value(10, unit = "N/m")]
    k: f64,
    /// Friction of the block that slides.
    #[value(0.2)]
    mu: f64,
    /// Friction of the block that sticks.
    #[value(0.5)]
    mu_s: f64,
    /// Speed of the belt.
    #[value(0.5, unit = "m/s")]
    w: f64,
    #[value(9.81, unit = "m/s²")]
    g: f64,
}
