//! Files that are there, not there, links, devices, and writers that fail.

use super::{probe, read_file, read_text, remove_left, replace, write};
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// A folder of a test's own, gone with it.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let path = std::env::temp_dir().join(format!("liftoff-file-{}-{name}", std::process::id()));
        let _ = fs::remove_dir_all(&path);
        fs::create_dir_all(&path).expect("a folder");
        Self(path)
    }

    fn file(&self, name: &str) -> PathBuf {
        self.0.join(name)
    }

    fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(&self.0).expect("a folder").flatten();
        let mut names: Vec<_> =
            entries.map(|entry| entry.file_name().to_string_lossy().into_owned()).collect();
        names.sort();
        names
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

/// A disk that fills up after some of it is written.
fn full(out: &mut (dyn Write + Send)) -> io::Result<()> {
    out.write_all(&[b'x'; 100_000])?;
    Err(io::ErrorKind::StorageFull.into())
}

#[test]
fn a_file_is_there_whole_or_as_it_was() {
    let folder = Folder::new("whole");
    let path = folder.file("a.csv");
    assert!(replace(&path, full).is_err());
    assert!(folder.names().is_empty());
    write(&path, "first").unwrap();
    assert!(replace(&path, full).is_err());
    assert_eq!(
        (fs::read_to_string(&path).unwrap().as_str(), folder.names()),
        ("first", vec!["a.csv".into()])
    );
    write(&path, "second").unwrap();
    assert_eq!(
        (fs::read_to_string(&path).unwrap().as_str(), folder.names()),
        ("second", vec!["a.csv".into()])
    );
}

#[test]
fn unwritable_files_leave_no_trace() {
    let folder = Folder::new("refused");
    let path = folder.file("a.csv");
    probe(&path).unwrap();
    assert!(folder.names().is_empty());
    write(&path, "first").unwrap();
    for nowhere in
        [folder.0.clone(), folder.file("a.csv/b.csv"), folder.file("a.csv/none/b.csv"), PathBuf::new()]
    {
        assert!(write(&nowhere, "second").is_err() && probe(&nowhere).is_err(), "{}", nowhere.display());
    }
    assert_eq!(
        (fs::read_to_string(&path).unwrap().as_str(), folder.names()),
        ("first", vec!["a.csv".into()])
    );
}

#[test]
fn folders_are_made_and_go_with_what_fails() {
    let folder = Folder::new("folders");
    let path = folder.file("deep/deeper/a.csv");
    probe(&path).unwrap();
    assert!(folder.names().is_empty());
    assert!(replace(&path, full).is_err());
    assert!(folder.names().is_empty());
    write(&path, "first").unwrap();
    assert_eq!(fs::read_to_string(&path).unwrap(), "first");
    assert!(replace(&path, full).is_err());
    assert_eq!(fs::read_to_string(&path).unwrap(), "first");
}

#[cfg(unix)]
#[test]
fn of_a_link_the_file_is_replaced() {
    use std::os::unix::fs::symlink;
    let folder = Folder::new("links");
    fs::create_dir(folder.file("deep")).unwrap();
    for (link, target) in [("a", "deep/b"), ("deep/b", "c")] {
        symlink(target, folder.file(link)).unwrap();
    }
    // The last link names a file that is not there yet.
    for text in ["first", "second"] {
        probe(&folder.file("a")).unwrap();
        write(&folder.file("a"), text).unwrap();
        assert_eq!(fs::read_to_string(folder.file("deep/c")).unwrap(), text);
    }
    assert!(fs::symlink_metadata(folder.file("a")).unwrap().is_symlink());
    assert!(replace(&folder.file("a"), full).is_err());
    assert_eq!(fs::read_to_string(folder.file("deep/c")).unwrap(), "second");
    symlink("round", folder.file("round")).unwrap();
    assert!(write(&folder.file("round"), "").is_err());
}

#[cfg(unix)]
#[test]
fn permissions_are_kept() {
    use std::os::unix::fs::PermissionsExt;
    let folder = Folder::new("permissions");
    let path = folder.file("a.csv");
    write(&path, "first").unwrap();
    let mode = || fs::metadata(&path).unwrap().permissions().mode() & 0o777;
    fs::write(folder.file("plain"), "").unwrap();
    assert_eq!(mode(), fs::metadata(folder.file("plain")).unwrap().permissions().mode() & 0o777);
    fs::set_permissions(&path, fs::Permissions::from_mode(0o640)).unwrap();
    write(&path, "second").unwrap();
    assert_eq!(mode(), 0o640);
}

