//! The mass matrix of a tree by paths: where body i carries body j, `M_ij = e_i · s_j`, e_i the
//! reach of i towards j and `s_j = p_j + Σ m' e'` the first moment of j with what it carries put
//! where it begins; `M_jj = I_j + Σ m' |e'|²`.

use super::geometry::{TreeGeometry, signed};
use super::vector::Vector;
use crate::algebra::Series;
use crate::motion::{Tree, square};
use crate::program::{Id, Lowering};

/// The factors of M, by coordinate.
#[derive(Clone, Debug)]
pub struct Paths {
    /// The coordinate of the body that carries this one's.
    pub parents: Vec<Option<usize>>,
    /// e of the parent towards it, turned with the parent's coordinate.
    pub reach: Vec<Vector>,
    /// s, turned with its own coordinate.
    pub moments: Vec<Vector>,
    /// M_jj.
    pub own: Vec<Id>,
}

/// Moments of the branches in their frames, and M_jj.
fn local(tree: &Tree) -> (Vec<[Series; 2]>, Vec<Series>) {
    let beyond = tree.masses();
    let mut moments: Vec<[Series; 2]> = tree.branches.iter().map(|branch| branch.first()).collect();
    let mut own: Vec<Series> = tree.branches.iter().map(|branch| branch.inertia()).collect();
    for (i, branch) in tree.branches.iter().enumerate() {
        if let Some(parent) = branch.parent {
            (0..2).for_each(|axis| moments[parent][axis] += &beyond[i] * &branch.reach[axis]);
            own[parent] += &beyond[i] * &square(&branch.reach);
        }
    }
    (moments, own)
}

/// M of a tree.
pub(in crate::functions) fn paths(lowering: &mut Lowering, geometry: &TreeGeometry) -> Paths {
    let branches = &geometry.tree.branches;
    let (moments, own) = local(geometry.tree);
    let zero = lowering.program().integer(0);
    let n = branches.len();
    let mut paths = Paths {
        parents: vec![None; n],
        reach: vec![[zero; 2]; n],
        moments: vec![[zero; 2]; n],
        own: vec![zero; n],
    };
    for (i, branch) in branches.iter().enumerate() {
        let coordinate = branch.coordinate;
        paths.own[coordinate] = lowering.series(&own[i]);
        let moment = geometry.turned(lowering, i, &moments[i]);
        paths.moments[coordinate] = moment.map(|part| signed(lowering.program(), branch.sign, part));
        if let Some(parent) = branch.parent {
            let sign = branches[parent].sign;
            paths.parents[coordinate] = Some(branches[parent].coordinate);
            paths.reach[coordinate] = geometry.reach[i].map(|part| signed(lowering.program(), sign, part));
        }
    }
    paths
}
