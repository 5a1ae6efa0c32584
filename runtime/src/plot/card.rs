//! A drawing as a file of its own: on a light card, for a viewer may show it on white or on black.

/// The card: the whole of the drawing, in the drawing's own units.
const CARD: &str = "<rect width=\"100%\" height=\"100%\" rx=\"24\" fill=\"#FBFBF9\"/>";

/// `svg` with a light card behind all that it draws.
pub fn on_card(svg: &str) -> String {
    svg.replacen('>', &format!(">\n{CARD}"), 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_card_lies_behind_the_drawing() {
        let file = on_card("<svg width=\"8\">\n<line/>\n</svg>\n");
        assert_eq!(file, format!("<svg width=\"8\">\n{CARD}\n<line/>\n</svg>\n"));
    }
}