/// What may not be written is neither replaced nor made; nothing stops a superuser.
#[cfg(unix)]
#[test]
fn protected_files_stay() {
    use std::os::unix::fs::PermissionsExt;
    let folder = Folder::new("protected");
    let path = folder.file("a.csv");
    write(&path, "first").unwrap();
    fs::set_permissions(&path, fs::Permissions::from_mode(0o444)).unwrap();
    if fs::OpenOptions::new().write(true).open(&path).is_ok() {
        return;
    }
    assert!(write(&path, "second").is_err());
    fs::set_permissions(&folder.0, fs::Permissions::from_mode(0o555)).unwrap();
    assert!(write(&folder.file("b.csv"), "second").is_err() && probe(&folder.file("b.csv")).is_err());
    fs::set_permissions(&folder.0, fs::Permissions::from_mode(0o755)).unwrap();
    assert_eq!(
        (fs::read_to_string(&path).unwrap().as_str(), folder.names()),
        ("first", vec!["a.csv".into()])
    );
}

#[cfg(target_os = "linux")]
#[test]
fn devices_and_pipes_are_written_to() {
    use std::io::Read;
    use std::os::unix::fs::FileTypeExt;
    use std::process::Command;
    let folder = Folder::new("pipes");
    write(Path::new("/dev/null"), "x").unwrap();
    assert!(fs::metadata("/dev/null").unwrap().file_type().is_char_device());
    let error = write(Path::new("/dev/full"), "x").unwrap_err();
    assert_eq!(error.kind(), io::ErrorKind::StorageFull);
    let pipe = folder.file("pipe");
    assert!(Command::new("mkfifo").arg(&pipe).status().unwrap().success());
    // A link to a pipe is a pipe too.
    std::os::unix::fs::symlink("pipe", folder.file("link")).unwrap();
    let reader = std::thread::spawn({
        let pipe = pipe.clone();
        move || {
            let mut text = String::new();
            fs::File::open(pipe).and_then(|mut file| file.read_to_string(&mut text)).map(|_| text)
        }
    });
    write(&folder.file("link"), "through").unwrap();
    assert_eq!(reader.join().unwrap().unwrap(), "through");
    assert!(fs::metadata(&pipe).unwrap().file_type().is_fifo());
}

#[test]
fn file_sizes_are_bounded() {
    let folder = Folder::new("read");
    let path = folder.file("a.txt");
    write(&path, "12345").unwrap();
    assert_eq!(read_text(&path, 5).unwrap(), "12345");
    assert_eq!(read_file(&path, 4).unwrap_err().to_string(), "it has more than 4 bytes");
    write(&path, [0xff, 0xfe]).unwrap();
    assert_eq!(read_text(&path, 5).unwrap_err().to_string(), "it is no text in UTF-8");
    if Path::new("/dev/zero").exists() {
        assert!(read_file(Path::new("/dev/zero"), 1000).is_err());
    }
}

#[cfg(unix)]
#[test]
fn the_owner_stays() {
    use std::os::unix::fs::{MetadataExt, chown};
    let folder = Folder::new("owner");
    let path = folder.file("a.csv");
    write(&path, "first").unwrap();
    // Only a superuser gives files away.
    if chown(&path, Some(12), Some(34)).is_ok() {
        write(&path, "second").unwrap();
        let now = fs::metadata(&path).unwrap();
        assert_eq!((now.uid(), now.gid()), (12, 34));
    }
}

/// What a killed program has left goes, and nothing that only looks like it.
#[test]
fn leftover_files_are_removed() {
    let folder = Folder::new("left");
    let others = [".a.csv.mine.tmp", ".b.csv.77-0.tmp", "a.csv", "a.csv.77-0.tmp"];
    for name in others.into_iter().chain([".a.csv.77-0.tmp", ".a.csv.12345-999.tmp"]) {
        fs::write(folder.file(name), "").expect("a file");
    }
    remove_left(&folder.file("a.csv")).expect("removed");
    assert_eq!(folder.names(), others);
    assert!(remove_left(&folder.file("nowhere/a.csv")).is_err());
}
