//! The texts that the program writes, by the command line.

use std::fs;
use std::process::Command;

/// A scene file written by hand.
const MINE: &str = "# mine\n[camera]\neye = [0, 0, 5]\ngaze = [0, 0, -1]\nangle = 40\n\
                    [[sphere]]\ncenter = [0, 0, 0]\nradius = 1\ncolor = \"red\"\n";

/// Command lines and the beginnings of what they say. Each file of the folder has the text of `mine.toml`.
const REFUSED: [[&str; 2]; 14] = [
    [
        "export disc --to toml -o mine.toml",
        "error: mine.toml is there and has another text; it is kept",
    ],
    [
        "export mine.toml --to toml -o mine.toml",
        "error: mine.toml is read by this command",
    ],
    [
        "export mine.toml --to toml -o ./mine.toml --replace",
        "error: mine.toml is read by this command",
    ],
    [
        "export disc --to povray -o mine.toml",
        "error: mine.toml must be the name of a file that ends in .pov",
    ],
    [
        "export disc --to povray -o mine.toml --replace",
        "error: mine.toml must be",
    ],
    [
        "export disc --to povray -o mine.pov",
        "error: mine.pov is there and has another text",
    ],
    [
        "export disc --to toml -o mine.pov",
        "error: mine.pov must be the name of a file that ends in .toml",
    ],
    [
        "export disc --to toml -o -",
        "error: - must be the name of a file that ends in .toml",
    ],
    [
        "export disc --to toml -o new",
        "error: new must be the name of a file that ends in .toml",
    ],
    [
        "export disc --to toml -o there/new.toml",
        "error: cannot write there/new.toml: there is no folder there",
    ],
    [
        "explain disc --pixel 1,1 --drawing mine.svg",
        "error: mine.svg is there and has another text",
    ],
    [
        "explain disc --pixel 1,1 --drawing mine.toml",
        "error: mine.toml must be the name of a file that ends in .svg",
    ],
    ["explain disc --pixel 1,1 --drawing -", "error: - must be"],
    [
        "render disc -o mine.toml",
        "error: -o mine.toml must be a folder or the name of a PNG file",
    ],
];

#[test]
fn a_text_that_is_there_is_kept_unless_it_is_to_be_replaced() {
    let folder = tempfile::tempdir().unwrap();
    let mine = ["mine.toml", "mine.pov", "mine.svg"].map(|name| folder.path().join(name));
    for file in &mine {
        fs::write(file, MINE).unwrap();
    }
    let run = |line: &str| {
        let mut program = Command::new(env!("CARGO_BIN_EXE_a07-transforms"));
        let words = line.split(' ');
        let output = program.args(words).current_dir(&folder).output().unwrap();
        let said = String::from_utf8(output.stderr).unwrap();
        (said, output.status.code())
    };
    for [line, reason] in REFUSED {
        let (said, code) = run(&format!("{line} --size 8x6"));
        assert!(said.starts_with(reason), "{line}: {said}");
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
    ] {
        let (said, code) = run(&format!("{line} --size 8x6"));
        assert_eq!(
            (&*said, code),
            (&*format!("note: {file} is written\n"), Some(0)),
            "{line}"
        );
        let written = fs::read_to_string(folder.path().join(file)).unwrap();
        assert!(written.starts_with(begin), "{line}: {written}");
    }
}
