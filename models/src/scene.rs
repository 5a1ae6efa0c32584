//! What to simulate: parameters, start and stop, with a default for every model.

use crate::{
    AFrame, DoublePendulum, FallingPair, FallingPairFull, Ladder, Pendulum, RodOnFloor, Zigzag, ZigzagFull,
    ZigzagPublished,
};
use liftoff::prelude::*;
use std::f64::consts::{FRAC_PI_2, PI};

/// Named values in the order given.
pub type Values = Vec<(String, f64)>;

/// Everything that a run needs beside the model's equations.
#[derive(Clone, PartialEq, Debug)]
pub struct Setup {
    /// Values of the parameters.
    pub parameters: Values,
    /// Coordinates and rates (`phi'`) given at the start; the others follow.
    pub start: Values,
    /// The pose at rest on whose energy level the motion starts; empty: the start's rates hold.
    pub energy_of: Values,
    /// Supports that never open.
    pub hold: Vec<String>,
    /// Supports that vanish, with the time.
    pub release: Values,
    /// Conditions to stop at, whichever comes first.
    pub until: Vec<String>,
    /// Whether the run ends where a contact closes.
    pub stop_at_impacts: bool,
    /// Relative tolerance of the integration.
    pub tolerance: f64,
}

impl Setup {
    /// A run of a model with these parameters, from its nominal figure.
    pub fn with(parameters: &[(&str, f64)]) -> Self {
        Self {
            parameters: named(parameters),
            start: Vec::new(),
            energy_of: Vec::new(),
            hold: Vec::new(),
            release: Vec::new(),
            until: Vec::new(),
            stop_at_impacts: false,
            tolerance: 1e-12,
        }
    }

    /// The same, started here.
    #[must_use]
    pub fn start(self, values: &[(&str, f64)]) -> Self {
        Self { start: named(values), ..self }
    }

    /// The same, on the energy level of this pose at rest.
    #[must_use]
    pub fn energy_of(self, values: &[(&str, f64)]) -> Self {
        Self { energy_of: named(values), ..self }
    }

    /// The same with these supports held.
    #[must_use]
    pub fn hold(self, supports: &[&str]) -> Self {
        Self { hold: supports.iter().map(ToString::to_string).collect(), ..self }
    }

    /// The same, stopped here too.
    #[must_use]
    pub fn until(mut self, condition: &str) -> Self {
        self.until.push(condition.into());
        self
    }

    /// The same, ended where a contact closes.
    #[must_use]
    pub fn stop_at_impacts(self) -> Self {
        Self { stop_at_impacts: true, ..self }
    }

    /// The same at this tolerance.
    #[must_use]
    pub fn tolerance(self, tolerance: f64) -> Self {
        Self { tolerance, ..self }
    }
}

/// `values` with their names owned.
pub fn named(values: &[(&str, f64)]) -> Values {
    values.iter().map(|&(name, value)| (name.into(), value)).collect()
}

/// A bar system with a name on the command line and a run worth seeing.
pub trait Scene: BarSystem {
    /// Name on the command line.
    const NAME: &'static str;
    /// What it is, in a line.
    const SUMMARY: &'static str;
    /// The default run.
    fn setup() -> Setup;
}

const ONE: [(&str, f64); 3] = [("m", 1.0), ("l", 1.0), ("g", 9.81)];
const HALVES: [(&str, f64); 4] = [("m1", 0.5), ("m2", 0.5), ("l", 1.0), ("g", 9.81)];

impl Scene for FallingPair {
    const NAME: &'static str = "falling-pair";
    const SUMMARY: &'static str = "two hinged bars fall through a gap (Fig. 1a), mirrored";
    fn setup() -> Setup {
        Setup::with(&ONE).start(&[("phi", 1e-2)]).energy_of(&[("phi", 0.0)]).until("phi = pi/2")
    }
}

impl Scene for FallingPairFull {
    const NAME: &'static str = "falling-pair-full";
    const SUMMARY: &'static str = "two hinged bars fall through a gap, no symmetry assumed";
    fn setup() -> Setup {
        let start = [("phi_left", 0.1), ("phi_right", 0.1)];
        Setup::with(&ONE).start(&start).until("phi_left = pi/2").until("phi_right = pi/2")
    }
}

impl Scene for ZigzagPublished {
    const NAME: &'static str = "zigzag-published";
    const SUMMARY: &'static str = "four bars in the shape of an M (Fig. 1b), equal angles, total reaction";
    fn setup() -> Setup {
        Setup::with(&HALVES).start(&[("phi", 1.56)]).energy_of(&[("phi", FRAC_PI_2)]).stop_at_impacts()
    }
}

impl Scene for Zigzag {
    const NAME: &'static str = "zigzag";
    const SUMMARY: &'static str =
        "four bars in the shape of an M (Fig. 1b), every support on its own, mirrored";
    fn setup() -> Setup {
        let upright = [("phi_inner", FRAC_PI_2), ("phi_outer", FRAC_PI_2), ("y", 0.0)];
        let start = [("phi_inner", 1.56), ("phi_outer", 1.56)];
        Setup::with(&HALVES).start(&start).energy_of(&upright).stop_at_impacts()
    }
}

impl Scene for ZigzagFull {
    const NAME: &'static str = "zigzag-full";
    const SUMMARY: &'static str = "four bars in the shape of an M, no symmetry assumed";
    fn setup() -> Setup {
        let start = [("phi_ab", 1.5), ("phi_bc", 1.5), ("phi_cd", 1.5), ("phi_de", 1.5)];
        Setup::with(&HALVES).start(&start).stop_at_impacts()
    }
}

impl Scene for Ladder {
    const NAME: &'static str = "ladder";
    const SUMMARY: &'static str = "a bar slides down a smooth wall onto a smooth floor";
    fn setup() -> Setup {
        Setup::with(&ONE).start(&[("phi", 75.0 * PI / 180.0)]).until("phi = 0")
    }
}

impl Scene for RodOnFloor {
    const NAME: &'static str = "rod-on-floor";
    const SUMMARY: &'static str = "a bar topples on a smooth floor";
    fn setup() -> Setup {
        Setup::with(&ONE).start(&[("phi", 1e-2)]).until("phi = pi/2")
    }
}

impl Scene for AFrame {
    const NAME: &'static str = "a-frame";
    const SUMMARY: &'static str = "two hinged bars slide apart on a smooth floor, mirrored";
    fn setup() -> Setup {
        Setup::with(&ONE).start(&[("phi", 80.0 * PI / 180.0)]).until("phi = 0")
    }
}

impl Scene for Pendulum {
    const NAME: &'static str = "pendulum";
    const SUMMARY: &'static str = "a hinged bar";
    fn setup() -> Setup {
        Setup::with(&ONE).start(&[("phi", FRAC_PI_2)]).until("t = 10")
    }
}

impl Scene for DoublePendulum {
    const NAME: &'static str = "double-pendulum";
    const SUMMARY: &'static str = "two bars hinged one to the other";
    fn setup() -> Setup {
        Setup::with(&ONE).start(&[("phi_1", 0.0), ("phi_2", PI - 0.1)]).until("t = 10")
    }
}
