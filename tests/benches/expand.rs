//! Time of the derive macro's work for every model and for a chain of 16 bars.
//!
//! Users' macros are built unoptimised:
//! `cargo bench --profile dev -p liftoff-tests --bench expand`.

use divan::Bencher;
use liftoff_compiled::*;
use liftoff_core::model::BarSystem;

fn main() {
    divan::main();
}

fn expand(bencher: Bencher, declaration: &str) {
    let tokens: proc_macro2::TokenStream = declaration.parse().expect("a declaration is Rust");
    bencher.bench_local(|| liftoff_codegen::expand(tokens.clone()));
}

#[divan::bench(types = [
    FallingPair, FallingPairFull, ZigzagPublished, Zigzag, ZigzagFull, Ladder, RodOnFloor, AFrame, Pendulum,
    DoublePendulum,
])]
fn model<M: BarSystem>(bencher: Bencher) {
    expand(bencher, M::LAYOUT.declaration);
}

#[divan::bench]
fn chain_of_16(bencher: Bencher) {
    expand(
        bencher,
        "#[gravity(g)] #[pin(O = (0, 0))] #[chain(link, links = 16, from = O, mass = m, length = l)]
         struct Chain { m: f64, l: f64, g: f64 }",
    );
}
