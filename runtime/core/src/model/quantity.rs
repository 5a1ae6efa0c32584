//! What a model computes beside its motion and the reactions of its contacts.

/// A force, couple or momentum that a model computes by name.
#[derive(Clone, Copy, Debug)]
pub struct Quantity {
    /// Its name as expressions have it: `fx(D, AD)`, `shear(S)`, `px`.
    pub name: &'static str,
    /// What it is.
    pub kind: QuantityKind,
}

/// Kinds of [`Quantity`].
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum QuantityKind {
    /// A component of the force of a hinge, a pin or a slider: `fx(D, AD)`, `fy(O)`, `slider(P)`.
    JointForce,
    /// The couple of a weld: `couple(AB, BC)`.
    JointCouple,
    /// The force of a drive of a length: `drive(x(D))`.
    DriveForce,
    /// The torque of a drive of an angle: `drive(phi)`.
    DriveTorque,
    /// The distance that a drive prescribes: `target(distance(A, B))`.
    DrivenDistance,
    /// The tension of a spring with its damper: `force(AB)`.
    SpringForce,
    /// The torque of a torsion spring with its damper: `torque(AB)`.
    SpringTorque,
    /// An internal force of a bar: `normal(S)`, `shear(S)`.
    SectionForce,
    /// The bending moment of a bar: `moment(S)`.
    BendingMoment,
    /// A component of the momentum of the whole: `px`, `py`.
    Momentum,
    /// The angular momentum of the whole about the origin: `Lz`.
    AngularMomentum,
}

impl Quantity {
    /// The name before the arguments, `fx` of `fx(D, AD)`; none of a name without any.
    pub fn function(&self) -> Option<&'static str> {
        self.name.split_once('(').map(|(function, _)| function)
    }
}

impl QuantityKind {
    /// Whether a joint or a drive exerts it, so that it has an impulse where velocities jump.
    pub const fn is_of_joint(self) -> bool {
        matches!(self, Self::JointForce | Self::JointCouple | Self::DriveForce | Self::DriveTorque)
    }

    /// Whether it is a function of the state alone, so that no accelerations are solved for.
    pub const fn is_of_state(self) -> bool {
        matches!(
            self,
            Self::DrivenDistance
                | Self::SpringForce
                | Self::SpringTorque
                | Self::Momentum
                | Self::AngularMomentum
        )
    }
}
