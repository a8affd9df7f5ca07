//! Command lines: names that are refused, and the texts that are written.

use std::fs;
use std::process::Command;

use tempfile::TempDir;

/// A scene file written by hand.
const MINE: &str = "# mine\n[camera]\neye = [0, 0, 5]\ngaze = [0, 0, -1]\nangle = 40\n\
                    [[sphere]]\ncenter = [0, 0, 0]\nradius = 1\ncolor = \"red\"\n";

/// Command lines, and the beginnings of what they say. Each file of the folder has the text of `mine.toml`.
const REFUSED: &str = r#"
export disc --to toml -o mine.toml => mine.toml is there and has another text; it is kept
export mine.toml --to toml -o mine.toml => mine.toml is read by this command
export mine.toml --to toml -o ./mine.toml --replace => mine.toml is read by this command
export disc --to povray -o mine.toml => mine.toml must be the name of a file that ends in .pov
export disc --to povray -o mine.toml --replace => mine.toml must be
export disc --to povray -o mine.pov => mine.pov is there and has another text
export disc --to toml -o mine.pov => mine.pov must be the name of a file that ends in .toml
export disc --to toml -o - => - must be the name of a file that ends in .toml
export disc --to toml -o new => new must be the name of a file that ends in .toml
export disc --to toml -o there/new.toml => cannot write there/new.toml: there is no folder there
explain disc --pixel 1,1 --drawing mine.svg => mine.svg is there and has another text
explain disc --pixel 1,1 --drawing mine.toml => mine.toml must be the name of a file that ends in .svg
explain disc --pixel 1,1 --drawing - => - must be
render disc -o mine.toml => -o mine.toml must be a folder or the name of a PNG file
render disc.toml => there is no file disc.toml, but disc is a scene of a07-transforms
render mine => a07-transforms has no scene "mine"; the nearest is mine.toml; it has
"#;

/// Runs the program in a folder. Returns its messages and its exit code.
fn run(folder: &TempDir, line: &str) -> (String, Option<i32>) {
    let mut program = Command::new(env!("CARGO_BIN_EXE_a07-transforms"));
    program.args(line.split(' ')).args(["--size", "8x6"]);
    let output = program.current_dir(folder).output().unwrap();
    (
        String::from_utf8(output.stderr).unwrap(),
        output.status.code(),
    )
}

#[test]
fn a_text_that_is_there_is_kept_unless_it_is_to_be_replaced() {
    let folder = tempfile::tempdir().unwrap();
    let mine = ["mine.toml", "mine.pov", "mine.svg"].map(|name| folder.path().join(name));
    for file in &mine {
        fs::write(file, MINE).unwrap();
    }
    for row in REFUSED.trim().lines() {
        let (line, reason) = row.split_once(" => ").expect(row);
        let (said, code) = run(&folder, line);
        assert!(
            said.starts_with(&format!("error: {reason}")),
            "{line}: {said}"
        );
        assert!(code != Some(0), "{line}");
        for file in &mine {
            assert_eq!(fs::read_to_string(file).unwrap(), MINE, "{line}");
        }
        assert_eq!(fs::read_dir(&folder).unwrap().count(), mine.len(), "{line}");
    }
    for (line, file, begin) in [
        ("export disc --to toml -o new.TOML", "new.TOML", "[picture]"),
        ("export disc --to toml -o new.TOML", "new.TOML", "[picture]"),
        (
            "export disc --to toml -o mine.toml --replace",
            "mine.toml",
            "[picture]",
        ),
        (
            "export disc --to povray -o mine.pov --replace",
            "mine.pov",
            "// povray",
        ),
        (
            "explain disc --pixel 1,1 --drawing mine.svg --replace",
            "mine.svg",
            "<svg",
        ),
        (
            "explain disc --pixel 2,2 --drawing mine.svg",
            "mine.svg",
            "<svg",
        ),
    ] {
        let (said, code) = run(&folder, line);
        assert_eq!(
            (&*said, code),
            (&*format!("note: {file} is written\n"), Some(0)),
            "{line}"
        );
        let written = fs::read_to_string(folder.path().join(file)).unwrap();
        assert!(written.starts_with(begin), "{line}: {written}");
    }
}

#[cfg(unix)]
#[test]
fn links_to_nothing_are_called_so() {
    let folder = tempfile::tempdir().unwrap();
    for (link, line, reason) in [
        (
            "gone.toml",
            "render gone.toml",
            "cannot open gone.toml: it is a link to nothing",
        ),
        (
            "gone",
            "render disc -o gone",
            "cannot write gone: it is a link to a folder that is not there",
        ),
    ] {
        std::os::unix::fs::symlink("nowhere", folder.path().join(link)).unwrap();
        let (said, code) = run(&folder, line);
        assert_eq!((said, code), (format!("error: {reason}\n"), Some(1)));
    }
}
