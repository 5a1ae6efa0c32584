//! Markdown for rustdoc as Markdown for a site.

/// A text without hidden lines of Rust and without links that only rustdoc resolves.
pub fn publish(text: &str) -> String {
    let mut published = String::new();
    let mut fence: Option<&str> = None;
    for line in text.lines() {
        let is_rust = fence.is_some_and(|language| language == "rust");
        match (line.strip_prefix("```"), fence) {
            (Some(language), None) => {
                let language =
                    if language.is_empty() || language == "compile_fail" { "rust" } else { language };
                fence = Some(language);
                published += &format!("```{language}\n");
            }
            (Some(_), Some(_)) => {
                fence = None;
                published += "```\n";
            }
            (None, Some(_)) if is_rust && is_hidden(line) => {}
            (None, Some(_)) => published += &format!("{line}\n"),
            (None, None) => published += &format!("{}\n", without_paths(line)),
        }
    }
    published
}

/// A line of an example that is compiled and not shown.
pub fn is_hidden(line: &str) -> bool {
    line == "#" || line.starts_with("# ")
}

/// Links to items of Rust as their texts alone.
fn without_paths(line: &str) -> String {
    let mut parts = line.split("](");
    let mut text = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let Some((target, rest)) = part.split_once(')') else {
            text += &format!("]({part}");
            continue;
        };
        if target.contains("::") || target.contains('@') {
            let opened = text.rfind('[').unwrap_or(0);
            text.replace_range(opened..=opened, "");
            text += rest;
        } else {
            text += &format!("]({part}");
        }
    }
    text.replace("../../../engine/src/attributes.md", "words.md")
}

/// The lines of Rust, and all else that is no code.
#[cfg(test)]
pub fn divide(text: &str) -> (Vec<&str>, String) {
    let (mut code, mut prose) = (Vec::new(), String::new());
    let mut fence: Option<&str> = None;
    for line in text.lines() {
        match (line.strip_prefix("```"), fence) {
            (Some(language), None) => fence = Some(language),
            (Some(_), Some(_)) => fence = None,
            (None, Some(language)) => code.extend(Some(line).filter(|_| language == "rust")),
            (None, None) => prose += &format!("{line}\n"),
        }
    }
    (code, prose)
}
