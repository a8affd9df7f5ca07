//! `cut`: leaves tests and laboratories out of a handout.
//!
//! They are the items of `cfg(not(handout))` and of `cfg(test)`, the modules of the stages that
//! join them with laboratories, engine and scene files, lines that name these modules, and the
//! files of all these modules. Items stand on lines of their own, as `rustfmt` writes them.

use std::collections::BTreeMap;

/// The crates that only laboratories use, which manifests do not name then.
const CRATES: [&str; 2] = ["engine", "scene-file"];

/// The words of lines that name the modules, or say that a stage has no such module.
#[rustfmt::skip]
const JOINTS: [&str; 9] = [
    "mod lab;", " lab::", "::lab::", "mod fast;", "::fast::", "mod from_file;", "::from_file::",
    "open: None,", "search: None,",
];

/// Leaves these items, modules and crates out of files, which are given by their paths.
pub fn cut(files: &mut BTreeMap<String, Vec<u8>>) {
    let is_kept = |line: &&str| {
        line.split('.')
            .next()
            .is_none_or(|it| !CRATES.contains(&it))
    };
    let mut modules = Vec::new();
    for (path, bytes) in &mut *files {
        let text = String::from_utf8_lossy(bytes);
        let lines = match path.rsplit_once('.') {
            Some((module, "rs")) => without_items(module, &text, &mut modules),
            Some((_, "toml")) => text.lines().filter(is_kept).collect(),
            _ => continue,
        };
        *bytes = (lines.join("\n").trim_end().to_owned() + "\n").into();
    }
    files.retain(|path, _| !modules.iter().any(|module| path.starts_with(module)));
}

/// The lines of a module without the items. Adds the beginnings of the paths of modules among
/// them.
fn without_items<'a>(path: &str, text: &'a str, modules: &mut Vec<String>) -> Vec<&'a str> {
    let folder = path.trim_end_matches("/lib").trim_end_matches("/main");
    let indent = |line: &str| line.len() - line.trim_start().len();
    let names = |line: &str, words: &[&str]| words.iter().any(|word| line.contains(word));
    let (mut kept, mut lines) = (Vec::new(), text.lines());
    while let Some(line) = lines.next() {
        let is_end = |next: &&str| {
            let is_code = !next.trim().starts_with(['/', '#']);
            is_code && indent(next) == indent(line) && next.ends_with([';', ',', '}'])
        };
        let is_marked =
            line.trim().starts_with("#[cfg(") && names(line, &["not(handout)", "(test)"]);
        if is_marked || names(line, &JOINTS) && is_end(&line) {
            let end = if is_marked {
                lines.find(is_end)
            } else {
                Some(line)
            };
            let name = end.and_then(|end| end.split_once("mod ")?.1.strip_suffix(';'));
            modules.extend(
                name.iter()
                    .flat_map(|name| [".rs", "/"].map(|end| [folder, "/", name, end].concat())),
            );
            while kept
                .pop_if(|line: &mut &str| line.trim().starts_with(['/', '#']))
                .is_some()
            {}
        } else if line.trim() != "#[cfg(handout)]" {
            // As `rustfmt` does.
            kept.pop_if(|before| before.is_empty() && ["", "}"].contains(&line.trim()));
            kept.push(line);
        }
    }
    kept
}
