//! The recording, which `cargo record` measures, and compares with another one.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use measure::recorded::Recording;
use serde_json::{Value, json};

use crate::command::{output, run};
use crate::file;

/// The recording of the book.
pub const RECORDING: &str = "book/recording.csv";

/// The points of another recording whose quotients of times have another sign.
pub const ELSEWHERE: &str = "book/elsewhere.csv";

const PICTURES: &str = "book/src/pictures";

/// Where the recorder leaves its files.
const MEASURED: &str = "target/recording";

/// Measures all experiments in a `--release` build, and replaces recording and plots of the book.
pub fn record() -> Result<(), String> {
    println!("building the laboratories, which takes minutes");
    let build = [
        "build",
        "--quiet",
        "--release",
        "--package",
        "book-recorder",
    ];
    run(Command::new("cargo").args(build))?;
    let folder = Path::new(MEASURED);
    fs::create_dir_all(folder).map_err(file::with_path(folder))?;
    let mut recorder = recorder()?;
    recorder.arg(folder);
    for (key, program, arguments) in HEAD {
        let printed = output(Command::new(program).args(arguments))?;
        recorder
            .arg("--head")
            .arg(format!("{key}: {}", printed.trim()));
    }
    run(&mut recorder)?;
    let measured = file::read(&folder.join("recording.csv"))?;
    file::write(Path::new(RECORDING), &measured)?;
    replace_plots(folder)
}

/// Says which quotients of times have another sign in another recording, and keeps them, so that no page
/// prints them as facts.
pub fn compare(other: &Path) -> Result<(), String> {
    let (here, there) = (file::read(Path::new(RECORDING))?, file::read(other)?);
    let here = Recording::parse(&here)?;
    let compared = here.compare(&Recording::parse(&there)?);
    let (opposite, unsure): (Vec<_>, Vec<_>) = compared
        .turned
        .iter()
        .partition(|turned| turned.is_opposite());
    for (kind, turned) in [
        ("have the other sign", opposite),
        ("differ in one only", unsure),
    ] {
        println!(
            "{} of {} quotients {kind}",
            turned.len(),
            compared.quotients
        );
        for one in turned {
            println!("  {one}");
        }
    }
    file::write(Path::new(ELSEWHERE), &compared.elsewhere)?;
    println!("{ELSEWHERE}");
    Ok(())
}

/// What a page measures anew, beside the recorded curves of an experiment.
const MEASURED_AGAIN: [(&str, &str); 3] = [
    ("samples-curved-edge", "a03.samples-curved-edge"),
    ("samples-level-edge", "a03.samples-level-edge"),
    ("a05-lighting-phong", "a05.phong"),
];

/// The recorded curves as a script.
pub fn script() -> Result<String, String> {
    let text = file::read(Path::new(RECORDING))?;
    let recording = Recording::parse(&text)?;
    let mut curves = serde_json::Map::new();
    for (subject, name) in MEASURED_AGAIN {
        let mut points = Vec::new();
        for row in recording.experiment(name) {
            points.push(json!({
                "method": row.method,
                "error": row.error.value,
                "seconds": row.seconds.value
            }));
        }
        curves.insert(subject.to_owned(), points.into());
    }
    Ok(format!("live.recorded = {};\n", Value::from(curves)))
}

/// What the head of a recording says beside machine and build, and the programs that know it.
const HEAD: [(&str, &str, &[&str]); 3] = [
    ("compiler", "rustc", &["--version"]),
    ("commit", "git", &["describe", "--always", "--dirty"]),
    ("date", "date", &["-u", "+%F"]),
];

/// The recorder, beside the folder of this program; pinned to a core, if the system has `taskset`.
fn recorder() -> Result<Command, String> {
    let this = std::env::current_exe().map_err(|error| error.to_string())?;
    let target = this
        .ancestors()
        .nth(2)
        .ok_or("this program is in no folder")?;
    let name = format!("book-recorder{}", std::env::consts::EXE_SUFFIX);
    let program: PathBuf = target.join("release").join(name);
    let pinned = ["--cpu-list", "0"];
    if output(Command::new("taskset").args(pinned).arg("true")).is_err() {
        return Ok(Command::new(program));
    }
    let mut taskset = Command::new("taskset");
    taskset.args(pinned).arg(program);
    Ok(taskset)
}

/// Copies each measured plot that is on a page.
fn replace_plots(folder: &Path) -> Result<(), String> {
    let mut pages = String::new();
    for path in file::files_below(Path::new("book/src"))? {
        if file::has_extension(&path, "md") {
            pages += &file::read(&path)?;
        }
    }
    for path in file::files_below(folder)? {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        if pages.contains(&format!("](pictures/{name})")) {
            file::write(&Path::new(PICTURES).join(&*name), &file::read(&path)?)?;
            println!("{PICTURES}/{name}");
        }
    }
    Ok(())
}
