//! What the leader sends.

use super::Given;
use crate::sweep::cell::written;
use crate::sweep::journal::record;

const RUN: &str = "run\n";
const END: &str = "end\n";

/// What the leader sends.
#[derive(PartialEq, Debug)]
pub(in crate::sweep) enum Order {
    /// Members to compute.
    Run(Vec<Given>),
    /// There is no more to do.
    End,
}

impl Order {
    pub(in crate::sweep) fn text(&self) -> String {
        match self {
            Self::End => END.to_owned(),
            Self::Run(members) => {
                let line = |(member, point): &Given| {
                    let values = point.iter().map(|value| written(*value));
                    record([member.to_string()].into_iter().chain(values))
                };
                members.iter().fold(RUN.to_owned(), |text, given| text + &line(given))
            }
        }
    }

    /// Reads what [`Order::text`] has written.
    pub(in crate::sweep) fn parse(text: &str) -> Option<Self> {
        match text.strip_prefix(RUN) {
            Some(lines) => lines.lines().map(given).collect::<Option<_>>().map(Self::Run),
            None => (text == END).then_some(Self::End),
        }
    }
}

fn given(line: &str) -> Option<Given> {
    let mut fields = line.split(',');
    let member = fields.next()?.parse().ok()?;
    let point = fields.map(|value| value.parse().ok()).collect::<Option<_>>()?;
    Some((member, point))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_are_sent_bit_for_bit() {
        let values = vec![0.1, -0.0, 1e-310, f64::MAX, 1.0 / 3.0, f64::INFINITY, 5e-324, 1e16];
        let order = Order::Run(vec![(7, values), (123_456, Vec::new())]);
        assert_eq!(Order::parse(&order.text()), Some(order));
        assert_eq!(Order::parse(&Order::End.text()), Some(Order::End));
        assert!([-0.0_f64].iter().all(|zero| matches!(
            Order::parse(&Order::Run(vec![(0, vec![*zero])]).text()),
            Some(Order::Run(members)) if members[0].1[0].to_bits() == zero.to_bits()
        )));
    }

    #[test]
    fn other_text_is_no_order() {
        for text in ["", "run", "end", "run\nx,1\n", "run\n1,y\n", "rows\n1\n", "run\n\n"] {
            assert_eq!(Order::parse(text), None, "{text:?}");
        }
    }
}
