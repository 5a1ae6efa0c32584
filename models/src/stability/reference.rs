//! `data/stability.json`: 20 digits, by the script beside it, which knows nothing of this crate.

use std::collections::BTreeMap;
use std::sync::LazyLock;

static VALUES: LazyLock<BTreeMap<String, f64>> = LazyLock::new(|| {
    let texts: BTreeMap<String, String> =
        serde_json::from_str(include_str!("../../data/stability.json")).unwrap_or_default();
    texts.into_iter().filter_map(|(key, text)| Some((key, text.parse().ok()?))).collect()
});

/// Where the numbers of the table come from.
pub(super) const MPMATH: &str = "40-digit quadrature or Taylor series";

/// A number of the table; NaN, which nothing is near, for one that is not there.
pub(super) fn reference(key: &str) -> f64 {
    VALUES.get(key).copied().unwrap_or(f64::NAN)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_can_be_read() {
        assert_eq!(reference("zigzag.other[1]"), 0.05);
        assert!(VALUES.values().all(|value| value.is_finite()) && VALUES.len() > 60);
    }
}
