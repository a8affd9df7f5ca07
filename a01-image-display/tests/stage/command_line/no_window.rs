//! The program without a window, and with a closed pipe for its output.

use std::path::Path;
use std::process::Stdio;

use super::{ALWAYS_A_DISPLAY, PICTURES, folder, left, program, run};

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
}

#[test]
fn no_window_prints_no_warning() {
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
fn without_a_file_a_hint_names_the_flag() {
    let folder = folder();
    let (code, _, complaint) = run(&folder, "show show-image --no-window");
    assert_eq!(code, 0);
    assert!(complaint.contains("--open FILE shows one"), "{complaint}");
}

/// A pipe whose other end is closed already.
fn closed() -> Stdio {
    let (reader, writer) = std::io::pipe().expect("a pipe");
    drop(reader);
    writer.into()
}

#[test]
fn a_closed_pipe_is_no_error() {
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
