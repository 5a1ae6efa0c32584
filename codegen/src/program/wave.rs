//! Values that are sines and cosines of angles.

use std::collections::{BTreeMap, BTreeSet};

use super::Id;
use crate::algebra::Symbol;

pub(super) type Argument = Vec<(Symbol, i16)>;

/// A function of an angle that a value is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Part {
    /// Its sine.
    Sine,
    /// Its cosine.
    Cosine,
    /// 1 less its cosine.
    Versed,
}

/// What a value made by addition theorems is in one step.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct WaveStep {
    /// Which function of the angle.
    pub part: Part,
    /// The angle: values, all of which vary, and their multiples.
    pub angle: Vec<(Id, i16)>,
    /// The sine and the cosine of the angle.
    pub sin_cos: (Id, Id),
}

/// Waves that are computed already, and the angles that are evaluated at their halves.
#[derive(Default)]
pub(super) struct ComputedWaves {
    pub half: BTreeSet<Symbol>,
    pub known: BTreeMap<(bool, Argument), (Id, Id)>,
}
