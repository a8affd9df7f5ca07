//! Prints the JSON schema of scene files.
//!
//! ```console
//! $ cargo run -p scene-file --example schema > a07-transforms/scenes/schema.json
//! ```

fn main() {
    print!("{}", scene_file::schema());
}
