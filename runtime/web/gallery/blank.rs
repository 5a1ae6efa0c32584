/// A bar that falls: what is it joined to, and what does it touch?
#[derive(BarSystem)]
#[gravity(9.81)]
#[bar(AB, mass = 1, length = 1)]
#[figure(A = (0, 0), B = (1, 0))]
#[run(limit = 1)]
struct Mine {}
