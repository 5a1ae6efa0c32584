/// A four-bar linkage: the crank OA turns steadily, the rocker CB swings.
#[derive(BarSystem)]
#[gravity(9.81)]
#[bar(OA, mass = 1, length = a)]
#[bar(AB, mass = 3, length = 3)]
#[bar(CB, mass = 2, length = 2.5)]
#[pin(O = (0, 0))]
#[pin(C = (3, 0))]
#[figure(A = (0, 1), B = (2.9, 2.5))]
#[coordinate(phi = angle(OA))]
#[drive(phi = omega * t + pi / 2)]
#[run(limit = 6.3)]
struct FourBar {
    /// Length of the crank.
    #[value(1, unit = "m")]
    a: f64,
    /// Its angular velocity.
    #[value(2, unit = "rad/s")]
    omega: f64,
}
