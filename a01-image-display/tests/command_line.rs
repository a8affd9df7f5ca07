//! The real program: exit codes, what it says, and the files that it leaves.

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};

use common::{Color, Image, Size, picture_file};
use tempfile::TempDir;

const PICTURES: [&str; 3] = [
    "a01-image-display-diagonal.png",
    "a01-image-display-painter.png",
    "a01-image-display-show-image.png",
];

/// An empty folder to run the program in.
fn folder() -> TempDir {
    tempfile::tempdir().expect("a folder")
}

fn program(folder: &TempDir, line: &str) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_a01-image-display"));
    command
        .args(line.split_whitespace())
        .current_dir(folder)
        .env_remove("DISPLAY")
        .env_remove("WAYLAND_DISPLAY");
    let opens_no_window = ["list", "render", "--help"].map(|start| line.starts_with(start));
    if ALWAYS_A_DISPLAY && !opens_no_window.contains(&true) {
        command.arg("--no-window");
    }
    command
}

/// Whether the display cannot be taken from the program, but only declined.
const ALWAYS_A_DISPLAY: bool = cfg!(any(windows, target_os = "macos"));

/// Exit code, stdout and stderr of the program with these arguments.
fn run(folder: &TempDir, line: &str) -> (i32, String, String) {
    let output = program(folder, line).output().expect("the program runs");
    let text = |bytes| String::from_utf8(bytes).expect("text");
    let (said, complaint) = (text(output.stdout), text(output.stderr));
    let code = output.status.code().expect("an exit code");
    (code, said, complaint)
}

/// The names of all files and folders below, sorted.
fn left(folder: &TempDir) -> Vec<String> {
    fn walk(root: &Path, folder: &Path, names: &mut Vec<String>) {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            let name = path.strip_prefix(root).unwrap();
            names.push(name.to_str().unwrap().replace('\\', "/"));
            if path.is_dir() {
                walk(root, &path, names);
            }
        }
    }
    let mut names = Vec::new();
    walk(folder.path(), folder.path(), &mut names);
    names.sort();
    names
}

fn open(folder: &TempDir, name: &str) -> Image {
    picture_file::open(&folder.path().join(name)).expect("a whole picture")
}

fn test_card() -> Vec<u8> {
    fs::read(concat!(env!("CARGO_MANIFEST_DIR"), "/assets/test-card.png")).unwrap()
}

/// The program must end with this code and one sentence that holds `sentence`,
/// say nothing else, and leave the files as they were.
fn assert_refused(folder: &TempDir, line: &str, code: i32, sentence: &str) {
    let before = left(folder);
    let (ended, said, complaint) = run(folder, line);
    assert!(complaint.contains(sentence), "{line}: {complaint}");
    assert_eq!(complaint.matches("error: ").count(), 1, "{complaint}");
    assert_eq!(ended, code, "{line}: {complaint}");
    assert_eq!(said, "", "{line}");
    assert_eq!(left(folder), before, "{line}");
}

#[test]
fn list_names_every_scene_on_a_line() {
    let folder = folder();
    let (code, said, complaint) = run(&folder, "list");
    let names = said.lines().map(|line| line.split("  ").next().unwrap());
    assert!(names.eq(["diagonal", "painter", "show-image"]), "{said}");
    assert_eq!((code, complaint.as_str()), (0, ""));
    assert!(left(&folder).is_empty());
}

#[test]
fn render_all_fills_the_folder_out_and_says_where() {
    let folder = folder();
    let (code, said, complaint) = run(&folder, "render --all --size 32x24");
    assert_eq!(code, 0, "{complaint}");
    let note = "note: --size changes nothing in show-image\n";
    assert_eq!(complaint, note);
    let paths = PICTURES.map(|name| Path::new("out").join(name));
    assert_eq!(said.lines().count(), 3, "{said}");
    for (line, path) in said.lines().zip(&paths) {
        assert!(line.starts_with(path.to_str().unwrap()), "{line}");
    }
    let files = PICTURES.map(|name| format!("out/{name}"));
    assert_eq!(left(&folder)[1..], files);
    let sizes = files.map(|name| open(&folder, &name).size().to_string());
    assert_eq!(sizes, ["32x24", "32x24", "640x480"]);
}

#[test]
fn renderers_that_exclude_each_other_are_refused() {
    let folder = folder();
    let both = "render painter --fast --no-omit";
    assert_refused(&folder, both, 2, "cannot be used with");
    let alone = "render painter --explain --no-omit";
    assert_refused(&folder, alone, 2, "give --explain without --no-omit");
}

