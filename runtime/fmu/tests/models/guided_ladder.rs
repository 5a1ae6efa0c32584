/// A ladder between two guides with friction, through its lowest position and back.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[slider(A = horizontal(0), friction = mu)]
#[slider(B = vertical(0), friction = nu / (1 + v * v), static = nu_s)]
#[coordinate(theta = angle(AB), from = right)]
#[figure(A = (-3 * l / 5, 0), B = (0, 4 * l / 5))]
#[run(start = "theta = 0.9, theta' = 0", limit = 6)]
struct GuidedLadder {
    #[value = 1.2]
    m: f64,
    #[value = 0.8]
    l: f64,
    #[value = 9.81]
    g: f64,
    #[value = 0.1]
    mu: f64,
    #[value = 0.15]
    nu: f64,
    #[value = 0.2]
    nu_s: f64,
}
