//! A declaration in maximal coordinates: every body has x, y of its centre of mass and an angle,
//! every point mass x and y. Whatever ties or touches them is a row
//!
//! ```text
//! J q̇ + d = 0  (two-sided),   ġ = J q̇ + d  (one-sided),   d = ∂g/∂t
//! ```

mod contacts;
mod expressions;
mod forces;
mod joints;
mod places;
mod readings;
mod values;

use crate::tape::{Node, Tape};
use liftoff_codegen::system::{Law, System};
use liftoff_core::scalar::Scalar;
use values::Values;

/// A constraint.
#[derive(Clone, Debug)]
pub struct Row {
    /// What is zero or positive; none of a slip.
    pub value: Option<Node>,
    /// Its derivatives by positions.
    pub gradient: Vec<(usize, Node)>,
    /// Its derivative by time alone.
    pub prescribed_gap_rate: Node,
}

/// A one-sided constraint.
#[derive(Clone, Debug)]
pub struct Contact<S> {
    /// Its name in the declaration.
    pub name: String,
    /// Its gap.
    pub row: Row,
    /// Its slip, if it is rough.
    pub slip: Option<Row>,
    /// Of a corner: its distances from the ends of the bar, along it.
    pub foot: Option<[Node; 2]>,
    /// Restitution.
    pub restitution: S,
    /// Whether its impacts follow Poisson's law.
    pub poisson: bool,
    /// Whether reaching it ends a run.
    pub stop: bool,
}

/// Everything that a declaration says of motion, for the values of its parameters.
pub struct Scene<S> {
    /// The arithmetic of all of it.
    pub tape: Tape<S>,
    /// The mass or moment of inertia of each coordinate.
    pub masses: Vec<S>,
    /// Applied force on each coordinate.
    pub forces: Vec<Node>,
    /// Two-sided constraints; what images across the mirror keep is among them, so that a contact
    /// and its image are one.
    pub joints: Vec<Row>,
    /// One-sided constraints in the order declared.
    pub contacts: Vec<Contact<S>>,
    /// The public coordinates.
    pub readings: Vec<Row>,
    /// Potential energy of weight and springs.
    pub potential: Node,
    /// Whether the energy never grows between events: nothing drives and no load acts.
    pub passive: bool,
    /// Positions of the declared points.
    pub points: Vec<[Node; 2]>,
    /// Their names.
    pub names: Vec<String>,
    /// Coordinates at the nominal figure.
    pub figure: Vec<S>,
    /// The largest length of it.
    pub length: f64,
    /// Which coordinates are angles.
    pub angles: Vec<bool>,
}

impl<S: Scalar> Scene<S> {
    /// The number of maximal coordinates.
    pub fn n(&self) -> usize {
        self.masses.len()
    }
}

/// A scene while it is written.
pub(crate) struct Builder<'a, S> {
    system: &'a System,
    values: Values<S>,
    tape: Tape<S>,
    points: Vec<[Node; 2]>,
    /// Where its coordinates begin, of each particle.
    carriers: Vec<usize>,
    joints: Vec<Row>,
    forces: Vec<Node>,
    potential: Node,
    /// What torsion springs measure, and whole turns to be taken off it.
    turned: Vec<(Node, Node)>,
}

/// Why a declaration cannot be judged.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum SceneError {
    /// It is no declaration.
    #[error("the declaration is not understood: {0}")]
    Declaration(String),
    /// A coordinate that the declaration does not have.
    #[error("coordinate `{0}` is not in the declaration")]
    Coordinate(String),
    /// A parameter that leaves the range of double-double.
    #[error("a parameter of {0} leaves the range of double-double")]
    Range(String),
    /// So many coordinates that dense factorisations take too long.
    #[error("{0} maximal coordinates are too many for a dense judge")]
    Size(usize),
    /// A support whose law the judge does not have.
    #[error("support `{0}` has friction, or a surface that moves, which are not judged")]
    Friction(String),
    /// What is there while a condition holds; the judge has all contacts, springs and loads at all
    /// times.
    #[error("{0} is active on a condition only; the judge treats every part as always active")]
    Switch(String),
    /// A load by a table, whose pieces the judge's series do not tell apart.
    #[error("`{0}` has a table, which is not judged")]
    Table(String),
}

/// More maximal coordinates than these are not judged.
const MOST: usize = 150;

