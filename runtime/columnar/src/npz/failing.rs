//! A file that takes everything, and loses it, once it could not be written.

use std::io::{self, ErrorKind, Write};

/// An archive that is dropped unfinished writes its end all the same, and complains on the standard
/// error output where it cannot.
pub(super) struct Failing<'a> {
    out: &'a mut (dyn Write + Send),
    failed: bool,
}

impl<'a> Failing<'a> {
    pub fn new(out: &'a mut (dyn Write + Send)) -> Self {
        Self { out, failed: false }
    }
}

impl Write for Failing<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        if self.failed {
            return Ok(bytes.len());
        }
        let written = self.out.write(bytes);
        self.failed = written.as_ref().is_err_and(|error| error.kind() != ErrorKind::Interrupted);
        written
    }

    fn flush(&mut self) -> io::Result<()> {
        if self.failed { Ok(()) } else { self.out.flush() }
    }
}
