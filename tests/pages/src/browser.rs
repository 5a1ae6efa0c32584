//! A window with one page.

use crate::BrowserError;
use crate::driver::Driver;
use serde_json::{Value, json};
use std::path::Path;
use std::time::{Duration, Instant};

/// How long a page may take to do what it is waited for.
const PATIENCE: Duration = Duration::from_secs(10);

/// A browser with a session of its own; it closes with this value.
pub struct Browser {
    driver: Driver,
    agent: ureq::Agent,
    session: String,
    /// Where its profile lies while it runs.
    _profile: tempfile::TempDir,
}

/// What a page is shown on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Screen {
    /// A wide window.
    Desk,
    /// A phone, with a screen to touch.
    Phone,
}

impl Browser {
    /// Opens an empty window.
    ///
    /// # Errors
    /// Chromium or ChromeDriver are not there, or do not start.
    pub fn open() -> Result<Self, BrowserError> {
        let driver = Driver::start()?;
        let config = ureq::Agent::config_builder().http_status_as_error(false);
        let agent = config.timeout_global(Some(Duration::from_secs(60))).build().new_agent();
        let profile = tempfile::tempdir().map_err(|error| BrowserError::Start(error.to_string()))?;
        let mut browser = Self { driver, agent, session: String::new(), _profile: profile };
        let capabilities = capabilities(browser._profile.path());
        let answer = browser.post("/session", &json!({ "capabilities": { "alwaysMatch": capabilities } }))?;
        browser.session = format!("/session/{}", answer["sessionId"].as_str().unwrap_or_default());
        // Keys go to a page that has the focus, whatever else the machine shows.
        browser.devtools("Emulation.setFocusEmulationEnabled", &json!({ "enabled": true }))?;
        Ok(browser)
    }

    /// Shows pages on this screen from now on.
    ///
    /// # Errors
    /// As every command: the browser refuses, or is gone.
    pub fn screen(&self, screen: Screen) -> Result<(), BrowserError> {
        let phone = screen == Screen::Phone;
        let (width, height) = if phone { (390, 844) } else { (1280, 900) };
        let metrics = json!({ "width": width, "height": height, "deviceScaleFactor": 1, "mobile": phone });
        self.devtools("Emulation.setDeviceMetricsOverride", &metrics)?;
        self.devtools("Emulation.setTouchEmulationEnabled", &json!({ "enabled": phone }))
    }

    /// Tells pages what their reader prefers: `prefers-color-scheme` and `dark`, say.
    ///
    /// # Errors
    /// As every command.
    pub fn prefer(&self, features: &[(&str, &str)]) -> Result<(), BrowserError> {
        let features: Vec<_> =
            features.iter().map(|(name, value)| json!({ "name": name, "value": value })).collect();
        self.devtools("Emulation.setEmulatedMedia", &json!({ "features": features }))
    }

    /// Loads a file; what pages before it have logged and asked for is forgotten.
    ///
    /// # Errors
    /// As every command; the file is not there.
    pub fn load(&self, file: &Path) -> Result<(), BrowserError> {
        let file = file.canonicalize();
        let file = file.map_err(|error| BrowserError::Page(format!("cannot load a page: {error}")))?;
        self.command("/url", &json!({ "url": "about:blank" }))?;
        self.complaints()?;
        self.requests()?;
        self.command("/url", &json!({ "url": format!("file://{}", file.display()) })).map(drop)
    }

    /// What a script's function body returns.
    ///
    /// # Errors
    /// As every command; the script throws.
    pub fn script(&self, body: &str) -> Result<Value, BrowserError> {
        self.command("/execute/sync", &json!({ "script": body, "args": [] }))
    }

    /// Waits until a script's expression is true.
    ///
    /// # Errors
    /// It is not for ten seconds; as every command.
    pub fn wait(&self, expression: &str) -> Result<(), BrowserError> {
        let start = Instant::now();
        while start.elapsed() < PATIENCE {
            if self.script(&format!("return Boolean({expression})"))? == true {
                return Ok(());
            }
            std::thread::sleep(Duration::from_millis(20));
        }
        Err(BrowserError::Page(format!("waited in vain for {expression}")))
    }

