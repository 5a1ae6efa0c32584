//! Files written whole or not at all: first beside their place under another name, then renamed.
//!
//! What was there stays as it was until all is written. Devices, pipes and the standard streams are
//! written to directly; of a symbolic link the file that it names is replaced. An existing file
//! keeps its permissions, but not its hard links. Folders that are not there are made; `-` is the
//! standard output.

mod destination;
#[cfg(test)]
mod tests;

use destination::Destination;
use std::fs::{self, File, OpenOptions};
use std::io::{self, ErrorKind, Read, Write};
use std::path::{Path, PathBuf};

/// Names tried for the file beside; those taken are left from programs that were killed.
const NAMES: u32 = 1000;

/// Writes a file.
///
/// # Errors
/// It cannot be written whole; what was there is as it was.
pub fn write(path: &Path, content: impl AsRef<[u8]>) -> io::Result<()> {
    replace(path, |out| out.write_all(content.as_ref()))
}

/// Writes a file with what `content` writes.
///
/// # Errors
/// It cannot be written whole, or `content` fails; what was there is as it was.
pub fn replace(
    path: &Path,
    content: impl FnOnce(&mut (dyn Write + Send)) -> io::Result<()>,
) -> io::Result<()> {
    match Destination::resolve(path)? {
        Destination::Output => directly(&mut io::stdout(), content),
        Destination::Errors => directly(&mut io::stderr(), content),
        Destination::Device(path) => directly(&mut OpenOptions::new().write(true).open(path)?, content),
        Destination::File(path) => aside(&path, content),
    }
}

/// Reads a file, a pipe too, of no more than `most` bytes.
///
/// # Errors
/// It cannot be read, or is larger.
pub fn read_file(path: &Path, most: u64) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    File::open(path)?.take(most.saturating_add(1)).read_to_end(&mut bytes)?;
    match bytes.len() as u64 {
        length if length > most => {
            Err(io::Error::new(ErrorKind::FileTooLarge, format!("it has more than {most} bytes")))
        }
        _ => Ok(bytes),
    }
}

/// Reads a text of no more than `most` bytes.
///
/// # Errors
/// It cannot be read, is larger, or is no UTF-8.
pub fn read_text(path: &Path, most: u64) -> io::Result<String> {
    String::from_utf8(read_file(path, most)?)
        .map_err(|_| io::Error::new(ErrorKind::InvalidData, "it is no text in UTF-8"))
}

/// Tries whether a file can be written, and leaves no trace.
///
/// # Errors
/// It cannot.
pub fn probe(path: &Path) -> io::Result<()> {
    match Destination::resolve(path)? {
        Destination::File(path) => {
            writable(&path)?;
            let name = path.file_name().ok_or(ErrorKind::InvalidInput)?;
            Aside::new(&standing(folder(&path)).join(name)).map(drop)
        }
        _ => Ok(()),
    }
}

/// Removes what programs that were killed have left beside a file; for who alone may write it.
///
/// # Errors
/// The folder cannot be read, or a file not be removed.
pub fn remove_left(path: &Path) -> io::Result<()> {
    let stem = stem(path)?;
    for entry in fs::read_dir(folder(path))? {
        let entry = entry?;
        let name = entry.file_name();
        let behind = name.to_str().and_then(|name| name.strip_prefix(&stem)?.strip_suffix(".tmp"));
        if behind.is_some_and(|numbers| numbers.bytes().all(|byte| byte == b'-' || byte.is_ascii_digit())) {
            fs::remove_file(entry.path())?;
        }
    }
    Ok(())
}

/// What the names of files beside it begin with, `.a.csv.` of `a.csv`.
fn stem(path: &Path) -> io::Result<String> {
    let name = path.file_name().ok_or(ErrorKind::InvalidInput)?.to_string_lossy();
    // Names of files have 255 bytes at most.
    Ok(format!(".{}.", name.chars().take(50).collect::<String>()))
}

/// The folder of a file.
fn folder(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    }
}

/// A folder, or the first above it that is there.
fn standing(folder: &Path) -> &Path {
    let above = folder.ancestors().find(|above| !above.as_os_str().is_empty() && above.exists());
    above.unwrap_or(Path::new("."))
}

/// Folders that were made for a file; those that are still empty go with this.
struct Folders(Vec<PathBuf>);

impl Folders {
    fn made(folder: &Path) -> io::Result<Self> {
        let missing = folder.ancestors().take_while(|above| !above.as_os_str().is_empty() && !above.exists());
        let made = Self(missing.map(Path::to_owned).collect());
        fs::create_dir_all(folder)?;
        Ok(made)
    }
}

impl Drop for Folders {
    fn drop(&mut self) {
        self.0.iter().for_each(|folder| drop(fs::remove_dir(folder)));
    }
}

fn directly<W: Write + Send>(
    out: &mut W,
    content: impl FnOnce(&mut (dyn Write + Send)) -> io::Result<()>,
) -> io::Result<()> {
    content(out)?;
    out.flush()
}

fn aside(path: &Path, content: impl FnOnce(&mut (dyn Write + Send)) -> io::Result<()>) -> io::Result<()> {
    let before = writable(path)?;
    let _folders = Folders::made(folder(path))?;
    let mut aside = Aside::new(path)?;
    let mut out = io::BufWriter::new(&mut aside.file);
    content(&mut out)?;
    out.flush()?;
    drop(out);
    if let Some(before) = before {
        keep_owner(&aside.file, &before);
        aside.file.set_permissions(before.permissions())?;
    }
    aside.file.sync_all()?;
    aside.renamed(path)
}

/// Gives a new file to whom the one before belonged, as far as this process may.
#[cfg(unix)]
fn keep_owner(file: &File, before: &fs::Metadata) {
    use std::os::unix::fs::{MetadataExt, fchown};
    let _ = fchown(file, Some(before.uid()), Some(before.gid()));
}

#[cfg(not(unix))]
fn keep_owner(_: &File, _: &fs::Metadata) {}

/// What is there, which may be written.
fn writable(path: &Path) -> io::Result<Option<fs::Metadata>> {
    match OpenOptions::new().write(true).open(path) {
        Ok(file) => Ok(Some(file.metadata()?)),
        Err(error) if error.kind() == ErrorKind::NotFound => Ok(None),
        Err(error) => Err(error),
    }
}

/// A file beside the one to be written; it goes unless it is renamed.
struct Aside {
    path: PathBuf,
    file: File,
    kept: bool,
}

impl Aside {
    fn new(target: &Path) -> io::Result<Self> {
        let stem = stem(target)?;
        for number in 0..NAMES {
            let path = target.with_file_name(format!("{stem}{}-{number}.tmp", std::process::id()));
            match OpenOptions::new().write(true).create_new(true).open(&path) {
                Ok(file) => return Ok(Self { path, file, kept: false }),
                Err(error) if error.kind() == ErrorKind::AlreadyExists => {}
                Err(error) => return Err(error),
            }
        }
        Err(ErrorKind::AlreadyExists.into())
    }

    fn renamed(mut self, target: &Path) -> io::Result<()> {
        fs::rename(&self.path, target)?;
        self.kept = true;
        // The name lasts where the folder can be synchronised; the content does already.
        if let Some(folder) = target.parent() {
            let _ = File::open(folder).and_then(|folder| folder.sync_all());
        }
        Ok(())
    }
}

impl Drop for Aside {
    fn drop(&mut self) {
        if !self.kept {
            let _ = fs::remove_file(&self.path);
        }
    }
}
