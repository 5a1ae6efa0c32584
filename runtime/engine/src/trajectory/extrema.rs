//! Turning points of an output along phases that events join.

use super::Extremum;

/// An output over one phase.
pub(super) struct Way {
    /// Times and values of its start and its end.
    pub(super) ends: [(f64, f64); 2],
    /// The turning points between them.
    pub(super) turns: Vec<Extremum>,
}

/// All turning points: those of the phases, and the ends of phases that lie above both values next
/// to them, or below.
pub(super) fn along(ways: Vec<Way>, delta: f64) -> Vec<Extremum> {
    // Times and values in order, with the turning points among them.
    let mut nodes: Vec<(f64, f64, Option<Extremum>)> = Vec::new();
    for Way { ends: [start, end], turns } in ways {
        let joins =
            nodes.last().is_some_and(|(t, value, _)| *t == start.0 && (value - start.1).abs() <= delta);
        nodes.extend((!joins).then_some((start.0, start.1, None)));
        nodes.extend(turns.into_iter().map(|turn| (turn.t, turn.value, Some(turn))));
        nodes.push((end.0, end.1, None));
    }
    let turning = |i: usize| {
        let (t, value, _) = nodes[i];
        let [before, after] = [i.checked_sub(1)?, i + 1].map(|k| nodes.get(k).map(|node| node.1));
        let (before, after) = (before? - value, after? - value);
        let turns = before.abs().min(after.abs()) > delta && before * after > 0.0;
        turns.then_some(Extremum { t, value, minimum: before > 0.0 })
    };
    (0..nodes.len()).filter_map(|i| nodes[i].2.or_else(|| turning(i))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn way(ends: [(f64, f64); 2]) -> Way {
        Way { ends, turns: Vec::new() }
    }

    /// The rate of what falls, rebounds at 1, rises to 2 and is driven on without a jump.
    #[test]
    fn both_sides_of_a_jump_turn() {
        let ways = vec![
            way([(0.0, 0.0), (1.0, -9.0)]),
            way([(1.0, 6.0), (2.0, -3.0)]),
            way([(2.0, -3.0 + 1e-9), (3.0, -5.0)]),
        ];
        let found = along(ways, 1e-6);
        let shown: Vec<_> = found.iter().map(|turn| (turn.t, turn.value, turn.minimum)).collect();
        assert_eq!(shown, [(1.0, -9.0, true), (1.0, 6.0, false)]);
    }

    /// The height of what falls and rebounds.
    #[test]
    fn a_kink_turns_once() {
        let ways = vec![way([(0.0, 2.0), (1.0, 0.0)]), way([(1.0, 0.0), (2.0, 1.0)])];
        let found = along(ways, 1e-6);
        assert_eq!(found, [Extremum { t: 1.0, value: 0.0, minimum: true }]);
        assert_eq!(along(Vec::new(), 0.0), []);
    }
}
