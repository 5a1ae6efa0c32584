//! The reduced equations against the full ones, at random states; which rows have a closed form,
//! and on which branch.

mod branches;
mod laws;
mod limits;
mod rules;

use super::Phase;
use crate::Analysis;

/// The phase in which these contacts are closed, and stick if they have friction.
fn phase(analysis: &Analysis, closed: u64) -> Option<&Phase> {
    analysis.phases.iter().find(|phase| phase.set.closed == closed && phase.sliding.is_empty())
}
