//! What every page must satisfy, whatever it shows.

use crate::{Browser, BrowserError, Screen};
use std::path::Path;

/// Loads a page on a desk and on a phone, by day and by night: it complains of nothing, asks for
/// nothing but itself, is not wider than its screen, its text stands out from its ground, its
/// pictures' letters are no dots, and verdicts are in sight.
///
/// # Errors
/// The first of these that does not hold; as every command.
pub fn check(browser: &Browser, file: &Path) -> Result<(), BrowserError> {
    for screen in [Screen::Desk, Screen::Phone] {
        for scheme in ["light", "dark"] {
            browser.screen(screen)?;
            browser.prefer(&[("prefers-color-scheme", scheme), ("prefers-reduced-motion", "reduce")])?;
            browser.load(file)?;
            let wrong = |what: String| {
                BrowserError::Page(format!("{} on a {screen:?}, {scheme}: {what}", file.display()))
            };
            quiet(browser)?.map_or(Ok(()), |what| Err(wrong(what)))?;
            narrow(browser)?.map_or(Ok(()), |what| Err(wrong(what)))?;
            legible(browser, scheme)?.map_or(Ok(()), |what| Err(wrong(what)))?;
            large(browser)?.map_or(Ok(()), |what| Err(wrong(what)))?;
            in_sight(browser)?.map_or(Ok(()), |what| Err(wrong(what)))?;
        }
    }
    Ok(())
}

/// What a page logs or asks the network for.
fn quiet(browser: &Browser) -> Result<Option<String>, BrowserError> {
    if let Some(complaint) = browser.complaints()?.first() {
        return Ok(Some(complaint.clone()));
    }
    let own = |address: &String| ["file:", "data:", "blob:"].iter().any(|own| address.starts_with(own));
    let foreign = browser.requests()?.into_iter().find(|address| !own(address));
    Ok(foreign.map(|address| format!("it asks for {address}")))
}

/// How much wider than its screen a page is, and where.
fn narrow(browser: &Browser) -> Result<Option<String>, BrowserError> {
    let excess =
        browser.number("document.documentElement.scrollWidth - document.documentElement.clientWidth")?;
    if excess <= 0.0 {
        return Ok(None);
    }
    let culprit = browser.text(
        "(() => { const wide = document.documentElement.clientWidth;
          const all = [...document.querySelectorAll('body *')].filter((node) => node.getBoundingClientRect().right > wide + 1);
          return all.slice(0, 3).map((node) => `${node.tagName}.${node.className.baseVal ?? node.className}`).join(', '); })()",
    )?;
    Ok(Some(format!("{excess} pixels too wide: {culprit}")))
}

/// Whether the text has a contrast of less than 7 to its ground (WCAG's AAA), or the scheme is not
/// followed.
fn legible(browser: &Browser, scheme: &str) -> Result<Option<String>, BrowserError> {
    let luminance = |property: &str| {
        browser.number(&format!(
            "(() => {{ const rgb = getComputedStyle(document.body).{property}.match(/[\\d.]+/g).slice(0, 3);
              const linear = rgb.map((c) => (c / 255 <= 0.04045 ? c / 255 / 12.92 : ((c / 255 + 0.055) / 1.055) ** 2.4));
              return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]; }})()"
        ))
    };
    let (text, ground) = (luminance("color")?, luminance("backgroundColor")?);
    let contrast = (text.max(ground) + 0.05) / (text.min(ground) + 0.05);
    Ok(match (contrast >= 7.0, (ground < text) == (scheme == "dark")) {
        (false, _) => Some(format!("text stands out by {contrast:.1} only")),
        (_, false) => Some("the colours are those of the other scheme".to_owned()),
        _ => None,
    })
}

/// Letters of pictures smaller than this cannot be read, pixels.
const SMALLEST: f64 = 6.0;

/// The smallest letters of the pictures that it shows, if they are too small.
fn large(browser: &Browser) -> Result<Option<String>, BrowserError> {
    let size = browser.number(
        "Math.min(Infinity, ...[...document.querySelectorAll('figure svg text')].filter((text) => text.getClientRects().length).map((text) => {
          const svg = text.ownerSVGElement, wide = svg.viewBox.baseVal.width;
          return parseFloat(getComputedStyle(text).fontSize) * svg.getBoundingClientRect().width / wide; }))",
    )?;
    Ok((size < SMALLEST).then(|| format!("letters of {size:.1} pixels")))
}

/// The first verdict of a table that one has to scroll for.
fn in_sight(browser: &Browser) -> Result<Option<String>, BrowserError> {
    let hidden = browser.text(
        "[...document.querySelectorAll('.cases td')].find((cell) => cell.getBoundingClientRect().right
          > document.documentElement.clientWidth)?.textContent ?? ''",
    )?;
    Ok((!hidden.is_empty()).then(|| format!("`{hidden}` is out of sight")))
}
