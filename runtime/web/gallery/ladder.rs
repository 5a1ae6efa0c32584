/// A bar leans on a smooth wall and slides down: B leaves the wall when sin φ is two thirds of what it was.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[support(A = floor)]
#[support(B = wall(0), facing = right)]
#[figure(A = (3 * l / 5, 0), B = (0, 4 * l / 5))]
#[coordinate(phi = angle(AB), from = horizontal)]
#[run(start = "phi = 75 deg", until = "phi = 0")]
struct Ladder {
    #[value(1, unit = "kg")]
    m: f64,
    #[value(1, unit = "m")]
    l: f64,
    #[value(9.81, unit = "m/s²")]
    g: f64,
}
