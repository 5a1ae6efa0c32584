/// Two bars that swing from each other.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(OA, mass = m, length = l)]
#[bar(AB, mass = m, length = l)]
#[pin(O = (0, 0))]
#[figure(A = (0, -l), B = (0, -2 * l))]
#[coordinate(phi = angle(OA), from = down)]
#[coordinate(psi = angle(AB), from = down)]
#[run(start = "phi = 170 deg, psi = 90 deg", until = "t = 20")]
struct DoublePendulum {
    #[value(1, unit = "kg")]
    m: f64,
    #[value(1, unit = "m")]
    l: f64,
    #[value(9.81, unit = "m/s²")]
    g: f64,
}
