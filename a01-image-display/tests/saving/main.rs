//! Saving loses nothing: if the real program is stopped while it writes, the old
//! file is there or the new one, and nothing else is left.

#![cfg(unix)]

mod limited;
mod protected;
mod together;

use std::fs;
use std::path::Path;
use std::process::Command;

use common::{Color, Image, Size, Transfer, picture_file};
use tempfile::TempDir;

/// An empty folder that every user may enter.
fn folder() -> TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    allow(folder.path(), 0o755);
    folder
}

/// Sets the permissions of a file or a folder.
fn allow(path: &Path, mode: u32) {
    let permissions = std::os::unix::fs::PermissionsExt::from_mode(mode);
    fs::set_permissions(path, permissions).expect("its own file");
}

fn program(folder: &Path, line: &str) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_a01-image-display"));
    command.args(line.split_whitespace()).current_dir(folder);
    command
}

/// The program must end with the exit code 1 and one sentence with this start, and all
/// files in the folder must be the same as before.
fn assert_refused(folder: &Path, program: &mut Command, sentence: &str) {
    let files = || {
        let names = names(folder).into_iter();
        let read = |name: String| (fs::read(folder.join(&name)).ok(), name);
        names.map(read).collect::<Vec<_>>()
    };
    let before = files();
    let output = program.output().expect("the program runs");
    let complaint = String::from_utf8_lossy(&output.stderr);
    assert!(complaint.starts_with(sentence), "{complaint}");
    assert_eq!(complaint.matches("error: ").count(), 1, "{complaint}");
    assert_eq!(output.status.code(), Some(1), "{complaint}");
    assert!(files() == before, "changed: {:?}", names(folder));
}

/// The names in a folder, sorted.
fn names(folder: &Path) -> Vec<String> {
    let entries = folder.read_dir().expect("a folder");
    let name = |entry: fs::DirEntry| entry.file_name().into_string().expect("a name");
    let mut names: Vec<_> = entries.map(|entry| name(entry.expect("a file"))).collect();
    names.sort();
    names
}

/// Writes a picture without a pattern, which compression makes no smaller.
fn write_noise(path: &Path, side: u32, seed: u32) {
    let size = Size::new(side, side).expect("a size");
    let noise = Image::from_fn(size, |x, y| {
        let mixed = (x ^ y.rotate_left(16) ^ seed).wrapping_mul(0x9E37_79B1);
        let mixed = (mixed ^ mixed >> 15).wrapping_mul(0x85EB_CA6B);
        let [_, red, green, blue] = (mixed ^ mixed >> 13).to_le_bytes();
        Color::from_bytes([red, green, blue])
    });
    let rgb = noise.expect("a picture").to_rgb8(Transfer::Linear);
    picture_file::save_png(path, size, &rgb).expect("it is saved");
}
