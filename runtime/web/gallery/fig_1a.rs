/// Two equal bars, hinged at D, lie across a gap on two smooth corners, and fall: when do the corners let go?
///
/// Rozenblat & Grishakin (2023), Fig. 1a.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AD, mass = m, length = l)]
#[bar(DB, mass = m, length = l)]
#[support(P = corner(-l / 2, 0), under = AD)]
#[support(Q = corner(l / 2, 0), under = DB)]
#[figure(D = (0, 0), A = (-l, 0), B = (l, 0))]
#[coordinate(phi = angle(DB), from = horizontal)]
#[coordinate(y = -y(D))]
#[mirror(x = 0)]
#[run(start = "phi = 0.1", until = "phi = pi/2")]
struct FallingPair {
    #[value(1, unit = "kg")]
    m: f64,
    #[value(1, unit = "m")]
    l: f64,
    #[value(9.81, unit = "m/s²")]
    g: f64,
}
