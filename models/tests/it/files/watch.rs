//! A page that follows a file, and a project that begins with one.

use std::fs;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::Duration;

struct Watched {
    program: Child,
    address: String,
    file: PathBuf,
}

impl Drop for Watched {
    fn drop(&mut self) {
        self.program.kill().expect("it runs until it is stopped");
        self.program.wait().expect("stopped");
    }
}

impl Watched {
    fn begin() -> Self {
        let file = Path::new(env!("CARGO_TARGET_TMPDIR")).join("watched.rs");
        fs::copy(super::file("swing.rs"), &file).expect("copied");
        let mut program = Command::new(env!("CARGO_BIN_EXE_liftoff"))
            .args(["watch".as_ref(), file.as_os_str()])
            .stdout(Stdio::piped())
            .spawn()
            .expect("the command starts");
        let mut line = String::new();
        BufReader::new(program.stdout.take().expect("piped")).read_line(&mut line).expect("an address");
        let address = line.trim().trim_start_matches("http://").trim_end_matches('/').to_owned();
        Self { program, address, file }
    }

    fn get(&self, path: &str, host: &str) -> String {
        let mut stream = TcpStream::connect(&self.address).expect("it listens");
        write!(stream, "GET {path} HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\n\r\n").expect("asked");
        let mut answer = String::new();
        stream.read_to_string(&mut answer).expect("answered");
        answer
    }

    /// The page once it has this text.
    fn page_with(&self, text: &str) -> String {
        for _ in 0..600 {
            let page = self.get("/", &self.address);
            if page.contains(text) {
                return page;
            }
            sleep(Duration::from_millis(50));
        }
        panic!("`{text}` is not shown: {}", self.get("/", &self.address));
    }

    fn save(&self, from: &str, to: &str) {
        let text = fs::read_to_string(super::file("swing.rs")).expect("read");
        fs::write(&self.file, text.replace(from, to)).expect("saved");
    }
}

#[test]
fn a_page_follows_every_save_and_shows_mistakes_over_the_last_motion() {
    let watched = Watched::begin();
    assert!(watched.page_with("l = 0.5").contains("id=motion"));
    let number = |answer: String| answer.lines().last().expect("a body").to_owned();
    let first = number(watched.get("/number", &watched.address));
    watched.save("length = l)", "length = k)");
    let page = watched.page_with("id=mistakes");
    assert!(page.contains("watched.rs:4:") && page.contains("id=motion"), "{page}");
    assert_ne!(number(watched.get("/number", &watched.address)), first);
    watched.save("#[value = 0.5]", "#[value = 0.75]");
    assert!(!watched.page_with("l = 0.75").contains("id=mistakes"));
    assert!(watched.get("/", "evil.example").starts_with("HTTP/1.1 404"));
    assert!(watched.get("/other", &watched.address).starts_with("HTTP/1.1 404"));
    let local = watched.address.replace("127.0.0.1", "localhost");
    assert!(watched.get("/?panel=1", &local).starts_with("HTTP/1.1 200"));
    fs::write(&watched.file, [0xff, 0xfe]).expect("saved");
    watched.page_with("it is no text in UTF-8");
    fs::File::create(&watched.file).and_then(|file| file.set_len(1 << 40)).expect("a file with a hole");
    watched.page_with("it has more than 16777216 bytes");
}

#[test]
fn a_new_project_has_a_model_that_runs() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("crane");
    let _ = fs::remove_dir_all(&folder);
    let sources = Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("the workspace");
    let new = ["new", "crane", "--liftoff", sources.to_str().expect("UTF-8")];
    assert!(super::liftoff(&new).status.success());
    let run = super::liftoff(&["run", "crane/src/main.rs"]);
    assert!(String::from_utf8_lossy(&run.stdout).contains("stop at t = 10.00"), "{run:?}");
    let again = super::liftoff(&new);
    assert!(again.status.code() == Some(2), "{again:?}");
    for name in ["9lives", "a b", "..", "-x", "examples", "liftoff_cli"] {
        assert_eq!(super::liftoff(&["new", "--", name]).status.code(), Some(2), "{name}");
    }
    let manifest = Command::new(env!("CARGO"))
        .args(["read-manifest", "--manifest-path"])
        .arg(folder.join("Cargo.toml"))
        .output()
        .expect("cargo runs");
    assert!(manifest.status.success(), "{}", String::from_utf8_lossy(&manifest.stderr));
}
