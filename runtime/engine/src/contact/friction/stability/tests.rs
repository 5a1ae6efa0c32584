//! W of contacts that slide, in natural units.

use nalgebra::{DMatrix, DVector};

use super::super::modes::{ContactMode, Frictional, SlipDirection, SlipVelocity};
use super::super::problem::{BalancedProblem, FrictionProblem};
use super::{closed, least, sticking};
use crate::contact::complementarity::LcpRows;
use crate::contact::equilibrated_kkt::EquilibratedKkt;
use crate::contact::friction::tests::random::{Random, cases};

/// J_N M⁻¹ (J_N − σ μ J_t)ᵀ by its trace and its determinant, which do not depend on the basis:
/// with rows of any lengths, and a joint taken in.
#[test]
fn compliances_are_those_of_natural_units() {
    let mut random = Random(0xB5C0_FBCF_EC4D_3B2F);
    for k in 0..cases(200) {
        let (n, held) = (5, k % 2);
        let lengths = [1.0, 1e3, 1e-2, 30.0, 0.2];
        let root = DMatrix::from_fn(n, n, |_, _| random.between(-1.0, 1.0));
        let mass = &root * root.transpose() + DMatrix::identity(n, n);
        // Two normals, their tangents, a joint.
        let jacobian = DMatrix::from_fn(5, n, |row, _| lengths[row] * random.between(-1.0, 1.0));
        let mut senses = || [SlipDirection::Forward, SlipDirection::Backward][random.below(2)];
        let senses = [senses(), senses()];
        let mu = [0.3, 0.8];
        let pair = |mu: f64| (mu, mu);
        let contacts = [0, 1].map(|k| {
            Frictional::touching((k, 2 + k), pair(mu[k] * lengths[k] / lengths[2 + k]), SlipVelocity::Rest)
        });
        let (none, bias) = (DVector::zeros(n), DVector::zeros(5));
        let kkt = EquilibratedKkt::new(&mass, &jacobian, (&none, &bias), (&none, &bias));
        let rows = LcpRows { fixed: &[4][..held], ..LcpRows::default() };
        let question = FrictionProblem { rows, contacts: &contacts };
        let problem = BalancedProblem::new(&kkt, &question);
        let mut inverse = mass.try_inverse().unwrap();
        if held > 0 {
            let by = &inverse * jacobian.row(4).transpose();
            inverse -= &by * by.transpose() / (jacobian.row(4) * &by)[0];
        }
        let push = |k: usize| {
            let slope = senses[k].sign() * contacts[k].mu;
            jacobian.row(k).transpose() - jacobian.row(2 + k).transpose() * slope
        };
        let expected = DMatrix::from_fn(2, 2, |i, j| (jacobian.row(i) * &inverse * push(j))[0]);
        let modes = senses.map(ContactMode::Slide);
        let found = problem.compliance(&modes, &[0, 1], &[0, 1]).unwrap();
        let size = expected.amax();
        assert!((found.trace() - expected.trace()).abs() < 1e-9 * size, "{k} {found} {expected}");
        let smallest = expected[(0, 0)].abs().min(expected[(1, 1)].abs());
        let apart = (found.determinant() - expected.determinant()).abs();
        assert!(apart < 1e-7 * size * smallest.max(1e-9 * size), "{k} {found} {expected}");
        // Held by springs where both eigenvalues are on the right.
        let (trace, determinant) = (expected.trace(), expected.determinant());
        assert_eq!(problem.is_stable(&modes), trace > 0.0 && determinant > 0.0, "{k} {expected}");
    }
}

#[test]
fn closed_and_sticking_contacts_are_counted() {
    let slide = ContactMode::Slide(SlipDirection::Forward);
    let modes = [
        ContactMode::Open,
        ContactMode::Stick,
        slide,
        ContactMode::Part(None),
        ContactMode::Part(Some(SlipDirection::Forward)),
        slide,
    ];
    assert_eq!((closed(&modes), sticking(&modes)), (3, 2));
    let numbers = [4, 2, 7, 2, 9];
    assert_eq!(least(&[0, 1, 2, 3], |k| numbers[k]), [1, 3]);
    assert_eq!(least(&[4, 2], |k| numbers[k]), [2]);
    assert!(least(&[], |k| numbers[k]).is_empty());
}
