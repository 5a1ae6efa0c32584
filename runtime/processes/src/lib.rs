//! Processes that were started together and send each other messages.
//!
//! - [`Processes`]: what is asked of them.
//! - [`joined`]: those of the launcher that has started this process, `mpirun` or the like;
//!   [`follows`]: whether it is not the first.
//! - `launched`: whether there is one, by the environment.
//! - `world`: with feature `mpi`, the processes of MPI.

mod launched;
#[cfg(feature = "mpi")]
mod world;

use std::time::Duration;

/// Processes that were started together: each message arrives, and those of one sender in the order
/// in which they were sent.
pub trait Processes: Sync {
    /// The number of this process, from 0.
    fn rank(&self) -> usize;

    /// How many there are.
    fn count(&self) -> usize;

    /// How many threads this process may have, so that those that share a machine have one for each
    /// of its cores.
    fn threads(&self) -> usize;

    /// Sends a message to the process with this number.
    fn send(&self, rank: usize, message: &str);

    /// The next message and the number of its sender, if one comes within this time.
    fn receive(&self, wait: Duration) -> Option<(usize, String)>;
}

/// Why a process that was started with others cannot work with them.
#[derive(thiserror::Error, Debug, Clone, PartialEq, Eq)]
pub enum JoinError {
    /// The build has no MPI.
    #[error(
        "{variable} says that MPI has started this process with others, and this build has no MPI: each would do the whole work; \
             build with --features mpi, or start one process"
    )]
    Unsupported {
        /// The variable of the environment.
        variable: &'static str,
    },
    /// MPI cannot be called from more than one thread of a process.
    #[error("the MPI library supports only one thread per process")]
    Threads,
}

/// The processes that were started together with this one; none where it was started by itself.
///
/// # Errors
/// There are others, and this build has no MPI, or MPI does not serve threads.
pub fn joined() -> Result<Option<Box<dyn Processes>>, JoinError> {
    launched::by(&|name| std::env::var(name).ok()).map_or(Ok(None), join)
}

/// Whether this process was started with others and is not the first of them: what all of them find
/// out is told by the first.
pub fn follows() -> bool {
    launched::follows(&|name| std::env::var(name).ok())
}

#[cfg(feature = "mpi")]
fn join(_: launched::Launched) -> Result<Option<Box<dyn Processes>>, JoinError> {
    world::World::join().map(|world| Some(Box::new(world) as Box<dyn Processes>))
}

#[cfg(not(feature = "mpi"))]
fn join(launched: launched::Launched) -> Result<Option<Box<dyn Processes>>, JoinError> {
    match launched.count {
        Some(..=1) => Ok(None),
        _ => Err(JoinError::Unsupported { variable: launched.variable }),
    }
}
