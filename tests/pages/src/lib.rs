//! Pages in headless Chromium, driven through ChromeDriver by WebDriver's own protocol
//! (<https://www.w3.org/TR/webdriver2/>).
//!
//! - `driver`: the ChromeDriver process; `browser`: a window with one page; `actions`: what hands
//!   do to it;
//! - `page`: what every page must satisfy.

mod actions;
mod browser;
mod driver;
mod error;
mod page;

pub use actions::Key;
pub use browser::{Browser, Screen};
pub use error::BrowserError;
pub use page::check;
