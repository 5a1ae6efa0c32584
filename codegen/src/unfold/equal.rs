//! Angles that a mirrored model keeps equal: a relation `Σ kᵢ δᵢ = constant` of directions has the
//! image `Σ kᵢ δᵢ' = constant'`.

use crate::kinematics::dependent;
use crate::system::{ConstrainedAngle, CoordinateKind, Equal, Mirror, Reference, System};

/// Equal angles whose images are not equal by what is declared already.
pub(super) fn without_image<'a>(system: &'a System, mirror: &Mirror) -> Vec<&'a Equal> {
    let equal: Vec<Vec<f64>> = system.equal.iter().map(|equal| of_equal(system, equal)).collect();
    let images: Vec<Vec<f64>> = equal.iter().map(|row| image(row, mirror)).collect();
    let mut rows: Vec<Vec<f64>> = welds(system).chain(equal).collect();
    let first = rows.len();
    rows.extend(images);
    let redundant = dependent(&rows);
    let lacking = system.equal.iter().enumerate().filter(|(i, _)| !redundant.contains(&(first + i)));
    lacking.map(|(_, equal)| equal).collect()
}

/// The factors of all directions in what a constraint keeps constant.
fn of_equal(system: &System, Equal { factors, left, right, .. }: &Equal) -> Vec<f64> {
    let mut row = vec![0.0; system.bodies.len()];
    let [a, b] = factors.map(f64::from);
    add(system, &mut row, left, a);
    add(system, &mut row, right, -b);
    row
}

fn add(system: &System, row: &mut [f64], direction: &ConstrainedAngle, factor: f64) {
    match *direction {
        ConstrainedAngle::Body(body) => row[body] += factor,
        ConstrainedAngle::Coordinate(i) => {
            if let CoordinateKind::Angle { body, reference, sign } = &system.coordinates[i].kind {
                row[*body] += factor * f64::from(*sign);
                if let Reference::Body(other) = reference {
                    row[*other] -= factor * f64::from(*sign);
                }
            }
        }
    }
}

fn welds(system: &System) -> impl Iterator<Item = Vec<f64>> + '_ {
    system.welds.iter().map(|weld| {
        let mut row = vec![0.0; system.bodies.len()];
        row[weld.body] = 1.0;
        if let Some(other) = weld.to {
            row[other] = -1.0;
        }
        row
    })
}

/// Up to a sign, of all factors alike.
fn image(row: &[f64], mirror: &Mirror) -> Vec<f64> {
    mirror.bodies.iter().map(|&(image, _)| row[image]).collect()
}
