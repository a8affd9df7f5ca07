//! The recordings: measured by `cargo record`, and put into the pages when the book is built.

use std::io::Read;
use std::path::{Path, PathBuf};
use std::process::Command;

use measure::recorded::{Recordings, Texts};
use serde_json::Value;

use crate::command::{output, run};
use crate::file;

/// Where the recordings are, a folder for each build.
const FOLDER: &str = "book/recordings";

const PICTURES: &str = "book/src/pictures";

/// The builds that are measured: what the book shows, and the one that a remark has to
/// hold for as well.
const BUILDS: [&str; 2] = ["fastest", "release"];

/// What is to be measured.
#[derive(clap::Args)]
pub struct Task {
    /// Stages or experiments, such as a04 or a04.sphere-far [default: all]
    names: Vec<String>,
    /// Replaces also earlier times that count as equal to the new ones
    #[arg(long)]
    afresh: bool,
    /// Only draws the plots of the last measurement
    #[arg(long, conflicts_with_all = ["names", "afresh"])]
    draw: bool,
    /// Measures into this folder, and leaves the book as it is
    #[arg(long, value_name = "FOLDER")]
    into: Option<PathBuf>,
}

/// Measures all experiments in both builds, and draws the plots.
pub fn record(task: &Task) -> Result<(), String> {
    if !task.draw {
        let pinned = pinned();
        for build in BUILDS {
            println!("building {build}, which takes minutes");
            let arguments = [
                "build",
                "--quiet",
                "--package",
                "book-recorder",
                "--profile",
                build,
            ];
            run(Command::new("cargo").args(arguments))?;
            let folder = match &task.into {
                Some(folder) => folder.join(build),
                None => Path::new(FOLDER).join(build),
            };
            let program = program(build)?;
            let mut recorder = match pinned {
                Some(core) => {
                    let mut taskset = Command::new("taskset");
                    taskset.args(["--cpu-list", core]).arg(program);
                    taskset
                }
                None => Command::new(program),
            };
            recorder.arg(&folder);
            recorder.args(&task.names);
            if pinned.is_some() {
                recorder.args(["--conditions", "pinned to a core"]);
            }
            if task.afresh {
                recorder.arg("--afresh");
            }
            run(&mut recorder)?;
        }
    }
    match task.into {
        Some(_) => Ok(()),
        None => draw(),
    }
}

/// The recorder of a build, beside the folder of this program.
fn program(build: &str) -> Result<PathBuf, String> {
    let this = std::env::current_exe().map_err(|error| error.to_string())?;
    let target = this
        .ancestors()
        .nth(2)
        .ok_or("this program is in no folder")?;
    let name = format!("book-recorder{}", std::env::consts::EXE_SUFFIX);
    Ok(target.join(build).join(name))
}

/// The core to which a program can be pinned, if the system has `taskset`.
fn pinned() -> Option<&'static str> {
    output(Command::new("taskset").args(["--cpu-list", "0", "true"]))
        .ok()
        .map(|_| "0")
}

/// Draws each plot of the recordings that is in the folder of pictures, or on a page.
fn draw() -> Result<(), String> {
    let texts = Texts::read(Path::new(FOLDER))?;
    let mut pages = String::new();
    for path in file::files_below(Path::new("book/src"))? {
        if file::has_extension(&path, "md") {
            pages += &file::read(&path)?;
        }
    }
    for plot in texts.recordings()?.plots() {
        if pages.contains(&format!("](pictures/{})", plot.name)) {
            file::write(&Path::new(PICTURES).join(&plot.name), &plot.svg)?;
            println!("{PICTURES}/{}", plot.name);
        }
    }
    Ok(())
}

/// A preprocessor of mdBook: reads the book as JSON, fills its anchors, and writes it.
pub fn preprocess() -> Result<(), String> {
    let mut json = String::new();
    std::io::stdin()
        .read_to_string(&mut json)
        .map_err(|error| error.to_string())?;
    let json: Value = serde_json::from_str(&json).map_err(|error| error.to_string())?;
    // The first of the two values is the configuration.
    let mut book = json.get(1).ok_or("mdBook gave no book")?.clone();
    let texts = Texts::read(Path::new(FOLDER))?;
    fill(&mut book, &texts.recordings()?)?;
    println!("{book}");
    Ok(())
}

/// Fills the anchors of all chapters in a value of the book.
fn fill(value: &mut Value, recordings: &Recordings) -> Result<(), String> {
    match value {
        Value::Array(items) => {
            for item in items {
                fill(item, recordings)?;
            }
        }
        Value::Object(fields) => {
            for (name, field) in fields.iter_mut() {
                match field {
                    Value::String(text) if name == "content" => {
                        *text = recordings.fill(text).map_err(|error| error.why)?;
                    }
                    _ => fill(field, recordings)?,
                }
            }
        }
        _ => {}
    }
    Ok(())
}
