//! The shortest reactions against those on every face of their cones.

use nalgebra::{DMatrix, DVector};

use super::{Factor, share, shortest_reactions};
use crate::contact::closed_rows::ClosedRows;
use crate::contact::friction::tests::random::{Random, cases};
use crate::contact::tests::shared::Pushed;
use crate::model::{ContactSet, Slip};
use crate::system::Model;

/// What is missing of a load that is held.
const HELD: f64 = 1e-12;

/// Closed rows of two-sided ones and contacts, with reactions that their cones allow.
#[derive(Clone)]
struct Loaded {
    jacobian: DMatrix<f64>,
    levers: Vec<f64>,
    factors: Vec<Factor>,
    /// Places whose rows press with λ < 0.
    negative: Vec<usize>,
    reactions: DVector<f64>,
}

impl Loaded {
    /// Some contacts have no reaction.
    fn new(random: &mut Random, contacts: usize) -> Self {
        let (n, two_sided) = (2 + random.below(2), random.below(3));
        let (mut factors, mut negative, mut reactions) = (Vec::new(), Vec::new(), Vec::new());
        let mut levers = Vec::new();
        for _ in 0..two_sided {
            reactions.push(random.between(-1.0, 1.0));
            levers.push([1.0, 3.0, 0.2][random.below(3)]);
        }
        for _ in 0..contacts {
            let (normal, tangent) = (reactions.len(), reactions.len() + 1);
            let bears = random.between(0.0, 1.0) * [0.0, 1.0, 1.0][random.below(3)];
            let slope = random.between(0.1, 1.5) * [-1.0, 1.0][random.below(2)];
            let limit = slope.abs();
            let (factor, tangential) = match random.below(3) {
                0 => (Factor::Pressing(normal), None),
                1 => (Factor::Cone { normal, tangent, limit }, Some(random.between(-limit, limit) * bears)),
                _ => (Factor::Edge { normal, tangent, slope }, Some(slope * bears)),
            };
            factors.push(factor);
            let presses = random.below(4) > 0;
            negative.extend((!presses).then_some(normal));
            reactions.push(if presses { bears } else { -bears });
            reactions.extend(tangential);
        }
        levers.resize(reactions.len(), 1.0);
        let jacobian = DMatrix::from_fn(reactions.len(), n, |_, _| random.between(-1.0, 1.0));
        Self { jacobian, levers, factors, negative, reactions: DVector::from_vec(reactions) }
    }

    /// The same with more on each contact.
    fn pressed(&self, more: f64) -> Self {
        let mut it = self.clone();
        for factor in &self.factors {
            let (Factor::Pressing(normal) | Factor::Edge { normal, .. } | Factor::Cone { normal, .. }) =
                *factor;
            it.reactions[normal] += self.sign(normal) * more;
            if let Factor::Edge { tangent, slope, .. } = *factor {
                it.reactions[tangent] += slope * more;
            }
        }
        it
    }

    fn sign(&self, place: usize) -> f64 {
        if self.negative.contains(&place) { -1.0 } else { 1.0 }
    }

