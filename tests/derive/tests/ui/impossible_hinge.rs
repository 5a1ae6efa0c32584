use liftoff::BarSystem;

#[derive(BarSystem)]
#[bar(AB, mass = m, length = l)]
#[bar(BC, mass = m, length = l)]
#[bar(BD, mass = m, length = l)]
#[bar(CE, mass = m, length = l)]
#[pin(A = (0, 0))]
#[hinge(A)]
#[hinge(B, friction = 1, radius = l)]
#[hinge(C, friction = -1, radius = l)]
#[hinge(D, friction = 1, radius = l)]
#[hinge(E, friction = 1)]
#[pin(A, radius = l)]
#[figure(B = (0, l), C = (l, l), D = (0, 2 * l), E = (2 * l, l))]
struct Points {
    m: f64,
    l: f64,
}

#[derive(BarSystem)]
#[bar(AB, mass = m, length = l)]
#[bar(BC, mass = m, length = l)]
#[pin(A = (0, 0))]
#[hinge(A, friction = 0.3, static = 0.2, radius = l)]
#[hinge(B, friction = l, radius = 0)]
#[support(A = floor)]
#[figure(B = (0, l), C = (l, l))]
struct Numbers {
    m: f64,
    l: f64,
}

#[derive(BarSystem)]
#[bar(AB, mass = m, length = l)]
#[bar(BC, mass = m, length = l)]
#[pin(A = (0, 0))]
#[weld(AB, BC)]
#[hinge(B, friction = 0.3, radius = l)]
#[figure(B = (0, l), C = (l, l))]
struct Welded {
    m: f64,
    l: f64,
}

#[derive(BarSystem)]
#[bar(AB, mass = m, length = l)]
#[pin(A = (0, 0))]
#[coordinate(phi = angle(AB))]
#[drive(phi = w * t)]
#[hinge(A, friction = 0.3, radius = l)]
#[figure(B = (0, l))]
struct Driven {
    m: f64,
    l: f64,
    w: f64,
}

#[derive(BarSystem)]
#[bar(AB, mass = m, length = l)]
#[bar(CB, mass = m, length = l)]
#[support(A = floor)]
#[support(C = floor)]
#[hinge(B, friction = 0.3, radius = r)]
#[figure(A = (-l / 2, 0), B = (0, sqrt(3) * l / 2), C = (l / 2, 0))]
#[mirror(x = 0)]
struct Mirrored {
    m: f64,
    l: f64,
    r: f64,
}

#[derive(BarSystem)]
#[bar(AB, mass = m, length = l)]
#[pin(A = (0, 0))]
#[support(B = floor, restitution = 1, law = poisson)]
#[hinge(A, friction = 0.3, radius = r)]
#[figure(B = (l, l / 4))]
struct Struck {
    m: f64,
    l: f64,
    r: f64,
}

#[derive(BarSystem)]
#[chain(link, links = 20, from = O, mass = m, length = l)]
#[pin(O = (0, 0))]
#[hinge(O, friction = 0.3, radius = r)]
struct Long {
    m: f64,
    l: f64,
    r: f64,
}

fn main() {}
