//! Loads that follow what a support holds still: in that phase they are functions of nothing, and compile.

use liftoff_core::model::BarSystem;
use liftoff_derive::BarSystem;

macro_rules! loaded {
    ($($name:ident: $couple:expr;)*) => {$(
        #[derive(BarSystem)]
        #[liftoff(crate = liftoff_core, dimensionless)]
        #[gravity(g)]
        #[bar(BC, mass = m, length = l)]
        #[support(B = floor)]
        #[couple(BC = $couple)]
        #[figure(B = (0, 0), C = (l, 0))]
        struct $name {
            m: f64,
            l: f64,
            g: f64,
        }
    )*};
}

loaded! {
    Sine: sin(y(B));
    Cosine: m * cos(2 * y(B) + l) * sin(y(C));
    Root: sqrt(1 + y(B) * y(B));
    Tangent: tan(y(B) - 1);
    Both: sin(y(B)) + sin(x(B) - y(B)) / (2 + cos(y(B)));
    Rate: sin(vy(B)) + cos(vy(C));
    Nested: sin(sin(y(B)) + l) * sin(cos(x(C) + 1));
    Inverse: 1 / (1 + y(B)) + (y(B) + m).powi(3);
}

#[test]
fn they_are_models() {
    let contacts = [Sine::LAYOUT, Cosine::LAYOUT, Root::LAYOUT, Tangent::LAYOUT, Both::LAYOUT, Rate::LAYOUT];
    assert!(contacts.iter().all(|layout| layout.closed_forms.len() == 2));
    assert_eq!([Nested::LAYOUT, Inverse::LAYOUT].map(|layout| layout.contacts.len()), [1, 1]);
}
