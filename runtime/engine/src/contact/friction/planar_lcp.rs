//! Planar friction as a linear complementarity problem (Pfeiffer and Glocker, *Multibody Dynamics
//! with Unilateral Contacts*, 1996, chapter 5). Of a contact at rest the reserves of friction
//! `λ_R = μ λ_N + R` and `λ_L = μ λ_N − R` are complementary to the parts of the slip acceleration
//! `v̇ = v̇⁺ − v̇⁻`:
//!
//! ```text
//! g̈_N = J_N a + b_N       ⟂  λ_N         a = a° + M̂⁻¹ Σ (J_N − μ J_t)ᵀ λ_N + J_tᵀ λ_R
//! v̇⁺ = J_t a + b_t + v̇⁻   ⟂  λ_R
//! λ_L = 2 μ λ_N − λ_R     ⟂  v̇⁻
//! ```
//!
//! A contact that slides has g̈_N ⟂ λ_N alone, one at its limit whose normal reaction is decided σ
//! v̇ ⟂ μ λ_N + σ R.

use nalgebra::{DMatrix, DVector};

use super::lemke;
use super::modes::{Bound, ContactMode, ModeChoice, ModeCondition, SlipDirection};
use super::problem::{ActiveRows, BalancedProblem, Unit};

/// Covering vectors tried, each another path.
const COVERS: usize = 3;
/// The golden ratio, whose multiples spread evenly.
const GOLDEN: f64 = 0.618_033_988_749_894_8;

/// How a contact enters the problem.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Shape {
    /// Closed in one mode, or open.
    Normal { closed: ContactMode },
    /// Any mode from rest.
    Rest,
    /// Closed: it sticks at its limit, or slides.
    Brink(SlipDirection),
}

/// The columns of forces and the rows of the complementary accelerations; entries besides
/// `J M̂⁻¹ C`.
#[derive(Default)]
struct LcpTableau {
    columns: Vec<Option<DVector<f64>>>,
    rows: Vec<Option<(usize, f64)>>,
    extra: Vec<(usize, usize, f64)>,
    /// Constants of rows without an acceleration.
    constants: Vec<(usize, f64)>,
    /// Tangential multipliers that are there without any variable.
    loads: Vec<(usize, f64)>,
    /// The unit and the meaning of each variable.
    variables: Vec<(usize, LcpVariable)>,
}

#[derive(Clone, Copy, PartialEq)]
enum LcpVariable {
    Normal,
    Right,
    Slip,
    Reserve,
}

impl Unit {
    /// How the contact enters, if its modes are of these kinds.
    pub(super) fn shape(&self) -> Option<Shape> {
        let whole =
            |choice: &ModeChoice| choice.asks(ModeCondition::Presses) || choice.mode == ContactMode::Open;
        let of = |mode: ContactMode| self.choices.iter().find(|choice| choice.mode == mode);
        if self.given.is_some() {
            return (self.choices.len() == 6).then_some(Shape::Rest);
        }
        let closed: Vec<&ModeChoice> =
            self.choices.iter().filter(|choice| choice.mode != ContactMode::Open).collect();
        match (of(ContactMode::Open), closed.as_slice()) {
            (Some(open), [one]) if open.asks(ModeCondition::Opens) && whole(one) => {
                Some(Shape::Normal { closed: one.mode })
            }
            (Some(open), [_, _, _])
                if open.asks(ModeCondition::Opens) && closed.iter().all(|it| whole(it)) =>
            {
                Some(Shape::Rest)
            }
            (None, [stick, slide]) if stick.mode == ContactMode::Stick && !whole(stick) && !whole(slide) => {
                match slide.mode {
                    ContactMode::Slide(sense) => Some(Shape::Brink(sense)),
                    _ => None,
                }
            }
            _ => None,
        }
    }
}

