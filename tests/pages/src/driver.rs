//! The ChromeDriver process.

use crate::BrowserError;
use std::io::{BufRead, BufReader};
use std::process::{Child, Command, Stdio};

/// A running ChromeDriver; it ends with this value.
pub(crate) struct Driver {
    process: Child,
    /// Where it listens.
    pub(crate) address: String,
}

impl Driver {
    /// Starts it on a port that is free.
    pub(crate) fn start() -> Result<Self, BrowserError> {
        let failed = |error: std::io::Error| BrowserError::Start(error.to_string());
        let mut command = Command::new("chromedriver");
        command.arg("--port=0").stdout(Stdio::piped()).stderr(Stdio::null());
        let mut process = command.spawn().map_err(failed)?;
        let told = process.stdout.take().map(BufReader::new).into_iter().flat_map(BufRead::lines);
        let port = told.map_while(Result::ok).find_map(|line| port(&line));
        let mut driver = Self { process, address: String::new() };
        let port = port.ok_or_else(|| BrowserError::Start("it told no port".into()))?;
        driver.address = format!("http://127.0.0.1:{port}");
        Ok(driver)
    }
}

/// The port of `ChromeDriver was started successfully on port 41234.`
fn port(line: &str) -> Option<u16> {
    line.split_once("successfully on port ")?.1.trim_end_matches('.').parse().ok()
}

impl Drop for Driver {
    fn drop(&mut self) {
        // A process that has ended by itself is what is wanted.
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}
