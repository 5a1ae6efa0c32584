//! Pages that need nothing beside themselves.

/// The style that all pages share: light and dark, and the colours of
/// [`Colour`](crate::plot::Colour) in both.
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

/// Width of charts that phones show whole, pixels.
const PHONE: u32 = 400;

/// A figure that fits its screen: drawn as it is by itself, and once more so wide as it is on
/// phones.
///
/// # Errors
/// As its drawing.
pub fn fitting<E>(draw: impl Fn(Option<u32>) -> Result<String, E>) -> Result<String, E> {
    let [desk, phone] = [draw(None)?, draw(Some(PHONE))?];
    Ok(format!("<figure class=wide><div class=desk>{desk}</div><div class=phone>{phone}</div></figure>\n"))
}

/// `text` as HTML and XML, in elements and in attributes. Characters that XML does not have are
/// replaced.
pub fn escaped(text: &str) -> String {
    let mut html = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => html.push_str("&amp;"),
            '<' => html.push_str("&lt;"),
            '>' => html.push_str("&gt;"),
            '"' => html.push_str("&quot;"),
            '\t' | '\n' | '\r' => html.push(c),
            c if c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}') => {
                html.push(char::REPLACEMENT_CHARACTER)
            }
            c => html.push(c),
        }
    }
    html
}

#[cfg(test)]
mod tests {
    use super::{escaped, fitting};

    #[test]
    fn phones_have_charts_of_their_own() {
        let drawn = |width: Option<u32>| width.map_or(Err("as it is"), |width| Ok(format!("{width}")));
        assert_eq!(fitting(drawn), Err("as it is"));
        let both =
            fitting(|width| Ok::<_, ()>(width.map_or("as it is".into(), |width| format!("{width} wide"))))
                .unwrap();
        assert!(both.contains("<div class=desk>as it is</div><div class=phone>400 wide</div>"), "{both}");
    }

    #[test]
    fn what_has_a_meaning_in_html_is_written_without_it() {
        assert_eq!(
            escaped("a<b> & \"c\"\t→\u{1}\u{ffff}"),
            "a&lt;b&gt; &amp; &quot;c&quot;\t→\u{fffd}\u{fffd}"
        );
    }
}
