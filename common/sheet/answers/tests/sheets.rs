//! The judge tells right answers from wrong ones: two designs of each sheet give all facts, with several seeds if they
//! have random numbers, and each mistake fails first at its fact. Judged as `cargo learn sheet` judges a student's
//! program.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use learn::sheet::OwnProgram;
use sheet::{Facts, Judgement, Row, Sheet};
use toml::de::DeTable;

/// A tolerance is five standard deviations or more. A value this many tolerances from the right one with the first seed
/// is outside with the others, too, which are asked only about nearer values.
const FAR: f64 = 2.0;

macro_rules! test_sheets {
    ($($name:ident, seeds: $seeds:literal;)*) => { $(
        #[test]
        #[cfg_attr(debug_assertions, ignore = "its pictures take too long without optimisation")]
        fn $name() {
            answers_are_told_apart(stringify!($name), $seeds);
        }
    )* };
}

test_sheets! {
    tree, seeds: 1;
    patterns, seeds: 3;
    glass, seeds: 1;
    lamp, seeds: 3;
    lens, seeds: 3;
    light, seeds: 3;
}

/// A row of `wrong/NAME.toml`.
struct Wrong {
    variant: String,
    fails: String,
    forgets: String,
}

fn wrong_answers(sheet: &str) -> Vec<Wrong> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("wrong/{sheet}.toml"));
    let text = fs::read_to_string(path).unwrap();
    let table = DeTable::parse(&text).unwrap();
    let rows = Row::new(sheet, table.get_ref()).rows("wrong").unwrap();
    let mut wrong = Vec::new();
    for (number, row) in rows.iter().enumerate() {
        wrong.push(Wrong {
            variant: format!("wrong/{sheet}/{number}"),
            fails: row.get("fails").unwrap(),
            forgets: row.get("forgets").unwrap(),
        });
    }
    wrong
}

/// What the judge says about an answer.
fn judged<'a>(sheet: &'a Sheet, variant: &str, seed: u32, facts: Facts) -> Judgement<'a> {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("sheets");
    let program = OwnProgram {
        executable: env!("CARGO_BIN_EXE_sheet-answers").into(),
        folder: env!("CARGO_MANIFEST_DIR").into(),
        pictures: folder.join(&sheet.name).join(format!("{variant}-{seed}")),
        arguments: Vec::new(),
        environment: vec![("VARIANT", variant.to_owned()), ("SEED", seed.to_string())],
    };
    program.judge(sheet, facts).unwrap()
}

fn answers_are_told_apart(name: &str, seeds: u32) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../sheets/{name}.toml"));
    let text = fs::read_to_string(path).unwrap();
    let sheet = &Sheet::read(name, &text).unwrap();
    let mut problems = Vec::new();
    for design in ["first", "second"] {
        for seed in 0..seeds {
            let judgement = judged(sheet, &format!("{design}/{name}"), seed, Facts::All);
            if judgement.first_failure().is_some() {
                let report = judgement.report();
                problems.push(format!("{design}/{name}, seed {seed}:\n{report}"));
            }
        }
    }
    let mut failed = BTreeSet::new();
    for wrong in wrong_answers(name) {
        for seed in 0..seeds {
            let judgement = judged(sheet, &wrong.variant, seed, Facts::UntilOneFails);
            let fails = judgement.first_failure().map_or("", |fact| &fact.name);
            if fails != wrong.fails {
                let Wrong { forgets, fails, .. } = &wrong;
                let report = judgement.report();
                problems.push(format!(
                    "{forgets}, seed {seed}: must fail first at {fails}\n{report}"
                ));
            }
            if judgement.tolerances_off() >= FAR {
                break;
            }
        }
        failed.insert(wrong.fails);
    }
    for fact in &sheet.facts {
        if !failed.contains(&fact.name) {
            problems.push(format!(
                "no mistake in wrong/{name}.toml fails at {}",
                fact.name
            ));
        }
    }
    assert!(problems.is_empty(), "{}", problems.join("\n"));
}
