//! Each package, test, command, path and file that a Markdown file names exists.

use std::path::Path;

use crate::files::{Files, PAGES, complaint, ending};

/// The commands of Cargo itself that the texts name.
const CARGO: &str = "add bench build check clippy doc fmt install new run test";

/// Cargo's commands of this repository, and the file with their own commands.
const OURS: [(&str, &str); 4] = [
    ("book", "book/builder/src/main.rs"),
    ("course", "common/course/src/main.rs"),
    ("learn", "common/learn/src/lib.rs"),
    ("record", ""),
];

/// What is named, and is not there.
pub fn complaints(files: &Files) -> Vec<String> {
    let manifests: Vec<_> = files
        .below("")
        .filter(|(path, _)| path.ends_with("Cargo.toml"))
        .collect();
    let is_package = |name: &str| {
        let line = format!("name = \"{name}\"\n");
        manifests.iter().any(|(_, text)| text.contains(&line))
    };
    let ends_a_path = |end: &str| files.below("").any(|(path, _)| path.ends_with(end));
    let mut found = Vec::new();
    for (page, text) in files.below("").filter(|(path, _)| ending(path) == "md") {
        for span in text.split('`') {
            let mut before = ["", ""];
            for word in span.split(|c: char| c.is_whitespace() || "(),;|\"[]<>".contains(c)) {
                let name = word.trim_end_matches(['.', ':', '?', '!', '…']);
                if name.is_empty() {
                    // A gap in a table of commands.
                    before = ["", ""];
                    continue;
                }
                let exists = match before {
                    _ if is_placeholder(name) => true,
                    [_, "-p" | "--package"] => is_package(name),
                    [_, "--test"] => {
                        let file = format!("/tests/{name}.rs");
                        ends_a_path(&file) || ends_a_path(&format!("/tests/{name}/main.rs"))
                    }
                    [_, "--example"] => ends_a_path(&format!("/examples/{name}.rs")),
                    [_, "cargo"] if is_word(name) => {
                        CARGO.split(' ').any(|command| command == name)
                            || OURS.iter().any(|(command, _)| *command == name)
                    }
                    ["cargo", ours] if is_word(name) => {
                        let main = OURS.iter().find(|(command, _)| *command == ours);
                        let main = main.and_then(|(_, main)| files.text(main));
                        let exercise = format!("/exercises/solutions/{name}.rs");
                        main.is_none_or(|main| has_variant(main, name)) || ends_a_path(&exercise)
                    }
                    _ => is_there(page, name, &ends_a_path),
                };
                if !exists {
                    let at = word.as_ptr() as usize - text.as_ptr() as usize;
                    let message = format!("there is no {name}, as \"{} {name}\" says", before[1]);
                    found.push(complaint(page, text, at, &message));
                }
                before = [before[1], name];
            }
        }
    }
    found
}

/// Whether a word stands for another one, as the NAME of a recipe, or for several.
fn is_placeholder(word: &str) -> bool {
    let mut parts = word.split(['/', '.', '-', '_']);
    let is_name = |part: &str| part.len() > 2 && part.bytes().all(|byte| byte.is_ascii_uppercase());
    let is_ours = ["README", "CONTRIBUTING", "CHANGELOG", "LICENSE", "SUMMARY"];
    parts.any(|part| is_name(part) && !is_ours.contains(&part))
        || word.contains(['*', '{', '}', '…', '$'])
}

fn is_word(word: &str) -> bool {
    word.bytes().all(|byte| byte.is_ascii_lowercase())
}

/// Whether a program has the command `name`, which is a variant of an enum.
fn has_variant(main: &str, name: &str) -> bool {
    let (first, rest) = name.split_at(1);
    let variant = format!("    {}{rest}", first.to_ascii_uppercase());
    main.lines().any(|line| {
        line.strip_prefix(&*variant)
            .is_some_and(|end| !end.starts_with(char::is_alphanumeric))
    })
}

/// Whether a path from the top, or the name of a file in a text for contributors, is there. Other words are.
fn is_there(page: &str, word: &str, ends_a_path: &dyn Fn(&str) -> bool) -> bool {
    let path = word.split(['#', ':']).next().unwrap_or_default();
    let tops = ["a0", "book/", "common/", ".ci/", ".cargo/"];
    if path.contains('/') && tops.iter().any(|top| path.starts_with(top)) {
        let is_built = ending(path) == "html";
        return is_built
            || Path::new(env!("CARGO_MANIFEST_DIR"))
                .join("..")
                .join(path)
                .exists();
    }
    let is_file = matches!(
        ending(path),
        "rs" | "toml" | "md" | "txt" | "mjs" | "js" | "csv" | "json"
    );
    let is_for_students = page.starts_with(PAGES) || page.starts_with("common/course/handout/");
    let is_relative = path.starts_with('.');
    !is_file
        || is_for_students
        || is_relative
        || ends_a_path(&format!("/{path}"))
        || ends_a_path(path)
}
