//! The table of the ladder of scenes, also as `target/liftoff/scenes.json`: `cargo bench -p liftoff-tests --bench scenes`.

#[path = "speed/scenes.rs"]
mod scenes;

fn main() -> std::io::Result<()> {
    let rows = scenes::rows();
    print!("{}", scenes::table(&rows));
    std::fs::create_dir_all("../target/liftoff")?;
    std::fs::write("../target/liftoff/scenes.json", serde_json::to_string_pretty(&rows)?)
}
