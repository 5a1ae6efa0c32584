use proptest::prelude::*;

use super::{LANES, Lanes};
use crate::scalar::Real;

/// Some use of every operation.
fn formula<S: Real>([x, y, z]: [S; 3]) -> [S; 4] {
    let (sin, cos) = (x * y).sin_cos();
    let root = x.mul_add(x, y * y).sqrt();
    [sin / root, -cos - S::ratio(2, 7) * z, root.mul_add(y, S::pi()), (x - y) / (z + S::from_f64(0.1))]
}

proptest! {
    /// Whatever is beside it, an angle beyond what is reduced by parts of π too.
    #[test]
    fn each_lane_has_the_bits_of_a_double(
        values in proptest::collection::vec([-1e3..1e3, -1e5..1e5, 0.1..9.0], 2 * LANES),
    ) {
        let each: Vec<[f64; 4]> = values.iter().map(|v| formula(*v)).collect();
        let two = formula::<Lanes<2>>(core::array::from_fn(|i| Lanes::from_fn(|lane| values[lane][i])));
        let one = formula::<Lanes>(core::array::from_fn(|i| Lanes::from_fn(|lane| values[lane][i])));
        for (lane, alone) in each.iter().enumerate() {
            prop_assert_eq!(&two.map(|x| x.lane(lane)), alone);
            if lane < LANES {
                prop_assert_eq!(&one.map(|x| x.to_array()[lane]), alone);
            }
        }
    }
}

#[test]
fn a_lane_is_replaced_alone() {
    let mut lanes = Lanes::<2>::splat(1.0);
    lanes.set(LANES + 3, -2.0);
    for lane in 0..Lanes::<2>::COUNT {
        assert_eq!(lanes.lane(lane), if lane == LANES + 3 { -2.0 } else { 1.0 });
    }
    let two = Lanes::splat(2.0);
    assert_eq!(lanes.abs().max(Lanes::splat(1.5)).min(two).lane(LANES + 3), 2.0);
}
