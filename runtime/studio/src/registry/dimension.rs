//! Dimensions of what a run is given, as powers of length, time and mass.

use liftoff::model::{self, Coordinate, Layout};

/// Powers of length, time and mass.
pub type Dimension = [f64; 3];

/// The dimension of each parameter; none where the model has numbers with a dimension in it, or a parameter whose dimension its
/// equations leave open.
pub(super) fn of_parameters(layout: &Layout) -> Option<Vec<Dimension>> {
    let powers = |dimension: &Option<model::Dimension>| dimension.map(|dimension| dimension.powers());
    layout.covariant.then(|| layout.dimensions.iter().map(powers).collect()).flatten()
}

/// The dimension of a coordinate.
pub fn of_coordinate(coordinate: &Coordinate) -> Dimension {
    if coordinate.is_angle { [0.0; 3] } else { [1.0, 0.0, 0.0] }
}

/// `a` per `b`.
pub fn per(a: Dimension, b: Dimension) -> Dimension {
    core::array::from_fn(|i| a[i] - b[i])
}
