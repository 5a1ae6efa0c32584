use liftoff::BarSystem;

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
#[budget(flops = 20)]
#[budget(flops = 12, on())]
#[budget(flops = 200, on(P, Q))]
#[budget(flops = 10, on(R))]
struct Pair {
    m: f64,
    l: f64,
    g: f64,
}

#[derive(BarSystem)]
#[bar(AB, mass = m, length = l)]
#[budget(operations = 20)]
#[figure(A = (0, 0))]
struct Swing {
    m: f64,
    l: f64,
}

fn main() {}
