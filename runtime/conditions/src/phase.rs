//! Contact sets by their names, and what in them keeps the energy from being conserved.

use std::collections::BTreeSet;

use liftoff_codegen::Analysis;
use liftoff_codegen::algebra::{Quotient, Series, Symbol, SymbolNames};
use liftoff_codegen::math::Math;
use liftoff_codegen::phases::Phase;
use liftoff_codegen::system::{Formula, Spring, Torsion};
use liftoff_codegen::text::TextWriter;

use crate::error::ConditionError;

/// A contact set with the names of its model.
pub(crate) struct Named<'a> {
    pub analysis: &'a Analysis,
    pub phase: &'a Phase,
    pub writer: TextWriter<'a>,
}

/// The contact set with these supports closed, in any order, or `free`.
pub(crate) fn find<'a>(analysis: &'a Analysis, asked: &str) -> Result<&'a Phase, ConditionError> {
    let names = |text: &str| {
        let text = text.trim();
        let text = text.strip_prefix("on ").unwrap_or(text);
        let mut names: Vec<String> = text.split(',').map(|name| name.trim().to_owned()).collect();
        names.sort();
        names
    };
    let titles = || analysis.phases.iter().map(|phase| Named::new(analysis, phase).title());
    let found = analysis.phases.iter().zip(titles()).find(|(phase, title)| {
        names(title) == names(asked) || phase.set.closed == 0 && asked.trim() == "free"
    });
    found.map(|(phase, _)| phase).ok_or_else(|| ConditionError::Phase {
        asked: asked.trim().to_owned(),
        known: titles().collect::<Vec<_>>().join(" | "),
    })
}

impl<'a> Named<'a> {
    pub fn new(analysis: &'a Analysis, phase: &'a Phase) -> Self {
        Self { analysis, phase, writer: TextWriter::new(analysis) }
    }

    /// `on A, E, C`, or `free`.
    pub fn title(&self) -> String {
        self.writer.title(self.phase.set)
    }

    /// The one coordinate that moves.
    pub fn single_coordinate(&self) -> Result<usize, ConditionError> {
        let name = |i: &usize| self.analysis.kinematics.coordinates[*i].name.clone();
        match (self.phase.kept.as_slice(), self.phase.moving.as_slice()) {
            ([single], [_]) => Ok(*single),
            (_, []) => Err(ConditionError::Fixed { phase: self.title() }),
            (kept, moving) => Err(ConditionError::Freedom {
                phase: self.title(),
                freedom: moving.len(),
                coordinates: kept.iter().map(name).collect::<Vec<_>>().join(", "),
            }),
        }
    }

    /// Refuses what is not conservative: `Q̂ = −Gᵀ ∂V/∂q` holds for what is, with `u = G u_k`.
    pub fn conserves_energy(&self) -> Result<(), ConditionError> {
        let phase = || self.title();
        let system = &self.analysis.system;
        let sliding = self.phase.sliding.iter();
        let rubs: Vec<String> =
            sliding.map(|slides| self.analysis.motion.contacts[slides.contact].label(system)).collect();
        if !rubs.is_empty() {
            return Err(ConditionError::Friction { phase: phase(), contacts: rubs.join(", ") });
        }
        if let Some(term) = self
            .analysis
            .motion
            .opaque_terms
            .iter()
            .find(|term| term.orders.iter().any(liftoff_codegen::motion::Expression::has_time))
        {
            return Err(ConditionError::Time { phase: phase(), what: format!("`{}`", term.name) });
        }
        for symbol in self.symbols() {
            match symbol {
                Symbol::Switch(i) => {
                    let what = system.switches[usize::from(i)].label.clone();
                    return Err(ConditionError::Switch { phase: phase(), what });
                }
                Symbol::Opaque { index, .. } => {
                    let what = self.analysis.motion.opaque_terms[usize::from(index)].name.clone();
                    return Err(ConditionError::Root { phase: phase(), what });
                }
                _ => {}
            }
        }
        let balanced = |(&moving, force): (&usize, &Quotient)| {
            let along = self.phase.kept.iter().map(|&i| {
                let carried = self.phase.rates[i].derivative(Symbol::rate(moving));
                &self.phase.potential.derivative(Symbol::coordinate(i)) * &carried
            });
            (force + &along.sum()).is_zero()
        };
        match self.phase.moving.iter().zip(&self.phase.forces).all(balanced) {
            true => Ok(()),
            false => Err(ConditionError::Dissipation { phase: phase(), what: self.loads() }),
        }
    }

