//! The lines of Rust that each part of the workbook may have, so that the lessons are not lost
//! in the rest. A part that needs more says in its commit which other lines left for it.

use book::{Files, ending};

/// Parts, a word by which the paths of their files are known, and their most lines. A file
/// belongs to the first part that fits.
const BUDGETS: [(&str, &[&str], usize); 9] = [
    (
        "exercises with their checks, and cargo learn",
        &[
            "/exercises/",
            "common/testing/src/exercise",
            "common/learn/",
        ],
        7_700,
    ),
    ("benchmarks", &["/benches/"], 1_700),
    ("labs", &["/src/lab/", "/src/lab.rs"], 6_200),
    ("engine", &["common/engine/"], 7_900),
    ("common, program, measure and testing", &["common/"], 6_600),
    ("fuzz targets", &["fuzz/"], 570),
    ("checks of the book", &["book/checks/", "book/tests/"], 740),
    ("live pages", &["book/live/"], 1_700),
    ("tests of the stages", &["/tests/"], 5_300),
];

/// The most lines of all files, and of one.
const OF_ALL: usize = 44_900;
const OF_A_FILE: usize = 300;

#[test]
fn no_part_is_larger_than_its_budget() {
    let files = Files::read().expect("the repository");
    let (mut lines, mut all, mut over) = ([0; BUDGETS.len()], 0, Vec::new());
    for (path, text) in files.below("").filter(|(path, _)| ending(path) == "rs") {
        // Not a student's own exercise, which no commit contains.
        let is_own = path.starts_with("a0") && path.matches('/').count() == 2;
        if is_own && path.contains("/exercises/") {
            continue;
        }
        let of_file = text.lines().count();
        if of_file > OF_A_FILE {
            over.push(format!("{path}: {of_file} lines, at most {OF_A_FILE}"));
        }
        let fits = |(_, words, _): &(_, &[&str], _)| words.iter().any(|word| path.contains(word));
        if let Some(part) = BUDGETS.iter().position(fits) {
            lines[part] += of_file;
        }
        all += of_file;
    }
    let parts = BUDGETS.iter().zip(lines);
    let parts = parts.map(|((part, _, most), lines)| (*part, lines, *most));
    for (part, lines, most) in parts.chain([("all Rust files", all, OF_ALL)]) {
        if lines > most {
            over.push(format!("{part}: {lines} lines, at most {most}"));
        }
    }
    assert!(over.is_empty(), "{}", over.join("\n"));
}
