//! Numerical methods that know no mechanics: decompositions, quadrature, roots of functions.

pub(crate) mod decomposition;
pub(crate) mod legendre;
pub(crate) mod root_isolation;
pub(crate) mod zero;
