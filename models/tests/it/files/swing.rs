/// A bar that swings over an edge.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(OA, mass = m, length = l)]
#[pin(O = (0, 0))]
#[figure(A = (0, -l))]
#[coordinate(phi = angle(OA), from = down)]
#[run(start = "phi = 80 deg, phi' = 1", until = "t = 10")]
struct SwingingBar {
    /// Mass.
    #[value(2, unit = "kg")]
    m: f64,
    /// Length.
    #[value = 0.5]
    l: f64,
    /// Gravity.
    #[value(9.81, unit = "m/s²")]
    g: f64,
}
