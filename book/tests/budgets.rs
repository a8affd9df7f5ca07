//! The lines of Rust that each part of the workbook may have, so that the lessons are not lost
//! in the rest. A part that needs more says in its commit which other lines left for it.

use crate::files::Files;
use crate::lessons::is_lesson;

/// Parts, a word by which the paths of their files are known, and their most lines. A file
/// belongs to the first part that fits.
const BUDGETS: [(&str, &[&str], usize); 12] = [
    (
        "for lecturers",
        &[
            "common/learn/src/course",
            "common/testing/src/exercise/replay",
            "common/testing/src/exercise/tape",
        ],
        873,
    ),
    (
        "exercises with their checks, and cargo learn",
        &[
            "/exercises/",
            "common/testing/src/exercise",
            "common/learn/",
        ],
        7_907,
    ),
    ("benchmarks", &["/benches/"], 1_329),
    ("labs", &["/lab/src/", "/src/instruments"], 7_111),
    ("engine", &["common/engine/"], 7_236),
    (
        "reader and writer of scene files",
        &["common/scene-file/"],
        1_164,
    ),
    (
        "common, program, measure and testing",
        &[
            "common/src/",
            "common/program/src/",
            "common/measure/src/",
            "common/testing/src/",
        ],
        8_282,
    ),
    ("tests of common and program", &["common/"], 322),
    ("fuzz targets", &["fuzz/"], 598),
    ("checks of the book", &["book/tests/"], 438),
    ("live pages", &["book/live/"], 1_753),
    ("tests of the stages", &["/tests/"], 4_418),
];

/// The most lines of all files, and of one.
const OF_ALL: usize = 49_292;
const OF_A_FILE: usize = 300;

/// The most lines of all lessons, of one lesson file, and of the loop over the pixels.
const OF_LESSONS: usize = 3_600;
const OF_A_LESSON: usize = 200;
const OF_RENDER: usize = 80;

/// The files and parts that are larger than they may be.
pub fn complaints(files: &Files) -> Vec<String> {
    let mut parts = BUDGETS.map(|(part, _, most)| (part, 0, most)).to_vec();
    parts.extend([
        ("all lessons", 0, OF_LESSONS),
        ("all Rust files", 0, OF_ALL),
    ]);
    let mut of_files = Vec::new();
    for (path, text) in files.rust() {
        let (lines, is_lesson) = (text.lines().count(), is_lesson(path));
        let most = match path {
            "a03-rays-cameras/src/render.rs" => OF_RENDER,
            _ if is_lesson => OF_A_LESSON,
            _ => OF_A_FILE,
        };
        of_files.push((path, lines, most));
        let fits = |(_, words, _): &(_, &[&str], _)| words.iter().any(|word| path.contains(word));
        let part = BUDGETS.iter().position(fits);
        let lessons = is_lesson.then_some(BUDGETS.len());
        for part in part.into_iter().chain(lessons).chain([BUDGETS.len() + 1]) {
            parts[part].1 += lines;
        }
    }
    let all = parts.into_iter().chain(of_files);
    all.filter(|(_, lines, most)| lines > most)
        .map(|(part, lines, most)| format!("{part}: {lines} lines, at most {most}"))
        .collect()
}
