//! Names of platforms as FMI has them, and of the shared library on them.

use std::env::consts::{ARCH, DLL_PREFIX, DLL_SUFFIX, OS};
use std::path::PathBuf;

/// What every library of this version contains, so that no other file is packed.
pub const LIBRARY: &str = concat!("liftoff functional mock-up unit ", env!("CARGO_PKG_VERSION"));

/// The folder of binaries for the platform of this program: `x86_64-linux`.
pub(crate) fn platform() -> String {
    let system = if OS == "macos" { "darwin" } else { OS };
    format!("{ARCH}-{system}")
}

/// The file of the binary of a model.
pub(crate) fn binary(identifier: &str) -> String {
    format!("{identifier}{DLL_SUFFIX}")
}

/// Where the library lies if it was built with this program: beside it, or beside its folder, as
/// that of examples.
pub fn library_beside_program() -> PathBuf {
    let name = format!("{DLL_PREFIX}liftoff_fmi{DLL_SUFFIX}");
    let program = std::env::current_exe().unwrap_or_default();
    let mut folders = program.ancestors().skip(1).take(2).map(|folder| folder.join(&name));
    let beside = folders.clone().next().unwrap_or_else(|| PathBuf::from(&name));
    folders.find(|library| library.exists()).unwrap_or(beside)
}
