//! Linkages with one of their contacts twice.

use nalgebra::{DMatrix, DVector};

use super::oracle::{Contact, Linkage, Motion};
use super::random::{Random, cases, in_order, linkage, solve};

/// A linkage with one of its contacts again: the two share what the one bears.
fn with_twin(it: &Linkage, at: usize) -> Linkage {
    let (r, contact) = (it.bias.len(), it.contacts[at]);
    let rows: Vec<usize> = [Some(contact.normal), contact.tangent].into_iter().flatten().collect();
    let of = |row: usize| if row < r { row } else { rows[row - r] };
    let twin = Contact { normal: r, tangent: contact.tangent.map(|_| r + 1), ..contact };
    Linkage {
        jacobian: DMatrix::from_fn(r + rows.len(), it.mass.nrows(), |i, j| it.jacobian[(of(i), j)]),
        bias: DVector::from_fn(r + rows.len(), |row, _| it.bias[of(row)]),
        contacts: it.contacts.iter().copied().chain([twin]).collect(),
        ..it.clone()
    }
}

/// The motions with a contact twice are those with it once, and its load is shared as its law
/// allows.
#[test]
fn twins_share_the_load_of_one() {
    let mut random = Random(0x6A09_E667_F3BC_C908);
    let mut shared = 0;
    for k in 0..cases(200) {
        let one = linkage(&mut random, 1 + k % 3);
        let at = random.below(one.contacts.len() as u64);
        let both = with_twin(&one, at);
        let (expected, found) = match (solve(&one), solve(&both)) {
            (Ok(one), Ok(both)) => (one, both),
            (one, both) => {
                assert_eq!(one.err(), both.err(), "{k}");
                continue;
            }
        };
        assert_eq!(found.solutions.len(), expected.solutions.len(), "{k}");
        // With it closed there is one closed contact more.
        if found.reason != expected.reason {
            continue;
        }
        let size = 1.0 + expected.solution.accelerations.amax() + expected.solution.reactions.amax();
        let apart = (&found.solution.accelerations - &expected.solution.accelerations).amax();
        assert!(apart <= 1e-9 * size, "{k}: {apart}");
        let motion =
            Motion { a: found.solution.accelerations, multipliers: found.solution.reactions.clone() };
        let modes = in_order(&both, &found.solutions[found.taken]);
        assert!(both.violation(&modes, &motion) <= 1e-9, "{k}");
        let together =
            found.solution.reactions[one.contacts[at].normal] + found.solution.reactions[one.bias.len()];
        let alone = expected.solution.reactions[one.contacts[at].normal];
        assert!(!expected.solution.unique || (together - alone).abs() <= 1e-9 * size, "{k}");
        let bears = expected.solution.unique && alone != 0.0;
        assert!(!bears || !found.solution.unique && found.determined, "{k}");
        shared += usize::from(bears);
    }
    assert!(shared > 50, "{shared}");
}