    /// A number that a script's expression gives; not a number for anything else.
    ///
    /// # Errors
    /// As every command.
    pub fn number(&self, expression: &str) -> Result<f64, BrowserError> {
        // As text, for not every reader of JSON keeps the last digit.
        Ok(self.text(&format!("Number({expression})"))?.parse().unwrap_or(f64::NAN))
    }

    /// The text that a script's expression gives.
    ///
    /// # Errors
    /// As every command.
    pub fn text(&self, expression: &str) -> Result<String, BrowserError> {
        Ok(self.script(&format!("return String({expression})"))?.as_str().unwrap_or_default().to_owned())
    }

    /// What the page has logged since the last call: errors of scripts and of loading.
    ///
    /// # Errors
    /// As every command.
    pub fn complaints(&self) -> Result<Vec<String>, BrowserError> {
        let entries = self.command("/se/log", &json!({ "type": "browser" }))?;
        let entries = entries.as_array().cloned().unwrap_or_default();
        Ok(entries.iter().map(|entry| entry["message"].as_str().unwrap_or_default().to_owned()).collect())
    }

    /// Addresses that pages from files have asked for since the last call; the browser's own first
    /// page asks for much.
    ///
    /// # Errors
    /// As every command.
    pub fn requests(&self) -> Result<Vec<String>, BrowserError> {
        let entries = self.command("/se/log", &json!({ "type": "performance" }))?;
        let entries = entries.as_array().cloned().unwrap_or_default();
        let address = |entry: &Value| {
            let message: Value = serde_json::from_str(entry["message"].as_str()?).ok()?;
            let message = &message["message"];
            let page = message["params"]["documentURL"].as_str()?;
            let asked = message["method"] == "Network.requestWillBeSent" && page.starts_with("file:");
            asked.then(|| message["params"]["request"]["url"].as_str().map(str::to_owned))?
        };
        Ok(entries.iter().filter_map(address).collect())
    }

    /// A command of Chromium's own protocol.
    fn devtools(&self, command: &str, parameters: &Value) -> Result<(), BrowserError> {
        self.command("/goog/cdp/execute", &json!({ "cmd": command, "params": parameters })).map(drop)
    }

    /// A command to the session.
    pub(crate) fn command(&self, command: &str, body: &Value) -> Result<Value, BrowserError> {
        self.post(&format!("{}{command}", self.session), body)
    }

    fn post(&self, path: &str, body: &Value) -> Result<Value, BrowserError> {
        let mut answer = self.agent.post(format!("{}{path}", self.driver.address)).send_json(body)?;
        let mut told: Value = answer.body_mut().read_json()?;
        match answer.status().is_success() {
            true => Ok(told["value"].take()),
            false => Err(BrowserError::Refused { command: path.to_owned(), answer: told }),
        }
    }
}

impl Drop for Browser {
    fn drop(&mut self) {
        // Without a session there is no window to close.
        let _ = self.agent.delete(format!("{}{}", self.driver.address, self.session)).call();
    }
}

fn capabilities(profile: &Path) -> Value {
    let arguments = [
        "--headless",
        "--no-sandbox",
        "--disable-gpu",
        "--disable-dev-shm-usage",
        "--no-first-run",
        "--disable-background-networking",
        "--disable-component-update",
        "--disable-sync",
        "--force-device-scale-factor=1",
    ];
    let profile = format!("--user-data-dir={}", profile.display());
    let arguments: Vec<&str> = arguments.into_iter().chain([profile.as_str()]).collect();
    json!({
        "browserName": "chrome",
        "goog:chromeOptions": { "args": arguments },
        "goog:loggingPrefs": { "browser": "ALL", "performance": "ALL" },
    })
}
