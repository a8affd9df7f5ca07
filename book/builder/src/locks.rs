//! The hashes of the pictures that the tests lock, as a script: a page compares what it renders.

use std::path::Path;

use crate::file;

/// A line for each picture of the book, under the name of its file.
pub fn script() -> Result<String, String> {
    let mut lines = Vec::new();
    for stage in file::stages()? {
        for snapshot in file::entries(&Path::new(&stage).join("tests/snapshots"))? {
            if !file::has_extension(&snapshot, "snap") {
                continue;
            }
            let text = file::read(&snapshot)?;
            let hash = text.lines().find_map(|line| line.strip_prefix("hash "));
            let scene = file::stem(&snapshot);
            for folder in [&stage, "errata", "go-wrong"] {
                let picture = format!("{folder}-{scene}");
                let path = Path::new("book/src/pictures").join(format!("{picture}.png"));
                if let Some(hash) = hash.filter(|_| path.is_file()) {
                    lines.push(format!("    '{picture}': '{hash}',\n"));
                }
            }
        }
    }
    Ok(format!("live.locks = {{\n{}}};\n", lines.concat()))
}
