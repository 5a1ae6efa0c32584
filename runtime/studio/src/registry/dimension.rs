//! Dimensions of what a run is given, as powers of length, time and mass.

use liftoff_core::model::{self, Layout};

/// Powers of length, time and mass.
pub type Dimension = [f64; 3];

/// The dimension of each parameter; none where the model has numbers with a dimension in it, or a
/// parameter whose dimension its equations leave open.
pub(super) fn of_parameters(layout: &Layout) -> Option<Vec<Dimension>> {
    let powers = |dimension: &Option<model::Dimension>| dimension.map(|dimension| dimension.powers());
    layout.covariant.then(|| layout.dimensions.iter().map(powers).collect()).flatten()
}

/// The dimension of a coordinate, if there is one of this name.
pub fn of_coordinate(layout: &Layout, name: &str) -> Option<Dimension> {
    let dimension = if layout.is_angle(name) { [0.0; 3] } else { [1.0, 0.0, 0.0] };
    layout.names_of_positions().any(|known| known == name).then_some(dimension)
}

/// `a` per `b`.
pub fn per(a: Dimension, b: Dimension) -> Dimension {
    core::array::from_fn(|i| a[i] - b[i])
}
