//! Everything that is declared beside the structure.

use super::{Declared, Drive, Equal, Load, Section, Slider, Spring, Support, Torsion, Weld};

/// What constrains, drives and loads the structure.
pub(super) struct Parts {
    pub coordinates: Vec<Declared>,
    pub supports: Vec<Support>,
    pub equal: Vec<Equal>,
    pub welds: Vec<Weld>,
    pub sliders: Vec<Slider>,
    pub drives: Vec<Drive>,
    pub springs: Vec<Spring>,
    pub torsions: Vec<Torsion>,
    pub loads: Vec<Load>,
    pub sections: Vec<Section>,
}
