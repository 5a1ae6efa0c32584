//! Standard output and standard error output.

use std::io::{ErrorKind, Result, Write};

/// Prints `text`; its colours only where they can be seen and are wanted. A reader that has gone away, as `head` does, is no
/// error.
pub fn print(text: &str) -> Result<()> {
    // Looking for what is to be stripped takes ten times as long as making a table.
    let written = match text.contains('\u{1b}') {
        true => write_to(anstream::stdout().lock(), text),
        false => write_to(std::io::stdout().lock(), text),
    };
    match written {
        Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(()),
        done => done,
    }
}

fn write_to(mut out: impl Write, text: &str) -> Result<()> {
    out.write_all(text.as_bytes())?;
    out.flush()
}

/// Tells `text` on the standard error output. Where that cannot be written nothing can be told, and the exit code says
/// what there is to say.
pub fn tell(text: &str) {
    let mut out = anstream::stderr().lock();
    let _ = writeln!(out, "{text}").and_then(|()| out.flush());
}
