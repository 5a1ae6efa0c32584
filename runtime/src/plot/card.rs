//! A drawing as a file of its own.

use super::Ink;

/// Behind the whole of the drawing.
const PAPER: [&str; 2] = ["#FBFBF9", "#1e2125"];

/// `svg` on a card behind all that it draws, for a viewer may show it on white or on black: light in print and wherever it
/// is not looked at in the dark, dark on screens that are.
pub fn on_card(svg: &str) -> String {
    let card = format!("<rect width=\"100%\" height=\"100%\" rx=\"24\" fill=\"{}\"/>", PAPER[0]);
    svg.replacen('>', &format!(">\n{}\n{card}", style()), 1)
}

/// What is drawn in the dark. Viewers that know nothing of it, LaTeX's among them, draw what is written.
fn style() -> String {
    let rule = |property: &str, from: &str, to: &str| format!("[{property}=\"{from}\"]{{{property}:{to}}}");
    let inks = Ink::ALL
        .iter()
        .flat_map(|ink| ["fill", "stroke"].map(|property| rule(property, &ink.hex(), ink.in_the_dark())));
    let papers = [PAPER[0], "#FFFFFF"].map(|paper| rule("fill", paper, PAPER[1]));
    let rules: String = inks.chain(papers).collect();
    format!("<style>@media screen and (prefers-color-scheme:dark){{{rules}}}</style>")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_card_lies_behind_the_drawing() {
        let file = on_card("<svg width=\"8\">\n<line/>\n</svg>\n");
        let [style, card, line] = ["<style>", "<rect", "<line/>"].map(|part| file.find(part).unwrap());
        assert!(style < card && card < line);
        assert!(file.contains("[stroke=\"#0072B2\"]{stroke:#56b4e9}"));
    }

    #[test]
    fn pages_and_files_have_the_same_colours_in_the_dark() {
        let page = include_str!("../html/page.css");
        for ink in Ink::ALL {
            let name = format!("{ink:?}").to_lowercase();
            assert!(page.contains(&format!("--{name}: {};", ink.in_the_dark())), "{name}");
            assert!(page.contains(&format!("svg [stroke=\"{}\"] {{ stroke: var(--{name}); }}", ink.hex())));
            assert!(page.contains(&format!("svg [fill=\"{}\"] {{ fill: var(--{name}); }}", ink.hex())));
        }
    }
}
