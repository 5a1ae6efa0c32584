//! Random chains with constant angles of every kind: welds, slopes, offsets, loads, gravity.

use liftoff_tests::random::Source;

/// Parameters and their values.
const FIELDS: [(&str, f64); 8] = [
    ("m", 1.3),
    ("l", 0.7),
    ("g", 9.81),
    ("c", 0.4),
    ("f", 2.1),
    ("alpha", 0.35),
    ("beta", -0.8),
    ("gamma", 1.9),
];

/// A parameter, a number, or made of them.
fn angle(source: &mut Source) -> &'static str {
    let angles = [
        "alpha",
        "beta",
        "gamma",
        "0.3",
        "-1.1",
        "pi / 2 - alpha",
        "2 * beta",
        "alpha + gamma",
        "alpha - 0.2",
    ];
    source.choose(&angles)
}

/// A declaration, and the values of its parameters.
pub fn draw(source: &mut Source) -> (String, Vec<f64>) {
    let bars = 1 + source.below(3);
    let mut lines = Vec::new();
    for i in 0..bars {
        lines.push(format!("#[bar(B{i} = P{i} -> P{}, mass = m, length = l)]", i + 1));
        if i > 0 && source.chance(0.6) {
            lines.push(format!("#[weld(B{}, B{i}, angle = {})]", i - 1, angle(source)));
        }
        if source.chance(0.4) {
            let turn = angle(source);
            lines.push(format!("#[point(C{i} = B{i}, at = (c * cos({turn}), c * sin({turn})))]"));
            lines.push(format!("#[mass(C{i}, m)]"));
        }
    }
    lines.extend(source.chance(0.7).then(|| "#[pin(P0 = (0, 0))]".to_owned()));
    lines.push("#[coordinate(q = angle(B0), from = right)]".to_owned());
    if source.chance(0.7) {
        let [a, b, d] = [0; 3].map(|_| angle(source));
        let frame = if source.chance(0.5) { ", frame = B0" } else { "" };
        lines.push(format!(
            "#[force(push = (f * sin({a}), f * (cos(q - ({b})) + sin(q + {d}))), at = P{bars}{frame})]"
        ));
    }
    if source.chance(0.6) {
        lines.push(format!("#[support(P{bars} = slope({}))]", angle(source)));
    }
    let turn = angle(source);
    lines.push(format!("#[gravity(g * sin({turn}), -g * cos({turn}))]"));
    // Of the figure a support needs its point; welds stand at their own angles.
    let points: Vec<String> = (0..=bars).map(|i| format!("P{i} = ({i} * l, 0)")).collect();
    lines.push(format!("#[figure({})]", points.join(", ")));
    let text = lines.join("\n");
    let words: Vec<&str> = text.split(|c: char| !c.is_alphanumeric()).collect();
    let (fields, values): (Vec<_>, Vec<_>) =
        FIELDS.iter().filter(|(name, _)| words.contains(name)).copied().unzip();
    let fields: String = fields.iter().map(|name| format!("{name}: f64, ")).collect();
    (format!("{text}\nstruct Turned {{ {fields}}}"), values)
}
