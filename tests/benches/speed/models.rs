//! Right-hand sides of declared models, with all contacts open and, where that has a closed form,
//! with all closed.

use core::hint::black_box;

use liftoff_codegen::analyse;
use liftoff_compiled::*;
use liftoff_core::model::{BarSystem, ContactSet, Form, Phase, PhaseVisitor};
use serde_json::{Value, json};

use crate::Result;
use crate::expansion::operations;
use crate::timing::nanoseconds;

/// States that are evaluated one after the other, none needing another's result.
const STATES: usize = 64;

/// A row for every model and contact set.
pub fn rows() -> Result<Vec<Value>> {
    let tables = [
        rows_of(FallingPair { m: 1.0, l: 1.0, g: 9.81 })?,
        rows_of(DoublePendulum { m: 1.0, l: 1.0, g: 9.81 })?,
        rows_of(Pendulum { m: 1.0, l: 1.0, g: 9.81 })?,
        rows_of(Ladder { m: 1.0, l: 1.0, g: 9.81 })?,
        rows_of(Zigzag { m1: 0.75, m2: 0.25, l: 1.0, g: 9.81 })?,
        rows_of(FoldedChain { m: 1.0, l: 1.0, g: 9.81 })?,
        rows_of(Walker { m: 10.0, l: 1.0, a: 0.75f64.atan(), k: 100.0, c: 1.0, g: 9.81 })?,
    ];
    Ok(tables.into_iter().flatten().collect())
}

fn rows_of<M: BarSystem>(model: M) -> Result<Vec<Value>> {
    let layout = M::LAYOUT;
    let analysis = analyse(layout.declaration.parse().map_err(|error| format!("{error:?}"))?)?;
    let all = (0..layout.contacts.len()).collect();
    let sets = if layout.contacts.is_empty() {
        vec![("open", all)]
    } else {
        vec![("open", ContactSet::EMPTY), ("closed", all)]
    };
    let row = |(contacts, set): (&str, ContactSet)| {
        let operations = operations(&analysis, set.iter().fold(0, |bits, contact| bits | 1 << contact));
        let (form, ns) = M::phase(set, Form::Reduced, Time(&model));
        json!({ "model": layout.name, "contacts": contacts, "form": format!("{form:?}"), "ns": ns, "operations": operations })
    };
    Ok(sets.into_iter().map(row).collect())
}

struct Time<'a, M>(&'a M);

impl<M: BarSystem> PhaseVisitor<M, f64> for Time<'_, M> {
    type Output = (Form, f64);

    fn visit<const N: usize>(self, phase: Phase<M, f64, N>) -> (Form, f64) {
        let value = |i: usize, j: usize| 0.2 + 0.6 * ((1 + i * N + j) as f64 * 0.618_034).fract();
        let states: Vec<[f64; N]> = (0..STATES).map(|i| core::array::from_fn(|j| value(i, j))).collect();
        let constants = self.0.constants::<f64>();
        let mut evaluate = || {
            for state in &states {
                black_box((phase.derivative)(&constants, &phase.set, black_box(state)));
            }
        };
        let [ns] = nanoseconds([&mut evaluate]);
        (phase.form, ns / STATES as f64)
    }
}
