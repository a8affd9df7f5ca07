//! A preprocessor of mdBook: puts the figures of the recording into the pages, and marks their formulas.

use std::io::Read;
use std::path::Path;

use measure::recorded::Recording;
use serde_json::Value;

use crate::{file, formulas, recorded};

/// Reads the book as JSON, changes the text of its chapters, and writes it.
pub fn run() -> Result<(), String> {
    let mut json = String::new();
    std::io::stdin()
        .read_to_string(&mut json)
        .map_err(|error| error.to_string())?;
    let json: Value = serde_json::from_str(&json).map_err(|error| error.to_string())?;
    // The first of the two values is the configuration.
    let mut book = json.get(1).ok_or("mdBook gave no book")?.clone();
    let [here, elsewhere] =
        [recorded::RECORDING, recorded::ELSEWHERE].map(|path| file::read(Path::new(path)));
    let (here, elsewhere) = (here?, elsewhere?);
    let recording = Recording::parse(&here)?.with_elsewhere(&elsewhere)?;
    change(&mut book, &recording)?;
    println!("{book}");
    Ok(())
}

/// Changes all chapters in a value of the book.
fn change(value: &mut Value, recording: &Recording) -> Result<(), String> {
    match value {
        Value::Array(items) => {
            for item in items {
                change(item, recording)?;
            }
        }
        Value::Object(fields) => {
            for (name, field) in fields.iter_mut() {
                match field {
                    Value::String(text) if name == "content" => {
                        *text = formulas::mark(&recording.fill(text)?)?;
                    }
                    _ => change(field, recording)?,
                }
            }
        }
        _ => {}
    }
    Ok(())
}
