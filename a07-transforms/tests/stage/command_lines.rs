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

/// Mistyped command lines, and words of what they say.
const MISTYPED: &str = r#"
show disc box-transformations => argument 'box-transformations' found | tip: this command takes one scene; `render` takes
explain disc mine.toml --pixel 1,1 => argument 'mine.toml' found | tip: this command takes one scene
show => <SCENE> | tip: the scenes are sphere-transformation, box-transformations, disc
render => <SCENES>... | tip: the scenes are sphere-transformation
explain --pixel 1,1 => <SCENE> | tip: the scenes are sphere-transformation
explain disc => --pixel <X,Y>
list disc => argument 'disc' found
dsc => unrecognized subcommand 'dsc' | tip: the scenes are sphere-transformation, box-transformations, disc; the commands are list, show
disc render => unexpected argument 'render' found | tip: the command `render` stands before the other words
help disc => unrecognized subcommand 'disc'
render disc -output p.png => -output is no flag: two hyphens begin it, as in --output
render disc –size=8x6 => –size=8x6 is no flag: two hyphens begin it, as in --size
—fast => —fast is no flag: two hyphens begin it, as in --fast
rendr disc => similar subcommands exist: 'report', 'render'
other.toml => cannot open other.toml: there is no such file
mine => a07-transforms has no scene "mine"; the nearest is mine.toml
disc.toml => there is no file disc.toml, but disc is a scene
disc --quik => unexpected argument '--quik' found
mine.toml --siez 8x6 => unexpected argument '--siez' found | tip: a similar argument exists: '--size'
render disc --no-window => unexpected argument '--no-window' found
render disc -s => unexpected argument '-s' found
render disc --width 100 => unexpected argument '--width' found
render disc --treads 2 => tip: a similar argument exists: '--threads'
show --all => unexpected argument '--all' found
report --quik => unexpected argument '--quik' found
extremes --serach => unexpected argument '--serach' found
extremes A --output x => unexpected argument '--output' found
"#;

/// Runs the program in a folder. Returns its messages and its exit code.
fn run(folder: &TempDir, line: &str) -> (String, Option<i32>) {
    run_whole(folder, &format!("{line} --size 8x6"))
}

fn run_whole(folder: &TempDir, line: &str) -> (String, Option<i32>) {
    let mut program = program(folder, line);
    let output = program.output().unwrap();
    (
        String::from_utf8(output.stderr).unwrap(),
        output.status.code(),
    )
}

fn program(folder: &TempDir, line: &str) -> Command {
    let mut program = Command::new(env!("CARGO_BIN_EXE_a07-transforms"));
    program.args(line.split(' ')).current_dir(folder);
    program
}

#[test]
fn what_is_mistyped_is_said_with_what_is_right() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("mine.toml"), MINE).unwrap();
    for row in MISTYPED.trim().lines() {
        let (line, words) = row.split_once(" => ").expect(row);
        let (said, code) = run_whole(&folder, line);
        for words in words.split(" | ") {
            assert!(said.contains(words), "{line}: {said}");
        }
        // Of these flags none is a scene or similar, and no laboratory is built for a wrong one.
        for wrong in ["as a value", "--watch'", "workbook"] {
            assert!(!said.contains(wrong), "{line}: {said}");
        }
        assert!(!line.starts_with("list") || !said.contains("tip"), "{said}");
        assert!(matches!(code, Some(1 | 2)), "{line}: {code:?}");
        assert_eq!(fs::read_dir(&folder).unwrap().count(), 1, "{line}");
    }
}

#[test]
fn a_scene_alone_is_shown() {
    let folder = tempfile::tempdir().unwrap();
    for file in ["mine.toml", "OTHER.TOML"] {
        fs::write(folder.path().join(file), MINE).unwrap();
    }
    for (line, picture) in [
        ("mine.toml --no-window", "a07-transforms-mine.png"),
        ("--no-window OTHER.TOML", "a07-transforms-OTHER.png"),
        ("disc --no-window", "a07-transforms-disc.png"),
    ] {
        let (said, code) = run(&folder, line);
        assert_eq!((&*said, code), ("", Some(0)), "{line}");
        assert!(folder.path().join("out").join(picture).exists(), "{line}");
    }
}

/// Ctrl+C and the end of a session while a picture of white rows is rendered.
#[cfg(unix)]
#[test]
fn a_rendering_that_is_stopped_leaves_the_rows_that_are_drawn() {
    use std::process::Stdio;
    use std::thread;
    use std::time::Duration;

    use common::{Color, Size, picture_file};

    let folder = tempfile::tempdir().unwrap();
    let white = MINE.replace("[[sphere]]", "[world]\nbackground = \"white\"\n[[sphere]]");
    fs::write(folder.path().join("mine.toml"), white).unwrap();
    let picture = folder.path().join("p.png");
    fs::write(&picture, "a finished picture").unwrap();
    let samples = "--samples 10000";
    for (number, (signal, flags)) in [
        ("-INT", samples.to_owned()),
        ("-TERM", format!("{samples} --fast")),
        ("-INT", format!("{samples} --no-omit")),
        (
            "-INT",
            "--fast --max-error 1e-9 --samples 1000000".to_owned(),
        ),
    ]
    .iter()
    .enumerate()
    {
        let line = format!("render mine.toml -o p.png --size 8x8192 {flags}");
        let mut program = program(&folder, &line);
        let program = program.stdout(Stdio::piped()).stderr(Stdio::piped());
        let program = program.spawn().unwrap();
        thread::sleep(Duration::from_secs(2));
        let pid = program.id().to_string();
        let killed = Command::new("kill").args([*signal, &pid]).status();
        assert!(killed.unwrap().success());
        let output = program.wait_with_output().unwrap();
        let said = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(130), "{line}: {said}");
        let name = match number {
            0 => "p-unfinished.png".to_owned(),
            number => format!("p-unfinished-{}.png", number + 1),
        };
        assert!(
            said.contains(&format!("note: {name} has the rows that were drawn\n")),
            "{said}"
        );
        assert!(
            said.ends_with("error: the rendering was stopped\n"),
            "{said}"
        );
        let kept = picture_file::open(&folder.path().join(name)).unwrap();
        assert_eq!(kept.size(), Size::new(8, 8192).unwrap());
        let rows = |color| {
            kept.rows()
                .filter(|row| row.iter().all(|pixel| *pixel == color))
                .count()
        };
        assert!(rows(Color::WHITE) > 0, "{line}");
        assert!(rows(Color::BLACK) > 0 || flags.contains("error"), "{line}");
        assert_eq!(fs::read(&picture).unwrap(), b"a finished picture");
    }
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
