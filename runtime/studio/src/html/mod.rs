//! Pages that need nothing beside themselves.

/// The style that all pages share: light and dark, and the colours of [`Colour`](crate::plot::Colour) in both.
const STYLE: &str = include_str!("page.css");

/// A page: `style` is added to the shared one, `body` is HTML.
pub fn page(title: &str, style: &str, body: &str) -> String {
    format!(
        "<!doctype html>\n<html lang=en>\n<meta charset=utf-8>\n\
         <meta name=viewport content=\"width=device-width, initial-scale=1\">\n\
         <title>{title}</title>\n<style>\n{STYLE}{style}</style>\n<body>\n{body}</body>\n</html>\n",
        title = escaped(title),
    )
}

/// `text` as HTML.
pub fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;")
}
