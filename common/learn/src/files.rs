//! The student's file of an exercise, which begins as a copy of the starter.

use std::path::{Path, PathBuf};
use std::sync::LazyLock;
use std::time::SystemTime;
use std::{env, fs, io};

use common::{text, workbook};
use proc_macro2::TokenTree;

use crate::exercise::Exercise;
use crate::tokens;

/// The folder of the workbook: of the package that `cargo run` runs, or else around the current folder.
#[must_use]
pub fn workspace() -> PathBuf {
    static WORKSPACE: LazyLock<PathBuf> = LazyLock::new(|| {
        let above = |package: &Path| package.ancestors().nth(2).unwrap_or(package).to_owned();
        if let Some(package) = env::var_os("CARGO_MANIFEST_DIR") {
            return above(package.as_ref());
        }
        let built = above(env!("CARGO_MANIFEST_DIR").as_ref());
        workbook::with_file("common/learn/Cargo.toml", &built)
    });
    WORKSPACE.clone()
}

/// A path in the workbook: in the current folder, without that of the folder.
#[must_use]
pub fn shortest(path: &str) -> PathBuf {
    let whole = workspace().join(path);
    let here = env::current_dir().unwrap_or_default();
    whole
        .strip_prefix(here)
        .map_or(whole.clone(), Path::to_owned)
}

/// The text of a file in the workbook.
pub fn read(path: &str) -> Result<String, String> {
    fs::read_to_string(shortest(path)).map_err(with_path(path.as_ref()))
}

/// The text of a student's file, which may be saved in another encoding than UTF-8.
pub(crate) fn text_of(path: &Path) -> Result<String, String> {
    let bytes = fs::read(path).map_err(with_path(path))?;
    text::from_file(bytes).map_err(|problem| format!("{}: {problem}", text::path(path)))
}

/// An error about a file as words, which begin with its path.
pub fn with_path(path: &Path) -> impl Fn(io::Error) -> String {
    move |error| format!("{}: {error}", text::path(path))
}

/// The student's file.
pub(crate) fn yours(e: &Exercise) -> PathBuf {
    shortest(&format!("{}/exercises/{}.rs", e.stage, e.name))
}

/// When the student's file was saved, and its length; none if there is no file.
pub(crate) type Saved = Option<(SystemTime, u64)>;

/// Tells a saved file from the one before.
pub(crate) fn saved(exercise: &Exercise) -> Saved {
    let file = fs::metadata(yours(exercise)).ok()?;
    Some((file.modified().ok()?, file.len()))
}

/// Where a page of the book is: in a handout as it is read, else as it is written.
pub(crate) fn page(name: &str) -> String {
    let built = format!("book/{}.html", name.trim_end_matches(".md"));
    if workspace().join(&built).exists() {
        built
    } else {
        format!("book/src/{name}")
    }
}

/// The text of the starter: the solution without its code. In a workbook without solutions, such a
/// file is a starter already.
pub fn starter(exercise: &Exercise) -> Result<String, String> {
    let file = exercise.solution_file();
    without_code(&read(&file)?).map_err(|error| format!("{file}: {error}"))
}

/// Leaves out the code of each `missing!("what", for_now, {…})`.
fn without_code(solution: &str) -> Result<String, String> {
    tokens::replace(solution, &|tokens| {
        let [_, _, TokenTree::Group(call), ..] = tokens else {
            return Ok(None);
        };
        if !tokens::begin(tokens, &["missing", "!"]) {
            return Ok(None);
        }
        let arguments: Vec<_> = call.stream().into_iter().collect();
        match &*arguments {
            [given @ .., comma, TokenTree::Group(_)] if comma.to_string() == "," => {
                let given = &solution[tokens::range(given)];
                Ok(Some((3, format!("testing::missing({given})"))))
            }
            _ => Err("a `missing!` must end with `, {`, the code, and `})`".to_owned()),
        }
    })
}

/// Whether the student has changed the file.
pub(crate) fn is_begun(exercise: &Exercise) -> bool {
    let Ok(yours) = fs::read(yours(exercise)) else {
        return false;
    };
    starter(exercise).is_ok_and(|starter| starter.as_bytes() != yours)
}

