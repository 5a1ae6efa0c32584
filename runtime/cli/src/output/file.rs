//! Files, whole or not at all.

use crate::CommandError;
use crate::output::print::{print, tell};
use liftoff_studio::file;
use liftoff_studio::plot::with_theme;
use std::path::Path;

/// What a file can be written as: the name of the form, and how names of such files end.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Form {
    name: &'static str,
    endings: &'static [&'static str],
}

impl Form {
    pub const ARROW: Self = Self { name: "Arrow", endings: &["arrow", "ipc", "feather"] };
    pub const CSV: Self = Self { name: "CSV", endings: &["csv", "txt", "dat"] };
    pub const FMU: Self = Self { name: "FMU", endings: &["fmu"] };
    pub const HTML: Self = Self { name: "HTML", endings: &["html", "htm"] };
    pub const LATEX: Self = Self { name: "LaTeX", endings: &["tex"] };
    pub const NPZ: Self = Self { name: "NPZ", endings: &["npz"] };
    pub const PARQUET: Self = Self { name: "Parquet", endings: &["parquet"] };
    pub const PYTHON: Self = Self { name: "Python", endings: &["py"] };
    pub const SVG: Self = Self { name: "SVG", endings: &["svg"] };
    pub const TEXT: Self = Self { name: "text", endings: &["txt", "md"] };

    /// That of a name's ending, if it is one of these.
    pub fn find(path: &Path, forms: &[Self]) -> Option<Self> {
        let ending = find_ending(path)?;
        forms.iter().find(|form| form.endings.contains(&ending.as_str())).copied()
    }
}

/// Endings of files, which are no folders.
const FILES: [&str; 19] = [
    "html", "svg", "csv", "txt", "json", "png", "jpg", "jpeg", "gif", "webp", "apng", "mp4", "webm", "mov",
    "avi", "pdf", "eps", "c", "zip",
];

/// Bytes of a picture that no viewer shows in reasonable time.
const LARGEST: usize = 64 << 20;

/// Writes a file.
pub fn write(path: &Path, content: impl AsRef<[u8]>) -> Result<(), CommandError> {
    file::write(path, content).map_err(|error| unwritable(path, &error))
}

/// Whether this is the standard output.
pub fn is_output(path: &Path) -> bool {
    path == Path::new("-")
}

/// Prints what goes with a file; where that is the standard output, on the standard error output.
pub fn print_beside(path: Option<&Path>, text: &str) -> Result<(), CommandError> {
    match path.is_some_and(is_output) {
        true => tell(text.trim_end()),
        false => print(text)?,
    }
    Ok(())
}

/// Tells where to find a file that has been written.
pub fn tell_written(path: &Path) {
    if !is_output(path) && !path.starts_with("/dev") {
        tell(&format!("{} written", path.display()));
    }
}

/// Refuses names of files of other forms than these, and files that cannot be written.
pub fn probe_as(path: &Path, forms: &[Form]) -> Result<(), CommandError> {
    check_form(path, forms).and_then(|()| probe(path))
}

/// Refuses names of files of other forms than these. Names without an ending are allowed.
pub fn check_form(path: &Path, forms: &[Form]) -> Result<(), CommandError> {
    match find_ending(path).filter(|_| Form::find(path, forms).is_none()) {
        Some(ending) => {
            let names: Vec<&str> = forms.iter().map(|form| form.name).collect();
            let others = forms.iter().map(|form| path.with_extension(form.endings[0]).display().to_string());
            let converted = match forms.contains(&Form::SVG) {
                true => ", which browsers show and Inkscape or rsvg-convert turn into others",
                false => "",
            };
            Err(CommandError::Usage(format!(
                "{}: this is written as {}, not as {}; name the file {}{converted}",
                path.display(),
                names.join(" or "),
                ending.to_uppercase(),
                others.collect::<Vec<_>>().join(" or "),
            )))
        }
        None => Ok(()),
    }
}

/// Refuses the name of a file where a folder is to be.
///
/// # Errors
/// The name ends as that of a file.
pub fn check_folder(path: &Path) -> Result<(), CommandError> {
    match find_ending(path).filter(|ending| FILES.contains(&ending.as_str())) {
        Some(_) if !path.is_dir() => Err(CommandError::Usage(format!(
            "{}: a folder is written, not a file; name it {}",
            path.display(),
            path.with_extension("").display(),
        ))),
        _ => Ok(()),
    }
}

/// How the name of a file ends, in lower case.
fn find_ending(path: &Path) -> Option<String> {
    Some(path.extension()?.to_string_lossy().to_lowercase())
}

/// Writes an SVG on a card of its own; one that is too large to be shown is refused.
pub fn write_picture(path: &Path, svg: &str) -> Result<(), CommandError> {
    match svg.len() {
        0..=LARGEST => write(path, with_theme(svg)),
        size => Err(CommandError::Failed(format!(
            "{} would have {} MB, and {} are the most: draw a shorter run or less of it",
            path.display(),
            size >> 20,
            LARGEST >> 20,
        ))),
    }
}

/// Tries whether a file can be written, before anything is computed for it.
fn probe(path: &Path) -> Result<(), CommandError> {
    file::probe(path).map_err(|error| unwritable(path, &error))
}

/// What keeps a file from being written.
pub fn unwritable(path: &Path, error: &impl std::fmt::Display) -> CommandError {
    CommandError::Failed(format!("cannot write {}: {error}", path.display()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn other_forms_are_refused() {
        let told = probe_as(Path::new("a/b.PNG"), &[Form::SVG]).unwrap_err();
        assert_eq!(told.code(), 2);
        assert!(told.to_string().contains("not as PNG; name the file a/b.svg, "), "{told}");
        let told = probe_as(Path::new("b.mp4"), &[Form::HTML, Form::SVG]).unwrap_err().to_string();
        assert!(told.contains("as HTML or SVG, not as MP4; name the file b.html or b.svg, "), "{told}");
        for allowed in ["b.svg", "b.SVG", "b", "/dev/null", "-"] {
            probe_as(&std::env::temp_dir().join(allowed), &[Form::SVG]).unwrap();
        }
        let told = check_folder(Path::new("a/b.gif")).unwrap_err().to_string();
        assert_eq!(told, "a/b.gif: a folder is written, not a file; name it a/b");
        check_folder(Path::new("pages-1.2")).unwrap();
    }

    #[test]
    fn a_picture_that_nothing_shows_is_refused() {
        let path = Path::new("/nowhere/large.svg");
        let told = write_picture(path, &" ".repeat(LARGEST + (3 << 20))).unwrap_err().to_string();
        assert_eq!(
            told,
            "/nowhere/large.svg would have 67 MB, and 64 are the most: draw a shorter run or less of it"
        );
    }
}
