//! Days with `cargo learn review`, a small workbook and no terminal.

use std::fs;
use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};

const WORKBOOK: &str = concat!(env!("CARGO_TARGET_TMPDIR"), "/review");

/// The two chapters, and the ids of their questions.
const CHAPTERS: [(&str, [&str; 2]); 2] = [
    ("a01-image-display", ["bytes", "rows"]),
    ("a02-math", ["angle", "length"]),
];

/// Where a file of the workbook is.
fn path(path: &str) -> String {
    [WORKBOOK, "/", path].concat()
}

fn write(file: &str, text: &str) {
    let file = path(file);
    fs::create_dir_all(Path::new(&file).parent().unwrap()).unwrap();
    fs::write(file, text).unwrap();
}

fn kept() -> String {
    String::from_utf8_lossy(&fs::read(path(".learn")).unwrap()).into_owned()
}

/// Writes the pages of both chapters, each with one exercise, which is not begun.
fn write_workbook() {
    let _ = fs::remove_dir_all(WORKBOOK);
    for (stage, ids) in CHAPTERS {
        let exercise = format!("{}_task", &stage[..3]);
        let page = format!(
            "# Exercises\n\n## Build along\n\n### The task\n\n*10 minutes, in\n\
             `{stage}/exercises/{exercise}.rs`*\n\nWrite it.\n\n\
             ```text\ncargo learn {exercise}\n```\n\n<details>\n<summary>Hint</summary>\n\nLook.\n\n\
             </details>\n\nSolution: `solution.rs`\n"
        );
        write(&format!("book/src/{}-exercises.md", &stage[..3]), &page);
        let mut chapter = format!("# Chapter {stage}\n\nWords.\n\n## Check yourself\n\nAloud.\n");
        for id in ids {
            let question = format!(
                "\n**Why {id}?**\n\n<details class=\"answer\" id=\"{id}\">\n\
                 <summary>Answer</summary>\n\nBecause of {id}.\n\n</details>\n"
            );
            chapter += &question;
        }
        write(&format!("book/src/{stage}.md"), &(chapter + "\n## Next\n"));
    }
}

/// Records that the exercise of a chapter is done.
fn finish(stage: &str) {
    let (name, text) = (format!("{}_task", &stage[..3]), "fn right() {}");
    write(&format!("{stage}/exercises/{name}.rs"), text);
    let before = fs::read_to_string(path(".learn")).unwrap_or_default();
    let hash = common::fnv1a(text.as_bytes());
    write(".learn", &format!("{before}{name} {hash:016x}\n"));
}

/// What the command prints on a day when these lines are typed, and whether it succeeds.
fn review(day: u32, typed: &str, arguments: &[&str]) -> (String, bool) {
    let mut learn = Command::new(env!("CARGO_BIN_EXE_learn"));
    learn.env("CARGO_MANIFEST_DIR", path("common/learn"));
    learn.env("LEARN_DAY", day.to_string());
    learn.current_dir(WORKBOOK).arg("review").args(arguments);
    learn
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped());
    let mut learn = learn.spawn().unwrap();
    // It may end before it has read all.
    let _ = learn.stdin.take().unwrap().write_all(typed.as_bytes());
    let output = learn.wait_with_output().unwrap();
    let printed = [output.stdout, output.stderr].concat();
    (String::from_utf8(printed).unwrap(), output.status.success())
}

/// The words must be in what is printed, in this order.
fn assert_prints((printed, succeeds): &(String, bool), words: &[&str]) {
    let mut rest = printed.as_str();
    for words in words {
        let Some((_, behind)) = rest.split_once(words) else {
            panic!("\"{words}\" is missing in:\n{printed}");
        };
        rest = behind;
    }
    assert!(succeeds, "{printed}");
}

#[test]
fn questions_come_again_when_they_are_due() {
    write_workbook();
    assert_prints(
        &review(100, "", &[]),
        &["no chapter is finished yet", "cargo learn review a01"],
    );
    finish("a01-image-display");

    // One is known, and one is not; a key that means nothing asks again.
    let first_day = review(100, "\ny\n\nx\nn\n", &[]);
    let asked = ["1 of 2", "Why bytes?", "Because of bytes.", "in 2 days"];
    assert_prints(&first_day, &asked);
    let asked = [
        "2 of 2",
        "Why rows?",
        "did you know it?",
        "did you know it?",
        "tomorrow",
    ];
    assert_prints(&first_day, &asked);
    assert_prints(
        &first_day,
        &["book/src/a01-image-display.md", "1 of 2 known"],
    );
    assert_prints(
        &review(100, "\ny\n", &[]),
        &["no question for today", "comes tomorrow"],
    );

    let second_day = review(101, "\ny\n\ny\n", &[]);
    assert_prints(
        &second_day,
        &["1 of 1", "Why rows?", "in 2 days", "1 of 1 known"],
    );
    // The end of the input, and q, leave the rest for later.
    assert_prints(
        &review(102, "\n", &[]),
        &["Because of bytes.", "nothing is answered"],
    );
    assert_prints(
        &review(102, "\ny\nq\n", &[]),
        &["in 4 days", "1 of 1 known"],
    );
    assert!(kept().contains("? bytes 3 100 102\n"), "{}", kept());
    assert!(kept().contains("? rows 2 100 101\n"), "{}", kept());

    // New questions of the next chapter come behind old ones.
    finish("a02-math");
    let words = [
        "1 of 3",
        "Why rows?",
        "Why angle?",
        "Why length?",
        "3 of 3 known",
    ];
    assert_prints(&review(103, "\ny\n\ny\n\ny\n", &[]), &words);

    // A chapter that is named is asked at once.
    assert_prints(
        &review(103, "\nn\n", &["a02"]),
        &["1 of 2", "Why angle?", "tomorrow"],
    );
    let (printed, succeeds) = review(103, "", &["a09"]);
    assert!(
        !succeeds && printed.contains("they are a01-image-display, a02-math"),
        "{printed}"
    );

    // A clock that goes back asks what is kept, and forgets nothing.
    assert_prints(
        &review(50, "\ny\n\ny\n\ny\n", &[]),
        &["1 of 3", "3 of 3 known"],
    );
    assert_eq!(kept().matches("? ").count(), 4, "{}", kept());
    assert_eq!(kept().matches(" 50\n").count(), 3, "{}", kept());

    damaged_files_are_kept();
}

fn damaged_files_are_kept() {
    let bytes = [kept().as_bytes(), b"<<<<<<< HEAD\n\xFF\xFE\n"].concat();
    fs::write(path(".learn"), bytes).unwrap();
    let printed = review(200, "\ny\n", &[]);
    assert_prints(
        &printed,
        &["1 of 1 known", "2 damaged lines, such as \"<<<<<<< HEAD\""],
    );
    let bytes = fs::read(path(".learn")).unwrap();
    assert!(bytes.ends_with(b"<<<<<<< HEAD\n\xFF\xFE\n"), "{}", kept());
    assert_eq!(kept().matches("? ").count(), 4, "{}", kept());
    assert_eq!(kept().matches("_task ").count(), 2, "{}", kept());

    // A file that cannot be read is not replaced.
    fs::remove_file(path(".learn")).unwrap();
    fs::create_dir(path(".learn")).unwrap();
    let (printed, succeeds) = review(200, "\ny\n", &["a01"]);
    assert!(!succeeds && printed.contains(".learn: "), "{printed}");
}
