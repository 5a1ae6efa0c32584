use liftoff::BarSystem;

#[derive(BarSystem)]
#[bar(AB, mass = m, length = l)]
#[slider(A = horizontal(0), friction = -0.1)]
#[slider(B = vertical(0), friction = 0.3, static = 0.2)]
#[figure(A = (0, 0), B = (0, l))]
struct Coefficients {
    m: f64,
    l: f64,
}

#[derive(BarSystem)]
#[bar(AB, mass = m, length = l)]
#[particle(C, mass = m)]
#[particle(D, mass = m)]
#[particle(E, mass = m)]
#[particle(F, mass = m)]
#[particle(G, mass = m)]
#[slider(A = horizontal(0), static = 1)]
#[slider(C = horizontal(0), rough)]
#[slider(D = horizontal(0), jams)]
#[slider(E = horizontal(0), mu = 1)]
#[slider(F = horizontal(0), friction = 1, tangential = 1)]
#[hinge(A, friction = 1, radius = l)]
#[figure(A = (0, 0), B = (0, l), C = (l, 0), D = (2 * l, 0), E = (3 * l, 0), F = (4 * l, 0), G = (5 * l, 0))]
struct Options {
    m: f64,
    l: f64,
}

#[derive(BarSystem)]
#[particle(P, mass = m)]
#[slider(P = horizontal(0), friction = l)]
#[support(P = floor)]
#[figure(P = (0, l))]
struct Names {
    m: f64,
    l: f64,
}

#[derive(BarSystem)]
#[particle(P, mass = m)]
#[slider(P = horizontal(0), friction = x)]
#[figure(P = (0, 0))]
#[coordinate(x = x(P))]
struct Motion {
    m: f64,
}

#[derive(BarSystem)]
#[particle(P, mass = m)]
#[particle(Q, mass = m)]
#[slider(P = horizontal(0), friction = mu)]
#[slider(Q = horizontal(0), friction = mu)]
#[figure(P = (-1, 0), Q = (1, 0))]
#[mirror(x = 0)]
struct Mirrored {
    m: f64,
    mu: f64,
}

fn main() {}
