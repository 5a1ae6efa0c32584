//! What is said of a whole table.

use crate::Heading;
use sha2::{Digest, Sha256};

/// Names and texts; behind those that are hashed the hash.
pub(crate) fn metadata(heading: &Heading) -> Vec<(String, String)> {
    let mut all = Vec::new();
    for entry in &heading.entries {
        all.push((entry.name.clone(), entry.text.clone()));
        if entry.is_hashed {
            let hash: String = Sha256::digest(&entry.text).iter().map(|byte| format!("{byte:02x}")).collect();
            all.push((format!("{}.sha256", entry.name), hash));
        }
    }
    all
}