    /// Columns that span a face of each contact's cone, with whether they have a sign, and what is
    /// open two-sided.
    fn faces(&self) -> Vec<Vec<DVector<f64>>> {
        let r = self.reactions.len();
        let column = |entries: &[(usize, f64)]| {
            let mut column = DVector::zeros(r);
            entries.iter().for_each(|&(k, x)| column[k] = x);
            column
        };
        let mut taken = vec![false; r];
        let mut faces = vec![Vec::new()];
        for factor in &self.factors {
            let of = |normal: usize| (normal, self.sign(normal));
            let options: Vec<Vec<DVector<f64>>> = match *factor {
                Factor::Pressing(normal) => {
                    taken[normal] = true;
                    vec![vec![], vec![column(&[of(normal)])]]
                }
                Factor::Edge { normal, tangent, slope } => {
                    (taken[normal], taken[tangent]) = (true, true);
                    vec![vec![], vec![column(&[of(normal), (tangent, slope)])]]
                }
                Factor::Cone { normal, tangent, limit } => {
                    (taken[normal], taken[tangent]) = (true, true);
                    let edge = |sign: f64| column(&[of(normal), (tangent, sign * limit)]);
                    let whole = vec![column(&[of(normal)]), column(&[(tangent, 1.0)])];
                    vec![vec![], vec![edge(1.0)], vec![edge(-1.0)], whole]
                }
            };
            let with = |face: &Vec<DVector<f64>>| {
                let face = face.clone();
                options.iter().map(move |option| [face.clone(), option.clone()].concat()).collect::<Vec<_>>()
            };
            faces = faces.iter().flat_map(with).collect();
        }
        let free = (0..r).filter(|&k| !taken[k]).map(|k| column(&[(k, self.levers[k])]));
        let free: Vec<DVector<f64>> = free.collect();
        faces.into_iter().map(|face| [free.clone(), face].concat()).collect()
    }

    /// The length of reactions, couples at their levers.
    fn length(&self, reactions: &DVector<f64>) -> f64 {
        reactions.iter().zip(&self.levers).map(|(x, lever)| (x / lever).powi(2)).sum::<f64>().sqrt()
    }

    fn is_allowed(&self, reactions: &DVector<f64>) -> bool {
        self.factors.iter().all(|factor| match *factor {
            Factor::Pressing(normal) => self.sign(normal) * reactions[normal] >= -1e-10,
            Factor::Cone { normal, tangent, limit } => {
                reactions[tangent].abs() <= limit * self.sign(normal) * reactions[normal] + 1e-10
            }
            Factor::Edge { normal, tangent, slope } => {
                let bears = self.sign(normal) * reactions[normal];
                bears >= -1e-10 && (reactions[tangent] - slope * bears).abs() <= 1e-10
            }
        })
    }

    /// The length of the shortest of the reactions that are shortest on a face and allowed, and by
    /// how much reactions on that face change with their load.
    fn brute_force(&self) -> (f64, f64) {
        let load = self.jacobian.tr_mul(&self.reactions);
        let unit = |k: usize| 1.0 / self.levers[k];
        let mut least = (f64::INFINITY, 0.0);
        for face in self.faces().iter().filter(|face| !face.is_empty()) {
            let span = DMatrix::from_columns(face);
            let units = DMatrix::from_fn(span.nrows(), span.ncols(), |k, j| unit(k) * span[(k, j)]);
            // Along an orthonormal basis of the face the shortest reactions have the shortest
            // components.
            let r = units.clone().qr().r();
            let Some(back) = r.try_inverse() else { continue };
            let acts = self.jacobian.tr_mul(&span) * &back;
            let svd = acts.clone().svd(true, true);
            let Ok(y) = svd.solve(&load, 1e-9) else { continue };
            let Ok(rest) = svd.solve(&(&load - &acts * &y), 1e-9) else { continue };
            let y = y + rest;
            if (&acts * &y - &load).amax() > HELD {
                continue;
            }
            let reactions = span * back * y;
            if self.is_allowed(&reactions) && self.length(&reactions) < least.0 {
                let smallest = svd.singular_values.iter().copied().filter(|s| *s > 1e-9).fold(1.0, f64::min);
                least = (self.length(&reactions), 1.0 / smallest);
            }
        }
        least
    }
}

/// Rows of a larger system, in another order.
fn shared(it: &Loaded, dual: &mut Option<DVector<f64>>) -> (DVector<f64>, Vec<f64>) {
    let r = it.reactions.len();
    let rows: Vec<usize> = (0..r).map(|k| 2 * (r - k)).collect();
    let mut all = vec![7.0; 2 * r + 1];
    rows.iter().zip(it.reactions.iter()).for_each(|(&row, x)| all[row] = *x);
    let negative: Vec<usize> = it.negative.iter().map(|&k| rows[k]).collect();
    let (jacobian, levers) = (it.jacobian.clone(), it.levers.clone());
    let closed = ClosedRows { rows: rows.clone(), jacobian, levers };
    share(closed, it.factors.clone(), &negative, (&mut all, dual));
    let others = (0..all.len()).filter(|row| !rows.contains(row)).map(|row| all[row]).collect();
    (DVector::from_fn(r, |k, _| all[rows[k]]), others)
}

