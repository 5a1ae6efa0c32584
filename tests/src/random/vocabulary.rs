//! What may occur in a drawn system, and how often.

use super::splitmix::Source;

/// Chances of each kind of thing; what has none takes no draws, so that other systems stay as they
/// are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vocabulary {
    /// That a bar is a triangle.
    pub triangles: f64,
    /// That a bar is welded to the one it is hinged to, or to the ground.
    pub welds: f64,
    /// Free point masses.
    pub particles: f64,
    /// Points on lines of the ground and on bars.
    pub sliders: f64,
    /// Inextensible threads.
    pub threads: f64,
    /// Springs and dampers between points.
    pub springs: f64,
    /// Springs and dampers between directions.
    pub torsions: f64,
    /// Applied forces.
    pub forces: f64,
    /// Applied couples.
    pub couples: f64,
    /// Prescribed motions.
    pub drives: f64,
    /// Circles, bowls and slots.
    pub curved: f64,
    /// That a support is rough.
    pub rough: f64,
    /// That a support or thread has restitution.
    pub restitution: f64,
    /// Sections of bars.
    pub sections: f64,
}

impl Vocabulary {
    /// Bars, hinges, pins, masses and straight supports.
    pub const BARS: Self = Self {
        triangles: 0.0,
        welds: 0.0,
        particles: 0.0,
        sliders: 0.0,
        threads: 0.0,
        springs: 0.0,
        torsions: 0.0,
        forces: 0.0,
        couples: 0.0,
        drives: 0.0,
        curved: 0.0,
        rough: 0.0,
        restitution: 0.0,
        sections: 0.0,
    };

    /// Everything.
    pub const ALL: Self = Self {
        triangles: 0.12,
        welds: 0.1,
        particles: 0.25,
        sliders: 0.25,
        threads: 0.3,
        springs: 0.3,
        torsions: 0.2,
        forces: 0.3,
        couples: 0.2,
        drives: 0.15,
        curved: 0.3,
        rough: 0.2,
        restitution: 0.2,
        sections: 0.3,
    };
}

/// Whether something of a chance occurs; certain failure takes no draw.
pub fn occurs(source: &mut Source, chance: f64) -> bool {
    chance > 0.0 && source.chance(chance)
}