/// Writes the starter, if the student has no file yet.
pub(crate) fn begin(exercise: &Exercise) -> Result<(), String> {
    let yours = yours(exercise);
    if yours.exists() {
        return Ok(());
    }
    if yours.is_symlink() {
        let yours = text::path(&yours);
        return Err(format!(
            "{yours} is a link to a file that is missing; delete the link, or write that file"
        ));
    }
    if let Some(near) = near_name(&yours, exercise.name) {
        let [near, yours] = [near, yours].map(|path| text::path(&path));
        return Err(format!("there is {near}; rename it to {yours}"));
    }
    fs::write(&yours, starter(exercise)?).map_err(with_path(&yours))
}

/// A file beside the student's whose name an editor or a browser may have made of it, such as `mean.rs.txt`,
/// `Mean.rs` or `mean (1).rs`.
fn near_name(yours: &Path, exercise: &str) -> Option<PathBuf> {
    let plain = |name: &str| {
        let letters = name.chars().filter(|c| c.is_alphanumeric());
        letters.collect::<String>().to_lowercase()
    };
    let exercise = plain(exercise);
    let mut files = fs::read_dir(yours.parent()?).ok()?.flatten();
    let near = files.find(|file| {
        let name = plain(&file.file_name().to_string_lossy());
        let rest = name.strip_prefix(&exercise);
        let rest = rest.map(|rest| rest.trim_start_matches(|c: char| c.is_ascii_digit()));
        matches!(rest, Some("rs" | "rstxt")) && file.path() != yours
    });
    near.map(|file| file.path())
}

/// Renames the student's file, and copies the starter. Returns where both are.
pub(crate) fn reset(exercise: &Exercise) -> Result<String, String> {
    let yours = yours(exercise);
    let mut words = format!("the starter: {}", text::path(&yours));
    if is_begun(exercise) {
        let backup = free_backup(&yours);
        fs::rename(&yours, &backup).map_err(with_path(&yours))?;
        words += "\nyour file is kept: ";
        words += &text::path(&backup);
    }
    begin(exercise)?;
    Ok(words)
}

/// The first name of a backup that no file has.
fn free_backup(file: &Path) -> PathBuf {
    let mut number = 1;
    loop {
        let backup = file.with_extension(format!("{number}.bak"));
        if !backup.exists() && !backup.is_symlink() {
            return backup;
        }
        number += 1;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn starters_lack_the_code_and_nothing_else() {
        let solution = "// missing!(\"a\", 1, {\nconst A: &str = \"missing!(0, 1, {2})\";\n\
            fn f<'a>() -> Option<(char, &'a str)> {\n    missing!(\n        \"a }) b\", // It stays.\n        \
            None::<(char, &'a str)>,\n        { /* }) */ Some(('\"', r#\"})\"#)) }\n    )\n}\n";
        let starter = "// missing!(\"a\", 1, {\nconst A: &str = \"missing!(0, 1, {2})\";\n\
            fn f<'a>() -> Option<(char, &'a str)> {\n    testing::missing(\"a }) b\", // It stays.\n        \
            None::<(char, &'a str)>)\n}\n";
        assert_eq!(without_code(solution).as_deref(), Ok(starter));
        for (wrong, words) in [
            ("fn f() { missing!(\"a\", 1, 2) }", "must end with"),
            ("\nfn f() { missing!(\"a\", 1, {2} }", "line 2"),
        ] {
            let error = without_code(wrong).unwrap_err();
            assert!(error.contains(words), "{error}");
        }
    }

    #[test]
    fn a_file_of_nearly_the_name_is_found_and_no_other() {
        let folder = tempfile::tempdir().unwrap();
        let yours = folder.path().join("set_pixel.rs");
        for other in ["set_pixel.1.bak", "set_pixels.rs", "pixel.rs", "line.rs"] {
            fs::write(folder.path().join(other), "").unwrap();
        }
        assert_eq!(near_name(&yours, "set_pixel"), None);
        for near in [
            "set_pixel.rs.txt",
            "Set_Pixel.rs",
            "set-pixel.rs",
            "set_pixel (1).rs",
        ] {
            let near = folder.path().join(near);
            fs::write(&near, "").unwrap();
            assert_eq!(near_name(&yours, "set_pixel"), Some(near.clone()));
            fs::remove_file(near).unwrap();
        }
    }
}
