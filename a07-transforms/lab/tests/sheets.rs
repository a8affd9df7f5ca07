//! The judge tells right answers from wrong ones: the answers of each sheet give all facts, with several seeds if they
//! have random numbers, and each mistake fails first at its fact. Built and judged as `cargo learn sheet` does it.
//! `cargo test --release -p a07-lab --features sheets --test sheets`

use std::collections::BTreeSet;
use std::env::consts::EXE_SUFFIX;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::LazyLock;

use common::row;
use judge::pictures::{Facts, Judgement, NAMES, Sheet};
use learn::sheet::OwnProgram;

/// The folder of the answers.
const ANSWERS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/sheets");
const WORKBOOK: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

/// A tolerance is five standard deviations or more. A value this many tolerances from the right one with the first seed
/// is outside with the others, too, which are asked only about nearer values.
const FAR: f64 = 2.0;

macro_rules! test_sheets {
    ($($name:ident: $answers:expr, seeds: $seeds:literal;)*) => { $(
        #[test]
        fn $name() {
            answers_are_told_apart(stringify!($name), &$answers, $seeds);
        }
    )* };
}

test_sheets! {
    tree: ["tree", "tree_by_codes"], seeds: 1;
    patterns: ["patterns"], seeds: 3;
    glass: ["glass"], seeds: 1;
    lamp: ["lamp"], seeds: 3;
    lens: ["lens"], seeds: 3;
    light: ["light", "light_by_calls"], seeds: 3;
    cores: ["cores"], seeds: 3;
}

/// A row of `mistakes/NAME.toml`: an answer in which a line stands instead of another one.
struct Mistake {
    program: String,
    fails: String,
    forgets: String,
    /// The number that the fact measures, or why there is none.
    measured: String,
    line: String,
    instead: String,
}

fn mistakes(sheet: &str) -> Vec<Mistake> {
    let text = fs::read_to_string(format!("{ANSWERS}/mistakes/{sheet}.toml")).unwrap();
    let mistakes = row::read(sheet, &text, |file| {
        let mut mistakes = Vec::new();
        for (number, row) in file.rows("mistake")?.iter().enumerate() {
            mistakes.push(Mistake {
                program: format!("{sheet}_{number}"),
                fails: row.get("fails")?,
                forgets: row.get("forgets")?,
                measured: row.get("measured")?,
                line: row.get("line")?,
                instead: row.get("instead")?,
            });
        }
        Ok(mistakes)
    });
    mistakes.unwrap()
}

/// The folder of the programs: the answers and their mistakes, built in a copy beside which nothing else lies.
static PROGRAMS: LazyLock<PathBuf> = LazyLock::new(|| {
    let copy = Path::new(env!("CARGO_TARGET_TMPDIR")).join("answers");
    let _ = fs::remove_dir_all(copy.join("src"));
    fs::create_dir_all(copy.join("src/bin")).unwrap();
    for folder in ["src", "src/bin"] {
        for entry in fs::read_dir(format!("{ANSWERS}/{folder}")).unwrap() {
            let file = entry.unwrap().path();
            if file.is_file() {
                fs::copy(&file, copy.join(folder).join(file.file_name().unwrap())).unwrap();
            }
        }
    }
    for sheet in NAMES {
        let right = fs::read_to_string(format!("{ANSWERS}/src/bin/{sheet}.rs")).unwrap();
        for mistake in mistakes(sheet) {
            let Mistake {
                program,
                line,
                instead,
                ..
            } = mistake;
            assert_eq!(
                right.matches(&line).count(),
                1,
                "mistakes/{sheet}.toml: {line}"
            );
            let wrong = right.replace(&line, &instead);
            fs::write(copy.join(format!("src/bin/{program}.rs")), wrong).unwrap();
        }
    }
    let manifest = fs::read_to_string(format!("{ANSWERS}/Cargo.toml")).unwrap();
    let workbook = WORKBOOK.replace('\\', "/");
    let manifest = manifest.replace("\"../../../", &format!("\"{workbook}/"));
    fs::write(copy.join("Cargo.toml"), manifest).unwrap();
    // The versions of libraries that the workbook has fetched.
    fs::copy(format!("{WORKBOOK}/Cargo.lock"), copy.join("Cargo.lock")).unwrap();
    let mut cargo = Command::new("cargo");
    cargo.args(["build", "--quiet", "--release", "--target-dir", "target"]);
    let built = cargo
        .env("RUSTFLAGS", "-A warnings")
        .current_dir(&copy)
        .status()
        .unwrap();
    assert!(
        built.success(),
        "the answers or their mistakes do not compile"
    );
    copy.join("target/release")
});

