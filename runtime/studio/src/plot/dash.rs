//! Lines that are told apart where colours are not.

use super::Colour;
use super::figure::{Drawn, px};
use plotters::style::ShapeStyle;

/// Dashes of a line.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Dash {
    /// None.
    #[default]
    Solid,
    /// As long as the gaps.
    Dashed,
    /// Dots.
    Dotted,
    /// Long with short gaps.
    Long,
    /// Short with long gaps.
    Sparse,
}

impl Dash {
    /// Length of a dash and of a gap, pixels; none of a solid line.
    pub(super) fn lengths(self) -> Option<[u32; 2]> {
        match self {
            Self::Solid => None,
            Self::Dashed => Some([7, 5]),
            Self::Dotted => Some([2, 4]),
            Self::Long => Some([15, 5]),
            Self::Sparse => Some([6, 11]),
        }
    }

    /// The colour and the dashes of the curve of this number: no two of the first thirty are alike, and in grey print
    /// the first five are told apart by their dashes.
    pub fn of(number: usize) -> (Colour, Self) {
        const COLOURS: [Colour; 6] =
            [Colour::Blue, Colour::Vermilion, Colour::Green, Colour::Purple, Colour::Sky, Colour::Orange];
        const DASHES: [Dash; 5] = [Dash::Solid, Dash::Dashed, Dash::Dotted, Dash::Long, Dash::Sparse];
        (COLOURS[number % COLOURS.len()], DASHES[number % DASHES.len()])
    }
}

/// The dashes of a line in drawn units; a dash bends where the line does.
fn pieces(points: &[(i32, i32)], dash: Dash) -> Vec<Vec<(i32, i32)>> {
    let Some(lengths) = dash.lengths() else { return vec![points.to_vec()] };
    let lengths = lengths.map(|length| f64::from(px(length)));
    let mut pieces = vec![points.first().copied().into_iter().collect::<Vec<_>>()];
    let (mut turn, mut left) = (0, lengths[0]);
    for pair in points.windows(2) {
        let [a, b] = [pair[0], pair[1]].map(|(x, y)| [f64::from(x), f64::from(y)]);
        let all = (b[0] - a[0]).hypot(b[1] - a[1]);
        let mut done = 0.0;
        while all - done > left {
            done += left;
            let at = [0, 1].map(|i| (a[i] + (b[i] - a[i]) * done / all).round() as i32);
            match turn {
                0 => pieces.last_mut().into_iter().for_each(|piece| piece.push((at[0], at[1]))),
                _ => pieces.push(vec![(at[0], at[1])]),
            }
            turn = 1 - turn;
            left = lengths[turn];
        }
        left -= all - done;
        if turn == 0 {
            pieces.last_mut().into_iter().for_each(|piece| piece.push(pair[1]));
        }
    }
    pieces.retain(|piece| piece.len() > 1);
    pieces
}

/// Draws a line on an area in its own units.
pub(super) fn line(
    area: &super::figure::Area,
    points: &[(i32, i32)],
    dash: Dash,
    style: ShapeStyle,
) -> Drawn {
    for piece in pieces(points, dash) {
        area.draw(&plotters::element::PathElement::new(piece, style))?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dashes_cover_their_share_and_keep_corners() {
        let line = [(0, 0), (px(100) as i32, 0), (px(100) as i32, px(20) as i32)];
        assert_eq!(pieces(&line, Dash::Solid), [line.to_vec()]);
        let dashes = pieces(&line, Dash::Dashed);
        assert_eq!(dashes.len(), 10);
        assert_eq!(dashes[0], [(0, 0), (px(7) as i32, 0)]);
        assert!(dashes.iter().any(|piece| piece.contains(&line[1]) && piece.len() == 3), "{dashes:?}");
    }

    #[test]
    fn no_two_curves_look_alike() {
        let all: Vec<_> = (0..30).map(Dash::of).collect();
        assert!(all.iter().enumerate().all(|(i, look)| !all[..i].contains(look)));
    }
}
