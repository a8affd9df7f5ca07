//! `cut`: leaves tests and laboratories out of a handout.
//!
//! They are files, with the lines of other files that name their modules, and the items of
//! `cfg(not(handout))` and `cfg(test)`. Items stand on lines of their own, as `rustfmt` writes
//! them.

use std::collections::{BTreeMap, BTreeSet};

/// Parts of the paths of files that are not handed out.
#[rustfmt::skip]
const LABS: &[&str] = &[
    "/examples/", "/lab/", "/tests.rs",
    "common/testing/src/display.rs", "common/testing/src/picture_lock",
    "common/testing/src/refusal.rs",
    "common/learn/handout/", "common/learn/src/book.rs", "common/learn/src/course",
];

/// Whether a line of a manifest is about one of their crates.
fn is_of_crate(line: &str) -> bool {
    let (name, _) = line.split_once('.').unwrap_or_default();
    name.ends_with("-lab")
}

/// Leaves all this out of files, which are given by their paths.
pub fn cut(files: &mut BTreeMap<String, Vec<u8>>) {
    let is_cut = |path: &str| LABS.iter().any(|part| path.contains(part));
    let cut: Vec<_> = files.extract_if(.., |path, _| is_cut(path)).collect();
    let modules: BTreeSet<_> = cut
        .iter()
        .filter_map(|(path, _)| module(path, files))
        .collect();
    for (path, bytes) in files {
        let text = String::from_utf8_lossy(bytes);
        let lines = match path.rsplit_once('.') {
            Some((_, "rs")) => without_items(&text, &modules),
            Some((_, "toml")) => text.lines().filter(|line| !is_of_crate(line)).collect(),
            _ => continue,
        };
        *bytes = (lines.join("\n").trim_end().to_owned() + "\n").into();
    }
}

/// The module of a file, if one of the other files declares it.
fn module<'a>(path: &'a str, others: &BTreeMap<String, Vec<u8>>) -> Option<&'a str> {
    let (folder, name) = path.strip_suffix(".rs")?.rsplit_once('/')?;
    let mut parents = [".rs", "/lib.rs", "/main.rs"]
        .map(|end| format!("{folder}{end}"))
        .into_iter();
    parents
        .any(|path| others.contains_key(&path))
        .then_some(name)
}

/// Whether a line declares a module, or names an item of it.
fn is_about(line: &str, module: &str) -> bool {
    let is_whole = |before: &str| !before.ends_with(|c: char| c.is_alphanumeric() || c == '_');
    let path = format!("{module}::");
    let mut paths = line.match_indices(&path);
    paths.any(|(at, _)| is_whole(&line[..at])) || line.ends_with(&format!("mod {module};"))
}

/// The lines of a text without marked items, and without lines about these modules.
fn without_items<'a>(text: &'a str, modules: &BTreeSet<&str>) -> Vec<&'a str> {
    let indent = |line: &str| line.len() - line.trim_start().len();
    let (mut kept, mut lines) = (Vec::new(), text.lines());
    while let Some(line) = lines.next() {
        let is_end = |next: &&str| {
            let is_code = !next.trim().starts_with(['/', '#']);
            is_code && indent(next) == indent(line) && next.ends_with([';', ',', '}'])
        };
        let is_marked = ["#[cfg(not(handout))]", "#[cfg(test)]"].contains(&line.trim());
        let is_left_out = is_end(&line) && modules.iter().any(|module| is_about(line, module));
        if is_marked {
            lines.find(is_end);
        }
        if is_marked || is_left_out {
            let is_head = |line: &mut &str| line.trim().starts_with(['/', '#']);
            while kept.pop_if(is_head).is_some() {}
        } else if line.trim() != "#[cfg(handout)]" {
            // As `rustfmt` does.
            kept.pop_if(|before| before.is_empty() && ["", "}"].contains(&line.trim()));
            kept.push(line);
        }
    }
    kept
}
