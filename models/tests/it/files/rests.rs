/// A bar that hangs at rest.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(OA, mass = m, length = l)]
#[pin(O = (0, 0))]
#[figure(A = (0, -l))]
#[coordinate(phi = angle(OA), from = down)]
#[run(until = "t = 1")]
struct Rests {
    #[value(1, unit = "kg")]
    m: f64,
    #[value(1, unit = "m")]
    l: f64,
    #[value(9.81, unit = "m/s²")]
    g: f64,
}
