//! Many states at once against one by one.

use liftoff::model::Array;
use liftoff::prelude::*;
use liftoff::{Batch, NoClosedForm, Side, contact_set};
use liftoff_fixtures::{Bob, FallingPair, Ladder};

/// The same bits as one by one, in a reduced phase and in a free one; the last states are fewer than stand side by side.
#[test]
fn a_batch_has_the_bits_of_one() {
    let ladder = Ladder { m: 3.0, l: 2.0, g: 9.81 };
    same_as_one_by_one(&ladder, &["A", "B"], 1);
    same_as_one_by_one(&ladder, &["A"], 2);
    same_as_one_by_one(&ladder, &[], 3);
}

fn same_as_one_by_one<M: BarSystem + Phases>(model: &M, closed: &[&str], kept: usize) {
    let state = |k: usize| M::State::<f64>::from_fn(|i| 0.3 + 0.01 * k as f64 + 0.2 * i as f64);
    let states: Vec<_> = (0..Side::COUNT + 5).map(state).collect();
    let packed = Batch::<M>::pack(&states);
    let mut accelerations = vec![M::Accelerations::from_fn(|_| Side::splat(1.0)); packed.len()];
    let batch = Batch::new(model, contact_set(M::LAYOUT, closed).unwrap()).unwrap();
    batch.reduced_accelerations(&packed, &mut accelerations);
    let phase = Phases::phase(model, closed).unwrap();
    for (k, state) in states.iter().enumerate() {
        let alone = phase.reduced_accelerations(state.as_ref());
        assert_eq!(alone.len(), kept);
        for (i, a) in accelerations[k / Side::COUNT].as_ref().iter().enumerate() {
            assert_eq!(a.lane(k % Side::COUNT), alone.get(i).copied().unwrap_or(0.0));
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
