//! Whatever Rust takes as a name serves as the name of a parameter, a coordinate, a point, a bar, a chain, a thread or a model,
//! whatever stands beside the model: what is emitted has names of its own.
#![allow(
    non_camel_case_types,
    non_snake_case,
    non_upper_case_globals,
    dead_code,
    clippy::upper_case_acronyms,
    reason = "names of all kinds"
)]

use liftoff_core::model::{BarSystem, ContactSet, Form, Phase, PhaseVisitor};

/// A bar over a floor, loaded by what follows the motion, its coordinate called `$name`; one that hangs on a thread, its point,
/// support and section called so; a chain, chain and model called so.
macro_rules! everything {
    ($($module:ident: $name:ident;)*) => {$(
        mod $module {
            #[derive(::liftoff_derive::BarSystem)]
            #[liftoff(crate = ::liftoff_core, names = false, dimensionless)]
            #[gravity(g)]
            #[bar(rod = P -> Q, mass = m, length = l)]
            #[support(Q = floor, restitution = 1 / 2)]
            #[couple(rod = m * sin($name) - rate($name))]
            #[figure(P = (0, l), Q = (l, l))]
            #[coordinate($name = angle(rod), from = horizontal)]
            pub struct Model { pub m: ::core::primitive::f64, pub l: ::core::primitive::f64, pub g: ::core::primitive::f64 }

            #[derive(::liftoff_derive::BarSystem)]
            #[liftoff(crate = ::liftoff_core, dimensionless)]
            #[bar(rod = $name -> Q0, mass = m, length = l)]
            #[support($name = floor)]
            #[section($name = rod, at = l / 2)]
            #[ground(Origin = (0, 2 * l))]
            #[thread(rope = $name -> Origin, length = 4 * l)]
            #[figure($name = (0, 0), Q0 = (l, 0))]
            pub struct Point { pub m: ::core::primitive::f64, pub l: ::core::primitive::f64 }

            #[derive(::liftoff_derive::BarSystem)]
            #[liftoff(crate = ::liftoff_core, dimensionless)]
            #[gravity(g)]
            #[chain($name, links = 3, from = Origin, mass = m, length = l)]
            #[pin(Origin = (0, 0))]
            #[figure(Origin = (0, 0))]
            pub struct $name { pub m: ::core::primitive::f64, pub l: ::core::primitive::f64, pub g: ::core::primitive::f64 }
        }
    )*};
}

/// All of it, and a pendulum whose parameter has the name.
macro_rules! names {
    ($($module:ident: $name:ident;)*) => {
        everything!($($module: $name;)*);
        mod parameters {$(
            pub mod $module {
                #[derive(::liftoff_derive::BarSystem)]
                #[liftoff(crate = ::liftoff_core, dimensionless)]
                #[gravity($name)]
                #[constant(half = $name / 2 + 1)]
                #[bar(AB, mass = $name, length = half)]
                #[pin(A = (0, 0))]
                #[figure(A = (0, 0), B = (half, 0))]
                pub struct Model { pub $name: ::core::primitive::f64 }
            }
        )*}
    };
}

names! {
    m01: k; m02: order; m03: multipliers; m04: accelerations; m05: None; m06: Ok; m07: Some; m08: Err; m09: ContactSet;
    m10: chi_rate; m11: S; m12: O; m13: Fn; m14: f64; m15: usize; m16: liftoff; m17: Bar; m18: Free; m19: r#type; m20: r#fn;
    m21: r#match; m22: set; m23: state; m24: visitor; m25: entry; m26: values; m27: x1; m28: sin; m29: cos; m30: lambda_0;
    m31: core; m32: Constants; m33: Layout; m34: Phase; m35: Self_; m36: φ; m37: r#async; m38: Clone; m39: Real; m40: LAYOUT;
    m41: names; m42: form; m43: k1; m44: k2; m45: On_A; m46: Held; m47: BarSystem; m48: Option; m49: Vec; m50: u64;
    m51: M; m52: U; m53: least; m54: liftoff_core; m55: std; m56: main; m57: half_sin; m58: drop; m59: _x; m60: __; m61: r#dyn;
    m62: union; m63: auto; m64: raw; m65: nominal; m66: bool; m67: str; m68: default; m69: Kernel; m70: 変数;
}

