//! Many states at once against one by one.

use liftoff::contact_set;
use liftoff::method::MethodId;
use liftoff::prelude::*;
use liftoff_core::batch::{Batch, BatchLanes, NoClosedForm};
use liftoff_core::model::Array;
use liftoff_fixtures::{Belt, Bob, FallingPair, HangingChain, Ladder};

/// The same bits as one by one, in a reduced phase and in a free one; the last states are fewer
/// than stand side by side.
#[test]
fn a_batch_has_the_bits_of_one() {
    let ladder = Ladder { m: 3.0, l: 2.0, g: 9.81 };
    same_as_one_by_one(&ladder, &["A", "B"], 1);
    same_as_one_by_one(&ladder, &["A"], 2);
    same_as_one_by_one(&ladder, &[], 3);
}

fn same_as_one_by_one<M: BarSystem + Phases>(model: &M, closed: &[&str], kept: usize) {
    let state = |k: usize| M::State::<f64>::from_fn(|i| 0.3 + 0.01 * k as f64 + 0.2 * i as f64);
    let states: Vec<_> = (0..BatchLanes::COUNT + 5).map(state).collect();
    let packed = Batch::<M>::pack(&states);
    let mut accelerations = vec![M::Accelerations::from_fn(|_| BatchLanes::splat(1.0)); packed.len()];
    let batch = Batch::new(model, contact_set(M::LAYOUT, closed).unwrap()).unwrap();
    batch.reduced_accelerations(&packed, &mut accelerations);
    let phase = Phases::phase(model, closed).unwrap();
    for (k, state) in states.iter().enumerate() {
        let alone = phase.reduced_accelerations(state.as_ref());
        assert_eq!(alone.len(), kept);
        for (i, a) in accelerations[k / BatchLanes::COUNT].as_ref().iter().enumerate() {
            assert_eq!(a.lane(k % BatchLanes::COUNT), alone.get(i).copied().unwrap_or(0.0));
        }
    }
}

/// A block that slides on a belt: m ẍ = −k x ∓ μ m g.
#[test]
fn a_batch_slides_with_friction() {
    let rough = Belt { m: 2.0, g: 9.81, k: 30.0, mu: 0.3, mu_s: 0.4, w: 0.0 };
    same_as_one_by_one(&rough, &["P"], 1);
    let state = [0.5, 0.0, 1.0, 0.0];
    let accelerated = |belt: &Belt| {
        let batch = Batch::new(belt, contact_set(Belt::LAYOUT, &["P"]).unwrap()).unwrap();
        let mut accelerations = vec![[BatchLanes::splat(0.0); 2]];
        batch.reduced_accelerations(&Batch::<Belt>::pack(&[state]), &mut accelerations);
        accelerations[0][0].lane(0)
    };
    let smooth = Belt { mu: 0.0, mu_s: 0.0, ..rough };
    assert!((accelerated(&smooth) + 30.0 * 0.5 / 2.0).abs() < 1e-14);
    assert!(((accelerated(&rough) - accelerated(&smooth)).abs() - 0.3 * 9.81).abs() < 1e-14);
}

/// Computed another way than one state is, with the same bits whatever is beside it; folded and
/// stretched too. M has a condition of some hundred.
#[test]
fn chains_side_by_side_agree_with_one() {
    let chain = HangingChain { m: 0.7, l: 1.3, g: 9.81 };
    let quarter = core::f64::consts::FRAC_PI_2;
    let state = |k: usize| -> [f64; 14] {
        core::array::from_fn(|i| match (k, i) {
            (0..4, 0..7) => quarter * (k * i) as f64,
            _ => 6.0 * (((1 + 14 * k + i) as f64 * 0.618_034).fract() - 0.5),
        })
    };
    let states: Vec<_> = (0..BatchLanes::COUNT + 3).map(state).collect();
    let batch = Batch::new(&chain, contact_set(HangingChain::LAYOUT, &[]).unwrap()).unwrap();
    let of = |states: &[[f64; 14]]| {
        let packed = Batch::<HangingChain>::pack(states);
        let mut accelerations = vec![[BatchLanes::splat(0.0); 7]; packed.len()];
        batch.reduced_accelerations(&packed, &mut accelerations);
        accelerations
    };
    let (together, phase) = (of(&states), Phases::phase(&chain, &[]).unwrap());
    for (k, state) in states.iter().enumerate() {
        let lane = together[k / BatchLanes::COUNT].map(|a| a.lane(k % BatchLanes::COUNT));
        assert_eq!(lane, of(&states[k..=k])[0].map(|a| a.lane(0)), "{k} beside others");
        let alone = phase.reduced_accelerations(state);
        let size = alone.iter().fold(0.0f64, |size, a| size.max(a.abs()));
        for (a, alone) in lane.iter().zip(&alone) {
            assert!((a - alone).abs() <= 1e-12 * size, "{k}: {a} for {alone}");
        }
    }
}

/// The same with a moment of inertia of its own.
#[derive(BarSystem)]
#[gravity(g)]
#[pin(O = (0, 0))]
#[chain(bar, links = 6, from = O, mass = m, length = l, inertia = j)]
#[coordinate(phi_1 = angle(bar1), from = down)]
#[coordinate(phi_2 = angle(bar2), from = down)]
#[coordinate(phi_3 = angle(bar3), from = down)]
#[coordinate(phi_4 = angle(bar4), from = down)]
#[coordinate(phi_5 = angle(bar5), from = down)]
#[coordinate(phi_6 = angle(bar6), from = down)]
struct Beads {
    m: f64,
    l: f64,
    j: f64,
    g: f64,
}

/// Dop853 evaluates the chain's loops, Taylor's method series of its own.
#[test]
fn chains_of_little_inertia_keep_their_digits() {
    for j in [1e-3, 1e-6, 1e-9] {
        let beads = Beads { m: 1.0, l: 1.0, j, g: 9.81 };
        let ends = [MethodId::Dop853, MethodId::Taylor].map(|method| {
            let simulation = Simulation::new(&beads).unwrap().method(method).limit(0.2).tolerance(1e-10);
            let start = Pose::new("phi_1", 1.0).with("phi_4", -0.5);
            simulation.start(start).unwrap().run().unwrap().final_state()
        });
        let size = ends[0].iter().fold(0.0f64, |size, x| size.max(x.abs()));
        for (x, y) in ends[0].iter().zip(&ends[1]) {
            assert!((x - y).abs() < 1e-8 * size, "{j}: {ends:?}");
        }
    }
}

#[test]
fn a_batch_needs_a_known_closed_form() {
    let pair = FallingPair { m: 1.0, l: 1.0, g: 9.81 };
    assert!(contact_set(FallingPair::LAYOUT, &["R"]).is_err());
    assert!(Batch::new(&pair, contact_set(FallingPair::LAYOUT, &["P", "Q"]).unwrap()).is_ok());
    let bob = Bob { m: 1.0, l: 1.0, g: 9.81 };
    let taut = contact_set(Bob::LAYOUT, &["rope"]).unwrap();
    assert_eq!(Batch::new(&bob, taut).err(), Some(NoClosedForm { closed: vec!["rope"] }));
}
