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
        let folder = answers.join(design);
        println!("cargo::rerun-if-changed={design}");
        let mut files: Vec<_> = fs::read_dir(folder)?
            .flatten()
            .map(|file| file.path())
            .collect();
        files.sort();
        for file in files {
            let name = file.file_stem().unwrap_or_default().to_string_lossy();
            if file.extension().is_some_and(|extension| extension == "rs") {
                add(&format!("{design}/{name}"), &file);
            }
        }
    }
    println!("cargo::rerun-if-changed=wrong.toml");
    let rows = fs::read_to_string(answers.join("wrong.toml"))?;
    for (number, text) in wrong_answers(&answers, &rows)?.iter().enumerate() {
        let file = output.join(format!("wrong_{number}.rs"));
        fs::write(&file, text)?;
        if env::var("OPT_LEVEL")? != "0" {
            add(&format!("wrong/{number}"), &file);
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

/// The texts of the wrong answers: the first ones, each with a mistake.
fn wrong_answers(answers: &Path, rows: &str) -> Result<Vec<String>, Problem> {
    let table = DeTable::parse(rows)?;
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
            text.ok_or_else(|| format!("wrong.toml, row {number}: `{key}` is missing"))
        };
        let (sheet, line, instead) = (text("sheet")?, text("line")?, text("instead")?);
        let right = fs::read_to_string(answers.join(format!("first/{sheet}.rs")))?;
        let count = right.matches(line).count();
        if count != 1 {
            let fails = text("fails")?;
            return Err(format!(
                "wrong.toml, row {number} ({sheet}, {fails}): first/{sheet}.rs has its line {count} times: {line}"
            )
            .into());
        }
        texts.push(right.replace(line, instead));
    }
    Ok(texts)
}
