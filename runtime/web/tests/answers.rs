//! What a page is told, without a browser.

use liftoff_web::{State, answer};
use serde_json::{Value, json};

const SWING: &str = "/// A bar that swings — φ.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(OA, mass = m, length = l)]
#[pin(O = (0, 0))]
#[figure(A = (0, -l))]
#[coordinate(phi = angle(OA), from = down)]
#[run(start = \"phi = 1\", until = \"phi = 0\")]
struct Swing { #[value = 2] m: f64, #[value(0.5, unit = \"m\")] l: f64, #[value = 9.81] g: f64 }
";

fn ask(state: &mut State, request: &Value) -> Value {
    serde_json::from_str(&answer(state, &request.to_string())).expect("JSON")
}

#[test]
fn a_text_is_derived_and_run_with_what_is_chosen() {
    let mut state = State::default();
    let model = ask(&mut state, &json!({ "ask": "derive", "text": SWING }));
    assert_eq!((&model["told"], &model["name"]), (&json!("model"), &json!("Swing")));
    assert_eq!(model["parameters"][1], json!({ "name": "l", "unit": "m", "value": 0.5 }));
    assert_eq!(model["start"][0]["value"], 1.0);
    assert!(model["drawing"].as_str().is_some_and(|svg| svg.starts_with("<svg")));
    let rates = |run: &Value| {
        let stop = run["events"][1].as_str().expect("an event").to_owned();
        assert!(run["played"]["motion"]["phases"].is_array());
        stop
    };
    let declared = rates(&ask(&mut state, &json!({ "ask": "run" })));
    let longer = rates(&ask(&mut state, &json!({ "ask": "run", "set": { "l": 2.0 } })));
    assert!(declared.starts_with("stop at t = ") && declared != longer, "{declared} {longer}");
    let start = json!({ "ask": "run", "start": { "phi": 0.5 }, "until": ["t = 0.25"] });
    assert!(rates(&ask(&mut state, &start)).contains("t = 0.2500"));
    let equations = ask(&mut state, &json!({ "ask": "equations" }));
    assert!(
        equations["html"].as_str().is_some_and(|html| html.contains("<math") && !html.contains("<script"))
    );
}

#[test]
fn a_table_has_the_motion_with_units_and_both_sides_of_an_impact() {
    let mut state = State::default();
    let text = include_str!("../gallery/bouncing_bar.rs");
    let model = ask(&mut state, &json!({ "ask": "derive", "text": text }));
    let units = |k: usize| model["start"][k]["unit"].clone();
    assert_eq!([0, 1, 3, 4].map(units), ["rad", "m", "rad/s", "m/s"]);
    let table = ask(&mut state, &json!({ "ask": "table", "start": { "phi": 0.25 } }));
    let csv = table["csv"].as_str().expect("text");
    let (head, rows) = csv.split_once('\n').expect("a head");
    assert_eq!(
        head,
        "t [s],phi [rad],x [m],y [m],phi' [rad/s],x' [m/s],y' [m/s],N(A) [N],N(B) [N],gap(A) [m],gap(B) [m],T [J],V [J],E [J]"
    );
    let rows: Vec<Vec<f64>> = rows
        .lines()
        .map(|row| row.split(',').map(|cell| cell.parse().expect("a number")).collect())
        .collect();
    assert_eq!(rows[0][..4], [0.0, 0.25, 0.0, 1.0]);
    assert_eq!(rows.last().expect("rows")[0], 2.0);
    let struck = rows.windows(2).find(|pair| pair[0][0] == pair[1][0]).expect("an impact");
    assert!(struck[0][6] < 0.0 && struck[1][13] < struck[0][13], "{struck:?}");
}

/// Browsers count UTF-16 units: — and φ are one each, and three and two bytes.
#[test]
fn mistakes_stand_where_a_browser_counts() {
    let text = SWING.replace("length = l)", "length = k)");
    let told = ask(&mut State::default(), &json!({ "ask": "derive", "text": text }));
    let mistake = &told["mistakes"][0];
    let units: Vec<u16> = text.encode_utf16().collect();
    let at = |name: &str| mistake[name].as_u64().expect("a place") as usize;
    assert_eq!(String::from_utf16_lossy(&units[at("from")..at("to")]), "k");
}

#[test]
fn what_makes_no_sense_is_refused() {
    let mut state = State::default();
    let mut why = |request: Value| {
        let told = ask(&mut state, &request);
        assert_eq!(told["told"], "refused", "{told}");
        told["why"].as_str().expect("a reason").to_owned()
    };
    assert!(why(json!({ "ask": "run" })).contains("nothing has been derived"));
    assert!(why(json!({ "ask": "dance" })).contains("no request"));
    assert!(why(json!({ "ask": "derive", "text": "struct Empty;" })).contains("nothing in the text"));
    ask(&mut state, &json!({ "ask": "derive", "text": SWING }));
    let mut why = |request: Value| ask(&mut state, &request)["why"].as_str().unwrap_or_default().to_owned();
    assert!(why(json!({ "ask": "run", "set": { "k": 1.0 } })).contains("`k`"));
    assert!(why(json!({ "ask": "run", "set": { "l": -1.0 } })).contains('l'));
    assert!(!why(json!({ "ask": "run", "until": ["phi >"] })).is_empty());
    assert!(why(json!({ "ask": "run", "tolerance": 0.0 })).contains("tolerance"));
}

/// Every text is answered: cut anywhere, and with any character in place of another.
#[test]
fn any_text_has_an_answer() {
    let mut state = State::default();
    let places: Vec<usize> = SWING.char_indices().map(|(at, _)| at).step_by(5).collect();
    for &at in &places {
        for text in [SWING[..at].to_owned(), format!("{}{}{}", &SWING[..at], "\"{(φ", &SWING[at..])] {
            let told = ask(&mut state, &json!({ "ask": "derive", "text": text }));
            assert!(told["told"].is_string());
        }
    }
}
