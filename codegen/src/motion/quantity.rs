//! What a model computes beside its motion and the reactions of its contacts.

/// A quantity of a model by its name, with what gives it: products of series, or its place in the
/// program.
#[derive(Clone, Debug)]
pub struct Quantity<T> {
    /// As expressions have it: `fx(D, AD)`.
    pub name: String,
    /// What it is.
    pub kind: QuantityKind,
    /// What gives it.
    pub value: T,
}

/// The runtime's `QuantityKind`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum QuantityKind {
    /// Of a hinge, a pin or a slider.
    JointForce,
    /// Of a weld.
    JointCouple,
    /// Of a drive of a length.
    DriveForce,
    /// Of a drive of an angle.
    DriveTorque,
    /// What a drive prescribes.
    DrivenDistance,
    /// Of a spring.
    SpringForce,
    /// Of a torsion spring.
    SpringTorque,
    /// Normal force or shear.
    SectionForce,
    /// In a section.
    BendingMoment,
    /// Along an axis.
    Momentum,
    /// About the origin.
    AngularMomentum,
}

impl<T> Quantity<T> {
    pub(crate) fn new(name: impl Into<String>, kind: QuantityKind, value: T) -> Self {
        Self { name: name.into(), kind, value }
    }

    /// Both components of a joint's force; `holder` is its point, `D`, or with the body that bears
    /// it, `D, AD`.
    pub(crate) fn joint_force(holder: &str, [x, y]: [T; 2]) -> [Self; 2] {
        [("fx", x), ("fy", y)]
            .map(|(axis, force)| Self::new(format!("{axis}({holder})"), QuantityKind::JointForce, force))
    }

    /// The momenta of the whole along the axes and about the origin.
    pub(crate) fn momenta([x, y, about_origin]: [T; 3]) -> [Self; 3] {
        [
            Self::new("px", QuantityKind::Momentum, x),
            Self::new("py", QuantityKind::Momentum, y),
            Self::new("Lz", QuantityKind::AngularMomentum, about_origin),
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::QuantityKind::*;
    use crate::analyse;

    /// A drive is a torque where what it drives is an angle: a coordinate that is one, or a
    /// direction.
    #[test]
    fn each_quantity_has_the_kind_of_what_it_is() {
        let analysis = analyse(
            "#[gravity(g)] #[bar(AB, mass = m, length = l)] #[bar(BC, mass = m, length = l)]
             #[bar(CD, mass = m, length = l)] #[bar(DE, mass = m, length = l)] #[weld(CD, DE)]
             #[coordinate(x = x(A))] #[coordinate(phi = angle(AB), from = right)]
             #[coordinate(y = y(A))] #[coordinate(psi = angle(BC), from = right)]
             #[coordinate(chi = angle(CD), from = right)]
             #[drive(x = a * t)] #[drive(phi = w * t)] #[drive(y(A) = a * t)] #[drive(angle(BC) = w * t)]
             #[ground(O = (0, -l))] #[spring(OB, stiffness = k)] #[torsion(BC, CD, stiffness = c)]
             #[section(S = AB, at = s)]
             #[figure(A = (0, 0), B = (l, 0), C = (2 * l, 0), D = (3 * l, 0), E = (4 * l, 0))]
             struct Arm { m: f64, l: f64, g: f64, a: f64, w: f64, k: f64, c: f64, s: f64 }"
                .parse()
                .unwrap(),
        );
        let quantities = analysis.unwrap().functions.quantities;
        let kind = |name: &str| quantities.iter().find(|q| q.name == name).map(|q| q.kind);
        for (name, expected) in [
            ("fx(B, AB)", JointForce),
            ("couple(CD, DE)", JointCouple),
            ("drive(x)", DriveForce),
            ("drive(y(A))", DriveForce),
            ("drive(phi)", DriveTorque),
            ("drive(angle(BC))", DriveTorque),
            ("force(OB)", SpringForce),
            ("torque(BC, CD)", SpringTorque),
            ("normal(S)", SectionForce),
            ("moment(S)", BendingMoment),
            ("py", Momentum),
            ("Lz", AngularMomentum),
        ] {
            assert_eq!(kind(name), Some(expected), "{name} among {quantities:?}");
        }
    }
}