#[test]
fn shared_loads_are_held_by_the_shortest_reactions() {
    let mut random = Random(0xBB67_AE85_84CA_A73B);
    let (mut left, examined) = (0, cases(600));
    for k in 0..examined {
        let it = Loaded::new(&mut random, 1 + k % 3);
        let mut dual = None;
        let (found, others) = shared(&it, &mut dual);
        assert!(others.iter().all(|x| *x == 7.0), "{k}");
        let load = |reactions: &DVector<f64>| it.jacobian.tr_mul(reactions);
        assert!((load(&found) - load(&it.reactions)).amax() <= HELD, "{k}");
        assert!(it.is_allowed(&found), "{k} {found}");
        let Some(y) = dual else {
            // Rounding puts what is at the border of what the cones bear beyond it: pressed a
            // little more they are found.
            left += 1;
            shared(&it.pressed(1e-6), &mut dual);
            assert!(dual.is_some(), "{k}: none is found");
            continue;
        };
        let (least, change) = it.brute_force();
        let known = 1e-9 * (1.0 + least) + HELD * change;
        assert!((it.length(&found) - least).abs() <= known, "{k} {} {least}", it.length(&found));
        // The same from where the search has ended, and from elsewhere.
        for start in [y.clone(), y.map(|y| -3.0 * y)] {
            let (again, _) = shared(&it, &mut Some(start));
            assert!((&again - &found).amax() <= known, "{k}");
        }
    }
    assert!(1000 * left <= examined, "{left}");
}

/// Loads and lengths in other units.
#[test]
fn shares_have_no_units() {
    let mut random = Random(0x3C6E_F372_A54F_F53A);
    for k in 0..cases(200) {
        let it = Loaded::new(&mut random, 1 + k % 3);
        let mut dual = None;
        let (found, _) = shared(&it, &mut dual);
        if dual.is_none() {
            continue;
        }
        for (load, length) in [(1e20, 1e-4), (1e-20, 1e5)] {
            let (jacobian, reactions) = (&it.jacobian * length, &it.reactions * load);
            let other = Loaded { jacobian, reactions, ..it.clone() };
            let (other, _) = shared(&other, &mut None);
            assert!((other / load - &found).amax() <= 1e-9, "{k}");
        }
    }
}

/// While it slides its friction is −σ μ N of each support, and a third of the weight is the least
/// that each can bear.
#[test]
fn supports_that_slide_share_the_load_with_their_friction() {
    let (m, g, mu) = (2.0, 9.81, 0.3);
    let model = Model::new(&Pushed { m, l: 0.7, g, mu, p: 0.0 });
    for (slip, sense) in [(Slip::Forward, 1.0), (Slip::Backward, -1.0)] {
        let closed = (0..3).fold(ContactSet::EMPTY, |set, contact| set.slipping(contact, slip));
        let mut state = [0.0; 6];
        let x = model.layout().coordinates.iter().position(|it| it.name == "x").unwrap();
        state[3 + x] = sense;
        let weight = m * g;
        let (ends, middle) = (0.5 * weight, 0.0);
        let normals = [ends, ends, middle];
        let held: Vec<f64> = normals.iter().copied().chain(normals.map(|n| -sense * mu * n)).collect();
        let found = shortest_reactions(&*model.system, &state, &closed, &held, &mut None);
        for contact in 0..3 {
            let [normal, friction] = [found[contact], found[3 + contact]];
            assert!((normal - weight / 3.0).abs() < 1e-12 * weight, "{slip:?} {found:?}");
            assert!((friction + sense * mu * normal).abs() < 1e-12 * weight, "{slip:?} {found:?}");
        }
    }
}

mod steps;