#[test]
fn one_scene_goes_to_the_file_that_is_named_and_replaces_it() {
    let folder = folder();
    fs::write(folder.path().join("mine.PNG"), "old").unwrap();
    let (code, said, _) = run(&folder, "render painter --size 1x1 -o mine.PNG");
    assert_eq!(code, 0);
    assert!(said.starts_with("mine.PNG  1x1"), "{said}");
    assert_eq!(left(&folder), ["mine.PNG"]);
    assert_eq!(open(&folder, "mine.PNG").pixels(), [Color::RED]);
}

#[test]
fn several_scenes_go_to_the_folder_that_is_named() {
    let folder = folder();
    fs::create_dir(folder.path().join("there")).unwrap();
    let (code, _, complaint) = run(&folder, "render painter diagonal -o there");
    assert_eq!((code, complaint.as_str()), (0, ""));
    let expected = PICTURES[..2].iter().map(|name| format!("there/{name}"));
    assert!(left(&folder).into_iter().skip(1).eq(expected));
}

#[test]
fn an_output_that_cannot_be_meant_is_refused() {
    let folder = folder();
    let wanted = "must be a folder that exists or the name of a PNG file";
    for line in ["render diagonal -o missing", "render diagonal -o name.jpg"] {
        assert_refused(&folder, line, 2, wanted);
    }
    let line = "render --all -o one.png";
    assert_refused(&folder, line, 2, "one picture, not 3; give a folder");
}

/// The picture to open is missing, too, which only the rendering would notice.
#[test]
fn an_output_that_cannot_be_written_is_refused_before_the_rendering() {
    let folder = folder();
    fs::write(folder.path().join("file"), "").unwrap();
    let lost = "render show-image --open nowhere.png";
    let line = format!("{lost} -o missing/a.png");
    assert_refused(&folder, &line, 1, "no folder missing; create it first");
    let line = format!("{lost} -o file/a.png");
    assert_refused(&folder, &line, 1, "file is a file, not a folder");

    fs::write(folder.path().join("out"), "").unwrap();
    assert_refused(&folder, lost, 1, "out is a file, not a folder");

    fs::create_dir_all(folder.path().join("there").join(PICTURES[2])).unwrap();
    let line = format!("{lost} -o there");
    assert_refused(&folder, &line, 1, "a folder has this name");
}

#[test]
#[cfg(target_os = "linux")]
fn a_folder_that_takes_no_files_is_named() {
    let folder = folder();
    let line = "render show-image --open nowhere.png -o /proc";
    assert_refused(&folder, line, 1, "no file can be made in /proc");
    for line in ["render diagonal", "show diagonal"] {
        let output = program(&folder, line).current_dir("/proc").output();
        let output = output.expect("the program runs");
        let complaint = String::from_utf8_lossy(&output.stderr);
        let sentence = "cannot write out: no file can be made in . (";
        assert!(complaint.contains(sentence), "{complaint}");
        assert_eq!(output.status.code(), Some(1));
    }
}

#[test]
fn a_scene_that_is_not_there_is_answered_with_those_that_are() {
    let folder = folder();
    let names = "no scene \"cube\"; it has diagonal, painter, show-image";
    for line in ["show cube", "render diagonal cube"] {
        assert_refused(&folder, line, 2, names);
    }
    for line in ["show", "render"] {
        assert_refused(&folder, line, 2, "<SCENE");
    }
}

#[test]
fn values_out_of_range_are_answered_with_the_range() {
    let folder = folder();
    for (line, sentence) in [
        ("--size 0x0", "from 1 to 32768 pixels a side"),
        ("--size 99999x99999", "from 1 to 32768 pixels a side"),
        ("--size 16384x16384", "at most 8192x8192 in all"),
        ("--size abc", "WIDTHxHEIGHT, such as 640x480"),
        ("--depth 0", "1.."),
        ("--samples 0", "1..=1000000"),
        ("--threads 0", "1..=1024"),
        ("--samples 5", "4 and 9 do"),
        ("--max-error 0", "above 0 and at most 1"),
        ("--max-error 3/2", "above 0 and at most 1"),
        ("--max-error 1/510 --sampling random", "cannot be used with"),
        ("--transfer loud", "linear, gamma, srgb"),
    ] {
        for command in ["render painter", "show painter", ""] {
            assert_refused(&folder, &format!("{command} {line}"), 2, sentence);
        }
    }
}

