//! Writes `variants.rs`: a module for each answer, and the choice of one by its name.

use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::{env, fs};

use toml::de::DeTable;

type Problem = Box<dyn std::error::Error>;

fn main() -> Result<(), Problem> {
    let answers = PathBuf::from(env::var("CARGO_MANIFEST_DIR")?);
    let output = PathBuf::from(env::var("OUT_DIR")?);
    let mut modules = String::new();
    let mut choices = String::new();
    let mut add = |name: &str, file: &Path| {
        let module = name.replace('/', "_");
        // As text, with the escapes of a path of Windows.
        let file = file.to_string_lossy();
        // The compiler's advice is for code that is read.
        let lints = if name.starts_with("wrong") {
            "#[allow(warnings, clippy::all, clippy::pedantic)]\n"
        } else {
            ""
        };
        let _ = writeln!(modules, "{lints}#[path = {file:?}]\nmod {module};");
        let _ = writeln!(
            choices,
            "        {name:?} => {module}::render(scene, samples),"
        );
    };
    for design in ["first", "second"] {
        println!("cargo::rerun-if-changed={design}");
        for file in files_in(&answers.join(design))? {
            let name = file.file_stem().unwrap_or_default().to_string_lossy();
            add(&format!("{design}/{name}"), &file);
        }
    }
    println!("cargo::rerun-if-changed=wrong");
    for file in files_in(&answers.join("wrong"))? {
        let sheet = file.file_stem().unwrap_or_default().to_string_lossy();
        let right = answers.join(format!("first/{sheet}.rs"));
        let right = fs::read_to_string(right);
        let right = right.map_err(|error| format!("first/{sheet}.rs: {error}"))?;
        let texts = wrong_answers(&right, &fs::read_to_string(&file)?);
        let texts = texts.map_err(|problem| format!("wrong/{sheet}.toml, {problem}"))?;
        for (number, text) in texts.iter().enumerate() {
            let file = output.join(format!("{sheet}_{number}.rs"));
            fs::write(&file, text)?;
            if env::var("OPT_LEVEL")? != "0" {
                add(&format!("wrong/{sheet}/{number}"), &file);
            }
        }
    }
    let variants = format!(
        "{modules}\n\
         fn render(variant: &str, scene: &str, samples: u32) -> Result<Image, Error> {{\n    \
         match variant {{\n{choices}        \
         _ => panic!(\"{{variant}} is no answer: {{scene}}, {{samples}} samples\"),\n    }}\n}}\n"
    );
    fs::write(output.join("variants.rs"), variants)?;
    Ok(())
}

/// The files of a folder, sorted by their names.
fn files_in(folder: &Path) -> Result<Vec<PathBuf>, Problem> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder)? {
        files.push(entry?.path());
    }
    files.sort();
    Ok(files)
}

/// The texts of the wrong answers of a sheet: the right one, each with a mistake.
fn wrong_answers(right: &str, rows: &str) -> Result<Vec<String>, String> {
    let table = DeTable::parse(rows).map_err(|error| error.to_string())?;
    let rows = table
        .get_ref()
        .get("wrong")
        .and_then(|rows| rows.get_ref().as_array());
    let mut texts = Vec::new();
    for (number, row) in rows.into_iter().flatten().enumerate() {
        let text = |key| -> Result<&str, String> {
            let text = row
                .get_ref()
                .as_table()
                .and_then(|row| row.get(key)?.get_ref().as_str());
            text.ok_or_else(|| format!("row {number}: `{key}` is missing"))
        };
        let (line, instead) = (text("line")?, text("instead")?);
        let count = right.matches(line).count();
        if count != 1 {
            let fails = text("fails")?;
            return Err(format!(
                "row {number} ({fails}): its line occurs {count} times: {line}"
            ));
        }
        texts.push(right.replace(line, instead));
    }
    Ok(texts)
}
