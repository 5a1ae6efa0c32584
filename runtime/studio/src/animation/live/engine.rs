//! The engine as a page has it.

use crate::html::escaped;
use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use flate2::Compression;
use flate2::write::GzEncoder;
use std::io::{self, Write};

use super::WORKER;

/// Where a page finds the engine.
#[derive(Clone, Copy, Debug)]
pub enum Engine<'a> {
    /// In itself.
    Within(&'a Packed),
    /// In a script beside it: [`Packed::script`].
    Beside(&'a str),
}

/// The engine as text: WebAssembly by gzip by base64.
#[derive(Clone, Debug)]
pub struct Packed(String);

/// How a page with an engine in it begins that.
const ELEMENT: &str = "<script type=\"text/plain\" id=engine";

impl Packed {
    /// An engine as `liftoff-web` is compiled to it, or that of a page that has one.
    ///
    /// # Errors
    /// It is neither.
    pub fn new(content: &[u8]) -> io::Result<Self> {
        match content.starts_with(b"\0asm") {
            true => compressed(content).map(|packed| Self(STANDARD.encode(packed))),
            false => Self::of_page(content).ok_or_else(|| {
                io::Error::new(
                    io::ErrorKind::InvalidData,
                    "it is no WebAssembly, and no page with an engine in it",
                )
            }),
        }
    }

    fn of_page(content: &[u8]) -> Option<Self> {
        let page = core::str::from_utf8(content).ok()?;
        let (_, after) = page.split_once(ELEMENT)?;
        let (text, _) = after.strip_prefix('>')?.split_once("</script>")?;
        STANDARD.decode(text).ok()?.starts_with(&[0x1f, 0x8b]).then(|| Self(text.to_owned()))
    }

    /// Bytes that a page grows by.
    pub fn size(&self) -> usize {
        self.0.len()
    }

    /// A script that has the engine for the pages beside it.
    pub fn script(&self) -> String {
        format!("globalThis.liftoffEngine = \"{}\";\n", self.0)
    }
}

impl Engine<'_> {
    /// The elements that the scripts find the engine and its worker in.
    pub fn html(&self) -> String {
        let engine = match self {
            Self::Within(Packed(text)) => format!("{ELEMENT}>{text}</script>"),
            Self::Beside(script) => format!("{ELEMENT} data-from=\"{}\"></script>", escaped(script)),
        };
        format!("{engine}\n<script type=\"text/plain\" id=worker>{WORKER}</script>\n")
    }
}

/// Bytes as servers send them.
///
/// # Errors
/// None that memory does not have.
pub fn compressed(bytes: &[u8]) -> io::Result<Vec<u8>> {
    let mut packed = GzEncoder::new(Vec::new(), Compression::best());
    packed.write_all(bytes)?;
    packed.finish()
}

#[cfg(test)]
mod tests {
    use super::{Engine, Packed};

    #[test]
    fn an_engine_is_found_in_a_page_that_has_it() {
        let packed = Packed::new(b"\0asm and so on").unwrap();
        let page = format!("<p>text</p>{}", Engine::Within(&packed).html());
        assert_eq!(Packed::new(page.as_bytes()).unwrap().0, packed.0);
        let beside = Engine::Beside("engine.js").html();
        for other in ["", "<p>a page</p>", "<script type=\"text/plain\" id=engine>AAAA</script>", &beside] {
            assert!(Packed::new(other.as_bytes()).is_err(), "{other}");
        }
    }
}