/// What the judge says about a program.
fn judged<'a>(sheet: &'a Sheet, program: &str, seed: u32, facts: Facts) -> Judgement<'a> {
    let pictures = format!("{}/sheets/{program}-{seed}", env!("CARGO_TARGET_TMPDIR"));
    let program = OwnProgram {
        executable: PROGRAMS.join(format!("{program}{EXE_SUFFIX}")),
        folder: ANSWERS.into(),
        pictures: pictures.into(),
        arguments: Vec::new(),
        environment: vec![("SEED", seed.to_string())],
    };
    program.judge(sheet, facts).unwrap()
}

/// Whether a report begins with this number, of three digits, or with none. After "about", which stands for threads
/// whose order nobody knows, it is one from two thirds of the number to twice as much.
fn has_measured(report: &str, measured: &str) -> bool {
    let words = report.split_once("  measured  ").map(|(_, words)| words);
    let found = words.and_then(|words| words.split([' ', ':']).next());
    let (measured, within) = match measured.strip_prefix("about ") {
        Some(measured) => (measured, 0.5),
        None => (measured, 0.006),
    };
    match (measured.parse::<f64>(), found.map(str::parse::<f64>)) {
        (Ok(measured), Some(Ok(found))) => (found - measured).abs() <= within * found.abs(),
        (Err(_), None) => true,
        _ => false,
    }
}

fn answers_are_told_apart(name: &str, answers: &[&str], seeds: u32) {
    let text = fs::read_to_string(format!("{WORKBOOK}/common/judge/sheets/{name}.toml")).unwrap();
    let sheet = &Sheet::read(name, &text).unwrap();
    let mut problems = Vec::new();
    for answer in answers {
        for seed in 0..seeds {
            let judgement = judged(sheet, answer, seed, Facts::All);
            if judgement.first_failure().is_some() {
                let report = judgement.report();
                problems.push(format!("{answer}, seed {seed}:\n{report}"));
            }
        }
    }
    let mut failed = BTreeSet::new();
    for mistake in mistakes(name) {
        for seed in 0..seeds {
            let judgement = judged(sheet, &mistake.program, seed, Facts::UntilOneFails);
            let fails = judgement.first_failure().map_or("", |fact| &fact.name);
            if fails != mistake.fails {
                let Mistake { forgets, fails, .. } = &mistake;
                let report = judgement.report();
                problems.push(format!(
                    "{forgets}, seed {seed}: must fail first at {fails}\n{report}"
                ));
            }
            if seed == 0 && !has_measured(&judgement.report(), &mistake.measured) {
                let Mistake { forgets, .. } = &mistake;
                let report = judgement.report();
                problems.push(format!("{forgets}: another number is measured\n{report}"));
            }
            if judgement.tolerances_off() >= FAR {
                break;
            }
        }
        failed.insert(mistake.fails);
    }
    for fact in &sheet.facts {
        if !failed.contains(&fact.name) {
            problems.push(format!(
                "no mistake in mistakes/{name}.toml fails at {}",
                fact.name
            ));
        }
    }
    assert!(problems.is_empty(), "{}", problems.join("\n\n"));
}
