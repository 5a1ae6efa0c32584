//! Standard output and standard error output.

use std::io::{ErrorKind, Result, Write};

/// Prints `text`; its colours only where they can be seen and are wanted. A reader that has gone away, as `head` does, is no
/// error.
pub fn print(text: &str) -> Result<()> {
    let mut out = anstream::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(()),
        done => done,
    }
}

/// Tells `text` on the standard error output. Where that cannot be written nothing can be told, and the exit code says
/// what there is to say.
pub fn tell(text: &str) {
    let mut out = anstream::stderr().lock();
    let _ = writeln!(out, "{text}").and_then(|()| out.flush());
}