impl<S: Scalar> Scene<S> {
    /// The scene of a declaration with values of its parameters; public states have these
    /// coordinates.
    ///
    /// # Errors
    /// See [`SceneError`].
    pub fn new(declaration: &str, parameters: &[f64], coordinates: &[&str]) -> Result<Self, SceneError> {
        let tokens: proc_macro2::TokenStream =
            declaration.parse().map_err(|error| SceneError::Declaration(format!("{error}")))?;
        let system =
            liftoff_codegen::resolve(tokens).map_err(|error| SceneError::Declaration(format!("{error}")))?;
        let n = 3 * system.bodies.len() + 2 * system.particles.len();
        if n > MOST {
            return Err(SceneError::Size(n));
        }
        if let Some(rubs) = system.supports.iter().find(|s| s.friction.is_some() || s.moving.is_some()) {
            return Err(SceneError::Friction(rubs.name.clone()));
        }
        if let Some(switched) = system.supports.iter().find(|s| s.armed.is_some() || s.breaks.is_some()) {
            return Err(SceneError::Switch(switched.name.clone()));
        }
        if let Some(switch) = system.switches.first() {
            return Err(SceneError::Switch(switch.label.clone()));
        }
        let loads =
            system.loads.iter().map(|load| (&load.name, load.kind.values().iter().collect::<Vec<_>>()));
        let springs = system.springs.iter().map(|spring| {
            let law = [spring.stiffness.as_ref(), Some(&spring.length), spring.damping.as_ref()];
            (&spring.name, law.into_iter().flatten().collect())
        });
        let torsions = system.torsions.iter().map(|torsion| {
            let law = [torsion.stiffness.as_ref(), Some(&torsion.angle), torsion.damping.as_ref()];
            (&torsion.name, law.into_iter().flatten().collect())
        });
        let mut all = loads.chain(springs).chain(torsions);
        if let Some((name, _)) = all.find(|(_, law)| law.iter().any(|formula| formula.has_table())) {
            return Err(SceneError::Table(name.clone()));
        }
        Builder::new(&system, parameters, n).finish(coordinates)
    }
}

impl<S: Scalar> Builder<'_, S> {
    fn finish(mut self, coordinates: &[&str]) -> Result<Scene<S>, SceneError> {
        let system = self.system;
        self.ties();
        self.loads();
        let readings = coordinates.iter().map(|name| self.public(name)).collect::<Result<_, _>>()?;
        let contacts = system.supports.iter().map(|support| self.contact(support)).collect();
        let images = self.images();
        self.joints.extend(images);
        let bodies = system.bodies.len();
        let masses = self.masses();
        let mut scene = Scene {
            figure: self.figure(),
            length: self.length(),
            angles: (0..masses.len()).map(|i| i < 3 * bodies && i % 3 == 2).collect(),
            names: system.points.iter().map(|point| point.name.clone()).collect(),
            passive: system.loads.is_empty() && system.drives.is_empty() && !winds(system),
            masses,
            forces: self.forces,
            joints: self.joints,
            contacts,
            readings,
            potential: self.potential,
            points: self.points,
            tape: self.tape,
        };
        scene.wind(&self.turned);
        Ok(scene)
    }

    fn constant(&mut self, series: &liftoff_codegen::algebra::Series) -> Node {
        let value = self.values.number(series);
        self.tape.number(value)
    }

    fn constants(&mut self, pair: &[liftoff_codegen::algebra::Series; 2]) -> [Node; 2] {
        [self.constant(&pair[0]), self.constant(&pair[1])]
    }

    fn difference(&mut self, a: [Node; 2], b: [Node; 2]) -> [Node; 2] {
        [self.tape.subtract(a[0], b[0]), self.tape.subtract(a[1], b[1])]
    }

    /// The row of a value.
    fn row(&mut self, value: Node) -> Row {
        let drift = self.tape.derivative(value, crate::tape::Variable::Time);
        Row { value: Some(value), gradient: self.tape.gradient(value), prescribed_gap_rate: drift }
    }
}

/// Whether a spring changes with time.
fn winds(system: &System) -> bool {
    let springs = system.springs.iter().flat_map(|spring| [spring.stiffness.as_ref(), Some(&spring.length)]);
    let torsions = system.torsions.iter().flat_map(|t| [t.stiffness.as_ref(), Some(&t.angle)]);
    springs.chain(torsions).flatten().any(|value| value.as_series().is_none())
}

fn is_poisson(law: Law) -> bool {
    law == Law::Poisson
}
