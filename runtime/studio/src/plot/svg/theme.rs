//! A drawing as a file of its own.

use super::Colour;

/// Behind the whole of the drawing.
const PAPER: [&str; 2] = ["#FBFBF9", "#1e2125"];

/// `svg` on a card behind all that it draws, for a viewer may show it on white or on black: light
/// in print and wherever it is not looked at in the dark, dark on screens that are.
pub fn with_theme(svg: &str) -> String {
    let card = format!("<rect width=\"100%\" height=\"100%\" rx=\"6\" fill=\"{}\"/>", PAPER[0]);
    svg.replacen('>', &format!(">\n{}\n{card}", style()), 1)
}

/// What is drawn in the dark. Viewers that know nothing of it, LaTeX's among them, draw what is
/// written.
fn style() -> String {
    let rule = |property: &str, from: &str, to: &str| format!("[{property}=\"{from}\"]{{{property}:{to}}}");
    let colours = Colour::ALL.iter().flat_map(|colour| {
        ["fill", "stroke"].map(|property| rule(property, &colour.hex(), colour.in_the_dark()))
    });
    let papers = [PAPER[0], "#FFFFFF"].map(|paper| rule("fill", paper, PAPER[1]));
    let rules: String = colours.chain(papers).collect();
    format!("<style>@media screen and (prefers-color-scheme:dark){{{rules}}}</style>")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plot::svg::Svg;

    /// A model's summary describes its drawing.
    #[test]
    fn the_card_lies_behind_whatever_the_description_is() {
        let file = with_theme(&Svg::default().finished("x > y, <z>", [8.0, 8.0]));
        let head = &file[..file.find("<style>").unwrap()];
        assert!(head.ends_with("font-family=\"sans-serif\">\n"), "{head}");
        assert!(head.contains("aria-label=\"x &gt; y, &lt;z&gt;\""), "{head}");
    }

    #[test]
    fn the_card_lies_behind_the_drawing() {
        let file = with_theme("<svg width=\"8\">\n<line/>\n</svg>\n");
        let [style, card, line] = ["<style>", "<rect", "<line/>"].map(|part| file.find(part).unwrap());
        assert!(style < card && card < line);
        assert!(file.contains("[stroke=\"#0072B2\"]{stroke:#56b4e9}"));
    }

    #[test]
    fn pages_and_files_have_the_same_colours_in_the_dark() {
        let page = include_str!("../../html/page.css");
        for colour in Colour::ALL {
            let name = format!("{colour:?}").to_lowercase();
            assert!(page.contains(&format!("--{name}: {};", colour.in_the_dark())), "{name}");
            assert!(
                page.contains(&format!("svg [stroke=\"{}\"] {{ stroke: var(--{name}); }}", colour.hex()))
            );
            assert!(page.contains(&format!("svg [fill=\"{}\"] {{ fill: var(--{name}); }}", colour.hex())));
        }
    }
}
