//! Fig. 1b with every support watched on its own, beside the published scheme.

use super::{Page, dash, figures, minus};
use std::fmt::Write;

const RULE: &str = "<p>The paper watches the total reaction. A, C and E are three contacts, and it is the first of <em>them</em> to \
    reach zero that ends the phase: A and E for λ &lt; ¼, C for λ &gt; ¼; at λ = ¼, N<sub>C</sub> = 6 N<sub>E</sub> throughout, all \
    three open at once, and the paper's motion is the true one. Elsewhere inner and outer angles differ from the first \
    opening on. The published flight keeps them equal, which is another system: it takes a gear or a torque between the bars.</p>\n";

impl Page<'_> {
    pub(super) fn strict(&self) -> String {
        let mut html = String::from(RULE);
        if let Some(difference) = &self.difference {
            let _ = writeln!(html, "<p id=difference>{difference}</p>");
        }
        html += &self.table();
        html + &figures(self.strict)
    }

    fn table(&self) -> String {
        let mut html = String::from(
            "<div class=table><table>\n<caption>Angles in rad. λ = m₂/(m₁ + m₂); inner and outer angle where they differ.</caption>\n\
             <thead><tr><th>λ<th>published: lift-off<th>B, D touch<th class=word>strict: first<th>at\
             <th class=word>then<th>inner<th>outer<th>B, D touch: inner<th>outer</tr></thead>\n<tbody>\n",
        );
        for line in &self.lines {
            let (first, at) = line
                .first
                .as_ref()
                .map_or((dash(), dash()), |(names, phi)| (names.clone(), angle(Some(*phi))));
            let (then, [inner, outer]) = line
                .second
                .as_ref()
                .map_or((dash(), [None, None]), |(names, pair)| (names.clone(), pair.map(Some)));
            let touch = line.touch.map_or([None, None], |pair| pair.map(Some));
            let _ = writeln!(
                html,
                "<tr><td>{}<td>{}<td>{}<td class=word>{first}<td>{at}<td class=word>{then}<td>{}<td>{}<td>{}<td>{}</tr>",
                line.ratio,
                angle(line.published[0]),
                angle(line.published[1]),
                angle(inner),
                angle(outer),
                angle(touch[0]),
                angle(touch[1]),
            );
        }
        html + "</tbody></table></div>\n"
    }
}

fn angle(value: Option<f64>) -> String {
    value.map_or_else(dash, |value| minus(&format!("{value:.8}")))
}
