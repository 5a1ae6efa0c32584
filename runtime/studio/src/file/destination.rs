//! What a path names.

use std::fs;
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

/// Links that may follow one another.
const LINKS: usize = 40;

/// What a path names.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum Destination {
    /// The standard output.
    Output,
    /// The standard error output.
    Errors,
    /// A device, a pipe or a socket.
    Device(PathBuf),
    /// A file, there or not, at the end of all links.
    File(PathBuf),
}

impl Destination {
    pub(super) fn resolve(path: &Path) -> io::Result<Self> {
        if path == Path::new("-") {
            return Ok(Self::Output);
        }
        let mut path = path.to_owned();
        for _ in 0..LINKS {
            if let Some(stream) = stream(&path) {
                return Ok(stream);
            }
            match fs::symlink_metadata(&path) {
                Ok(what) if what.is_symlink() => {
                    let next = fs::read_link(&path)?;
                    path = path.parent().unwrap_or(Path::new("")).join(next);
                }
                Ok(what) if what.is_dir() => return Err(ErrorKind::IsADirectory.into()),
                Ok(what) if what.is_file() => return Ok(Self::File(path)),
                Ok(_) => return Ok(Self::Device(path)),
                Err(error) if error.kind() == ErrorKind::NotFound => return Ok(Self::File(path)),
                Err(error) => return Err(error),
            }
        }
        Err(io::Error::other("too many symbolic links"))
    }
}

/// The open files of this process, which a link of the kernel names: a new file under that name
/// would reach nobody.
fn stream(path: &Path) -> Option<Destination> {
    let folder = path.parent()?;
    let own = format!("/proc/{}/fd", std::process::id());
    let descriptors =
        ["/dev/fd", "/proc/self/fd", own.as_str()].iter().any(|known| folder == Path::new(known));
    match path.file_name()?.to_str()? {
        "stdout" if folder == Path::new("/dev") => Some(Destination::Output),
        "stderr" if folder == Path::new("/dev") => Some(Destination::Errors),
        "1" if descriptors => Some(Destination::Output),
        "2" if descriptors => Some(Destination::Errors),
        _ if descriptors => Some(Destination::Device(path.to_owned())),
        _ => None,
    }
}