impl BalancedProblem<'_> {
    /// The modes of some contacts while all others stay open or, where they are decided, as they
    /// are.
    pub(super) fn lemke(
        &self,
        shapes: &[(usize, Shape)],
        held: &ActiveRows,
        mu: &dyn Fn(usize) -> f64,
    ) -> Option<Vec<(usize, ContactMode)>> {
        let kkt = self.kkt;
        let mut rows = LcpTableau::default();
        for &(unit, shape) in shapes {
            self.enter(&mut rows, unit, shape, mu(unit));
        }
        let held =
            &ActiveRows { loads: rows.loads.clone(), rows: held.rows.clone(), bends: held.bends.clone() };
        let equations = kkt.equations(held).ok()?;
        let free = match equations.solve() {
            Some(x) => x,
            None => equations.least_norm(&equations.right, kkt.n).filter(|(_, determined)| *determined)?.0,
        };
        let m = rows.variables.len();
        let (mut a, mut q) = (DMatrix::zeros(m, m), DVector::zeros(m));
        for (i, row) in rows.rows.iter().enumerate() {
            if let Some((row, sign)) = row {
                q[i] = sign * kkt.opening(*row, &free);
            }
        }
        for (j, column) in rows.columns.iter().enumerate() {
            let Some(column) = column else { continue };
            let response = kkt.response(held, column)?;
            for (i, row) in rows.rows.iter().enumerate() {
                if let Some((row, sign)) = row {
                    a[(i, j)] = sign * kkt.column_of(*row).dot(&response);
                }
            }
        }
        rows.extra.iter().for_each(|&(i, j, value)| a[(i, j)] += value);
        rows.constants.iter().for_each(|&(i, value)| q[i] += value);
        let cover = |turn: usize| {
            DVector::from_fn(m, |k, _| 1.0 + turn as f64 * ((k + turn) as f64 * GOLDEN).fract())
        };
        let basic = (0..COVERS).find_map(|turn| lemke::solve(&a, &q, &cover(turn)))?;
        let given = |unit: usize| self.units[unit].given.is_some();
        let mode = |&(unit, shape): &(usize, Shape)| (unit, mode(&rows, (unit, given(unit)), shape, &basic));
        Some(shapes.iter().map(mode).collect())
    }

    fn enter(&self, rows: &mut LcpTableau, at: usize, shape: Shape, mu: f64) {
        let (kkt, unit) = (self.kkt, &self.units[at]);
        let place = rows.variables.len();
        match (shape, unit.tangent) {
            (Shape::Normal { closed: ContactMode::Slide(sense) }, Some(tangent)) => {
                let column = kkt.bent_column(unit.normal, tangent, -sense.sign() * mu);
                rows.push((at, LcpVariable::Normal), Some(column), Some((unit.normal, 1.0)));
            }
            (Shape::Normal { .. }, _) | (_, None) => {
                let column = kkt.column_of(unit.normal);
                rows.push((at, LcpVariable::Normal), Some(column), Some((unit.normal, 1.0)));
            }
            (Shape::Rest, Some(tangent)) => {
                let bound = |sense: SlipDirection| match unit.given {
                    Some(_) => unit.kinetic(sense),
                    None => Bound { slope: mu, offset: 0.0 },
                };
                let [forward, backward] = [SlipDirection::Forward, SlipDirection::Backward].map(bound);
                let column = kkt.bent_column(unit.normal, tangent, -forward.slope);
                let constant = (forward.offset + backward.offset) / kkt.scale[kkt.n + tangent];
                let share = (forward.slope + backward.slope) * kkt.ratio(unit.normal, tangent);
                rows.loads.push((tangent, -forward.offset));
                rows.constants.push((place + 2, constant));
                rows.push((at, LcpVariable::Normal), Some(column), Some((unit.normal, 1.0)));
                rows.push((at, LcpVariable::Right), Some(kkt.column_of(tangent)), Some((tangent, 1.0)));
                rows.push((at, LcpVariable::Slip), None, None);
                rows.extra.extend([
                    (place + 1, place + 2, 1.0),
                    (place + 2, place, share),
                    (place + 2, place + 1, -1.0),
                ]);
            }
            (Shape::Brink(sense), Some(tangent)) => {
                let column = kkt.column_of(tangent) * sense.sign();
                rows.push((at, LcpVariable::Reserve), Some(column), Some((tangent, sense.sign())));
            }
        }
    }
}

impl LcpTableau {
    fn push(
        &mut self,
        variable: (usize, LcpVariable),
        column: Option<DVector<f64>>,
        row: Option<(usize, f64)>,
    ) {
        self.variables.push(variable);
        self.columns.push(column);
        self.rows.push(row);
    }
}

/// What a contact does by the basic variables of a solution.
fn mode(rows: &LcpTableau, (unit, given): (usize, bool), shape: Shape, basic: &[bool]) -> ContactMode {
    let is = |variable: LcpVariable| {
        let place = rows.variables.iter().position(|it| *it == (unit, variable));
        place.is_some_and(|place| basic[place])
    };
    let sense = || match (is(LcpVariable::Right), is(LcpVariable::Slip)) {
        (true, false) => None,
        (true, true) => Some(SlipDirection::Backward),
        (false, _) => Some(SlipDirection::Forward),
    };
    match shape {
        Shape::Normal { closed } if is(LcpVariable::Normal) => closed,
        Shape::Brink(_) if is(LcpVariable::Reserve) => ContactMode::Stick,
        Shape::Brink(sense) => ContactMode::Slide(sense),
        Shape::Rest if is(LcpVariable::Normal) => sense().map_or(ContactMode::Stick, ContactMode::Slide),
        Shape::Rest if given => ContactMode::Part(sense()),
        Shape::Normal { .. } | Shape::Rest => ContactMode::Open,
    }
}