/// Names that the emission once gave itself, together.
#[derive(liftoff_derive::BarSystem)]
#[liftoff(crate = liftoff_core, dimensionless)]
#[gravity(k)]
#[bar(AB, mass = k0, length = k1)]
#[bar(BC, mass = k2, length = k3)]
#[pin(A = (0, 0))]
#[figure(A = (0, 0), B = (k1, 0), C = (k1 + k3, 0))]
#[coordinate(chi = angle(AB))]
#[coordinate(chi_rate = angle(BC))]
struct Rates {
    k: f64,
    k0: f64,
    k1: f64,
    k2: f64,
    k3: f64,
}

/// Two sets of contacts whose names, joined, are the same.
#[derive(liftoff_derive::BarSystem)]
#[liftoff(crate = liftoff_core, dimensionless)]
#[bar(AB, mass = m, length = l)]
#[support(A = floor)]
#[support(B = floor)]
#[support(A_and_B = wall(-1), under = A, facing = right)]
#[figure(A = (0, 0), B = (l, 0))]
struct Joined {
    m: f64,
    l: f64,
}

/// What stands beside a model, and methods of its own.
mod beside {
    const phi: f64 = 1.0;
    static state: f64 = 2.0;
    const k: u8 = 1;
    struct order;
    enum Some {}
    struct names;
    struct Phase;
    trait Real {}

    #[derive(liftoff_derive::BarSystem)]
    #[liftoff(crate = liftoff_core, dimensionless)]
    #[gravity(g)]
    #[bar(AB, mass = m, length = l)]
    #[pin(A = (0, 0))]
    #[couple(AB = sin(phi))]
    #[figure(A = (0, 0), B = (l, 0))]
    #[coordinate(phi = angle(AB))]
    pub struct Rod {
        pub m: f64,
        pub l: f64,
        pub g: f64,
    }

    impl Rod {
        pub fn kernel(&self) -> f64 {
            phi
        }
        pub fn energy() {}
        pub fn quantity() {}
        pub fn constants() {}
        pub fn nominal() {}
    }
}

/// Visits a phase for the length of its state.
struct Size;

impl<M: BarSystem> PhaseVisitor<M, f64> for Size {
    type Output = usize;
    fn visit<const N: usize>(self, _: Phase<M, f64, N>) -> usize {
        N
    }
}

fn size<M: BarSystem>() -> usize {
    M::phase::<f64, Size>(ContactSet::default(), Form::Reduced, Size)
}

#[test]
fn any_name_is_a_model() {
    assert_eq!(size::<m14::f64>() + size::<m11::S>() + size::<m17::Bar>() + size::<m19::r#type>(), 4 * 6);
    assert_eq!(size::<m54::liftoff_core>() + size::<beside::Rod>(), 6 + 2);
    assert_eq!(size::<Rates>() + size::<Joined>(), 4 + 6);
}

#[test]
fn raw_names_are_shown_without_their_prefix() {
    let names = |layout: &liftoff_core::model::Layout| {
        let coordinates = layout.coordinates.iter().map(|coordinate| coordinate.name);
        coordinates.chain(layout.parameters.iter().copied()).collect::<Vec<_>>().join(" ")
    };
    assert_eq!(m19::r#type::LAYOUT.name, "type");
    assert_eq!(names(m19::r#type::LAYOUT), "theta_type1 theta_type2 theta_type3 m l g");
    assert_eq!(names(parameters::m19::Model::LAYOUT), "theta_AB type");
    assert!(names(m19::Model::LAYOUT).starts_with("type "));
}

/// A pendulum whose parameter is called as the constants of all models were.
#[test]
fn a_name_changes_no_value() {
    let model = parameters::m01::Model { k: 3.0 };
    let constants = model.constants::<f64>();
    let energy = parameters::m01::Model::energy(&constants, &[0.0, 2.0]);
    // ½ (m l²/3) φ̇² with m = 3, l = 5/2.
    assert!((energy.kinetic - 12.5).abs() < 1e-13);
}