#[test]
fn pictures_that_cannot_be_opened_leave_no_file() {
    let folder = folder();
    let card = test_card();
    let file = |name: &str| folder.path().join(name);
    fs::write(file("half.png"), &card[..card.len() / 2]).unwrap();
    fs::write(
        file("corrupt.png"),
        [&card[..200], b"?", &card[201..]].concat(),
    )
    .unwrap();
    fs::write(file("old.png"), &card).unwrap();
    for (name, reason) in [
        ("missing.png", "there is no such file"),
        ("half.png", "the file ends too early"),
        ("corrupt.png", "the file is damaged"),
    ] {
        let sentence = format!("cannot open {name}: {reason}");
        for command in [
            "render show-image",
            "render show-image -o old.png",
            "show show-image",
        ] {
            let line = format!("{command} --open {name}");
            assert_refused(&folder, &line, 1, &sentence);
            // Not even a window is missed.
            let (_, _, complaint) = run(&folder, &line);
            assert!(complaint.starts_with("error: "), "{complaint}");
        }
    }
    assert_eq!(fs::read(file("old.png")).unwrap(), card);
}

#[test]
fn a_picture_that_opens_is_written_as_it_is() {
    let folder = folder();
    fs::write(folder.path().join("card.jpg"), test_card()).unwrap();
    let line = "render show-image --open card.jpg -o copy.png";
    let (code, _, complaint) = run(&folder, line);
    assert_eq!((code, complaint.as_str()), (0, ""));
    assert_eq!(open(&folder, "copy.png"), open(&folder, "card.jpg"));
    assert_eq!(open(&folder, "copy.png").size(), Size::COURSE);
}

#[test]
fn without_a_display_the_picture_lands_in_a_file() {
    let folder = folder();
    let (code, said, complaint) = run(&folder, "show painter --size 8x6");
    assert_eq!(code, 0);
    if !ALWAYS_A_DISPLAY {
        let reason = if cfg!(feature = "window") {
            "no display to open it on ("
        } else {
            "this build has none"
        };
        let start = format!("no window: {reason}");
        assert!(complaint.starts_with(&start), "{complaint}");
        assert_eq!(complaint.lines().count(), 1, "{complaint}");
    }
    let path = Path::new("out").join(PICTURES[1]);
    assert_eq!(said, format!("{}  8x6\n", path.display()));
    assert_eq!(
        left(&folder),
        ["out".into(), format!("out/{}", PICTURES[1])]
    );

    let occupied = self::folder();
    fs::write(occupied.path().join("out"), "").unwrap();
    assert_refused(&occupied, "show painter", 1, "out is a file, not a folder");
}

#[test]
fn a_window_that_is_declined_is_no_complaint() {
    let folder = folder();
    for line in [
        "--no-window --size 8x6",
        "show diagonal --no-window --size 8x6",
    ] {
        let (code, said, complaint) = run(&folder, line);
        assert_eq!((code, complaint.as_str()), (0, ""));
        assert!(said.contains(PICTURES[0]), "{said}");
    }
}

#[test]
fn who_shows_no_file_is_told_how() {
    let folder = folder();
    let (code, _, complaint) = run(&folder, "show show-image --no-window");
    assert_eq!(code, 0);
    assert!(complaint.contains("--open FILE shows one"), "{complaint}");
}

#[test]
fn flags_that_change_nothing_are_noted() {
    let folder = folder();
    let flags = "--depth 3 --samples 4 --sampling random --seed 1 --open x.png";
    let (code, _, complaint) = run(&folder, &format!("render diagonal {flags} -o a.png"));
    assert_eq!(code, 0);
    let note = |flag| format!("note: {flag} changes nothing in diagonal\n");
    let notes = ["--samples", "--sampling", "--seed", "--depth", "--open"].map(note);
    assert_eq!(complaint, notes.concat());
    let (_, _, complaint) = run(&folder, "render diagonal --max-error 1/510 -o c.png");
    assert_eq!(complaint, note("--max-error"));
    let (_, _, complaint) = run(
        &folder,
        "render diagonal -o b.png --threads 1 --transfer srgb",
    );
    assert_eq!(complaint, "");
    assert_eq!(open(&folder, "a.png"), open(&folder, "b.png"));
}

/// A pipe whose other end is closed already.
fn closed() -> Stdio {
    let (reader, writer) = std::io::pipe().expect("a pipe");
    drop(reader);
    writer.into()
}

#[test]
fn nobody_listening_is_no_reason_to_panic() {
    let folder = folder();
    for line in ["list", "--help", "render diagonal"] {
        let output = program(&folder, line).stdout(closed()).output().unwrap();
        assert_eq!(String::from_utf8_lossy(&output.stderr), "", "{line}");
        assert_eq!(output.status.code(), Some(0), "{line}");
    }
    for (line, code) in [
        ("show cube", 2),
        ("--size 0x0", 2),
        ("render show-image --open missing.png", 1),
        ("render diagonal --depth 3", 0),
        ("show diagonal", 0),
    ] {
        let status = program(&folder, line)
            .stdout(closed())
            .stderr(closed())
            .status();
        assert_eq!(status.unwrap().code(), Some(code), "{line}");
    }
}
