//! Tables, and the file that holds all sections: a section that is not measured keeps its last
//! rows.

use std::fs;
use std::path::PathBuf;

use serde_json::{Map, Value};

use crate::Result;

/// Where results lie.
pub fn folder() -> Result<PathBuf> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../target/liftoff");
    fs::create_dir_all(&folder)?;
    Ok(folder)
}

/// Everything measured so far.
pub fn kept() -> Result<Map<String, Value>> {
    let file = folder()?.join("speed.json");
    let Ok(text) = fs::read_to_string(file) else { return Ok(Map::new()) };
    Ok(serde_json::from_str(&text)?)
}

/// Puts the rows of a section into the file.
pub fn keep(section: &str, rows: Vec<Value>) -> Result<()> {
    let mut all = kept()?;
    all.insert(section.into(), rows.into());
    Ok(fs::write(folder()?.join("speed.json"), serde_json::to_string_pretty(&all)?)?)
}

/// One line a row, one column a key.
pub fn print(section: &str, rows: &[Value]) {
    let keys = rows.iter().filter_map(Value::as_object).flat_map(Map::keys);
    let mut columns: Vec<&String> = Vec::new();
    for key in keys {
        if !columns.contains(&key) {
            columns.push(key);
        }
    }
    println!("\n{section}\n| {} |", columns.iter().map(|name| name.as_str()).collect::<Vec<_>>().join(" | "));
    println!("|{}", " --: |".repeat(columns.len()));
    for row in rows {
        let cells: Vec<String> = columns.iter().map(|key| cell(&row[key.as_str()])).collect();
        println!("| {} |", cells.join(" | "));
    }
}

fn cell(value: &Value) -> String {
    match value {
        Value::Null => "–".into(),
        Value::String(text) => text.clone(),
        Value::Number(number) if number.is_f64() => {
            let x = number.as_f64().unwrap_or(f64::NAN);
            match x.abs() {
                size if size >= 100.0 => format!("{x:.0}"),
                size if size >= 0.01 => format!("{x:.2}"),
                _ => format!("{x:.1e}"),
            }
        }
        other => other.to_string(),
    }
}
