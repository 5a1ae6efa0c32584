//! Notes.

use crate::output::print::tell;
use crate::output::style::{LABEL, styled};

/// Tells a note.
pub fn note(text: &str) {
    tell(&format!("{} {text}", styled(LABEL, "note:")));
}