    /// Whether all that acts beside gravity are springs with constant stiffness and length, and
    /// nothing slides.
    pub fn has_springs_only(&self) -> bool {
        let system = &self.analysis.system;
        let constant =
            |formula: Option<&Formula>| formula.is_none_or(|formula| formula.as_series().is_some());
        let spring = |s: &Spring| {
            s.damping.is_none()
                && s.switch.is_none()
                && constant(s.stiffness.as_ref())
                && constant(Some(&s.length))
        };
        let torsion = |s: &Torsion| {
            s.damping.is_none()
                && s.switch.is_none()
                && constant(s.stiffness.as_ref())
                && constant(Some(&s.angle))
        };
        let undamped = system.springs.iter().all(spring) && system.torsions.iter().all(torsion);
        let still = !self.analysis.motion.is_timed() && system.drives.is_empty();
        undamped && still && system.loads.is_empty() && self.phase.sliding.is_empty()
    }

    /// Every symbol in the equations of the contact set.
    fn symbols(&self) -> BTreeSet<Symbol> {
        self.series().flat_map(Series::symbols).collect()
    }

    /// All that the equations consist of.
    fn series(&self) -> impl Iterator<Item = &Series> {
        let Phase { mass, velocity_terms, forces, potential, reactions, .. } = self.phase;
        let all = mass.iter().flatten().chain(velocity_terms).chain(forces).chain([potential]);
        let all = all.chain(reactions.iter().map(|(_, reaction)| reaction));
        all.flat_map(|q| q.factors().iter().map(|(f, _)| f).chain([q.numerator()]))
    }

    /// Whether a coordinate occurs outside of sines and cosines, and in them.
    pub fn occurs(&self, coordinate: usize) -> [bool; 2] {
        let symbol = Symbol::coordinate(coordinate);
        let (mut plain, mut turns) = (false, false);
        for series in self.series() {
            plain |= series.degree(symbol) != 0;
            turns |= series.in_wave(symbol);
        }
        [plain, turns]
    }

    /// What may have no potential, by its names.
    fn loads(&self) -> String {
        let system = &self.analysis.system;
        let springs = system.springs.iter().filter(|spring| spring.damping.is_some());
        let torsions = system.torsions.iter().filter(|torsion| torsion.damping.is_some());
        let dampers = springs.map(|spring| format!("damper `{}`", spring.name));
        let dampers = dampers.chain(torsions.map(|torsion| format!("damper `{}`", torsion.name)));
        let loads = system.loads.iter().map(|load| format!("load `{}`", load.name));
        let all: Vec<String> = dampers.chain(loads).collect();
        if all.is_empty() { "what moves it".to_owned() } else { all.join(", ") }
    }
}

/// Names of a model, and those of the starts of its coordinates: `phi_0`.
impl SymbolNames for Named<'_> {
    fn parameter(&self, index: u16) -> Math {
        self.writer.parameter(index)
    }

    fn rank_parameter(&self, index: u16) -> u8 {
        self.writer.rank_parameter(index)
    }

    fn coordinate(&self, index: u16) -> String {
        match index.checked_sub(self.analysis.motion.n as u16) {
            None => self.writer.coordinate(index),
            Some(started) => format!("{}_0", self.writer.coordinate(started)),
        }
    }

    fn reaction(&self, index: u16) -> Math {
        self.writer.reaction(index)
    }

    fn opaque_term(&self, index: u16) -> String {
        self.writer.opaque_term(index)
    }
}
