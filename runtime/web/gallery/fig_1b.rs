/// Four bars in the shape of an M on a smooth floor: which support opens first? Drag `lambda`, the outer bars' part of the mass:
/// below a quarter A and E do, above it C.
///
/// Rozenblat & Grishakin (2023), Fig. 1b, with every support watched on its own.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m * lambda, length = l)]
#[bar(BC, mass = m * (1 - lambda), length = l)]
#[bar(CD, mass = m * (1 - lambda), length = l)]
#[bar(DE, mass = m * lambda, length = l)]
#[support(A = floor)]
#[support(C = floor)]
#[support(E = floor)]
#[support(B = floor, stop)]
#[support(D = floor, stop)]
#[figure(C = (0, 0), D = (3 * l / 5, 4 * l / 5), E = (6 * l / 5, 0))]
#[coordinate(phi_inner = angle(CD), from = horizontal)]
#[coordinate(phi_outer = angle(DE), from = horizontal)]
#[coordinate(y = y(C))]
#[mirror(x = 0)]
#[run(start = "phi_inner = 85 deg, phi_outer = 85 deg", limit = 5)]
struct Zigzag {
    /// Mass of an inner and an outer bar together.
    #[value(1, unit = "kg")]
    m: f64,
    /// The outer bar's part of it.
    #[value(0.5)]
    lambda: f64,
    /// Length of one bar.
    #[value(1, unit = "m")]
    l: f64,
    #[value(9.81, unit = "m/s²")]
    g: f64,
}
