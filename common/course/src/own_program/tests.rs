//! Programs as students hand them in.

use super::*;
use crate::hand_in::files_in;

const MANIFEST_OF_ADA: &str = "[package] # mine\r\nname = \"ada\"\r\ndefault-run = \"tracer\"\r\n\r\n\
    [dependencies]\r\nlibm = \"0.2.1\"\r\ncommon = { path = \"/home/ada/workbook/common\" }\r\n\
    math = { path = \"../workbook/a02-math\", package = \"a02-math\", default-features = false }\r\n\
    library = { path = \"library\" }\r\n\r\n[profile.release]\r\noverflow-checks = true";

/// What a student hands in.
fn handed_in(files: &[(&str, &[u8])]) -> Vec<HandedFile> {
    let folder = tempfile::tempdir().unwrap();
    let ada = folder.path().join("ada");
    fs::create_dir(&ada).unwrap();
    for (path, bytes) in files {
        let file = ada.join(path);
        fs::create_dir_all(file.parent().unwrap()).unwrap();
        fs::write(file, bytes).unwrap();
    }
    files_in(&ada)
}

/// The program that a student has handed in for the sheet `glass`, or why there is none.
fn found(files: &[(&str, &[u8])]) -> Result<Option<OwnProgram>, String> {
    let all = sheet::read_all().unwrap();
    let glass = sheet::find(&all, "glass").unwrap();
    find(&handed_in(files), glass, &all)
}

#[test]
fn programs_are_found_by_their_files() {
    let two = "my-tracer/sheet.txt";
    let program = ("my-tracer/Cargo.toml", MANIFEST_OF_ADA.as_bytes());
    let library = ("my-tracer/library/Cargo.toml", MANIFEST_OF_ADA.as_bytes());
    let other = ("other/Cargo.toml", MANIFEST_OF_ADA.as_bytes());
    let other_sheet = ("other/sheet.txt", &b"glass"[..]);
    for (files, is_found) in [
        (
            &[program, library, other, (two, b"lens\nGlass")][..],
            "ada/my-tracer",
        ),
        (
            &[program, other, (two, b"lens")],
            "ada/other/Cargo.toml: beside it is no sheet.txt, which names the sheet",
        ),
        (&[program, library, (two, b"lens")], "-"),
        (
            &[program, (two, b"glass"), other, other_sheet],
            "there are 2 programs for this sheet; hand in one",
        ),
        (
            &[program, (two, b"lens glas")],
            "ada/my-tracer/sheet.txt: no sheet is called glas; the nearest is glass",
        ),
        (
            &[(two, b"\n")],
            "ada/my-tracer/sheet.txt: it names no sheet",
        ),
        (&[("sheet.txt", b"glass")], "ada: it has no Cargo.toml"),
        (&[("sheet.txt", b"glass\nprogram: python3 my.py")], "ada"),
        (
            &[("ada.zip", b"text")],
            "ada/ada.zip: it is no zip file, or a damaged one",
        ),
        (&[], "it is empty"),
        (&[("report.pdf", b"pdf")], "-"),
    ] {
        let found = match found(files) {
            Ok(program) => program.map_or("-".to_owned(), |program| program.folder),
            Err(why) => why,
        };
        assert_eq!(found, is_found);
    }
}

#[test]
fn all_files_of_the_folder_are_the_programs() {
    let large = vec![0; 17 * 1024 * 1024];
    let program = found(&[
        ("sheet.txt", b"glass"),
        ("Cargo.toml", MANIFEST_OF_ADA.as_bytes()),
        ("src/main.rs", b"fn main() {}"),
        ("earth.png", b"\x89PNG"),
        ("library/src/lib.rs", b""),
        (".cargo/config.toml", b"[build]\nrustc = \"evil\""),
        ("rust-toolchain", b"nightly"),
        ("film.raw", &large),
        ("target/debug/ada", b"old"),
    ]);
    let program = program.unwrap().unwrap();
    let files: Vec<_> = program.files.keys().map(String::as_str).collect();
    assert_eq!(
        files,
        [
            "Cargo.toml",
            "earth.png",
            "library/src/lib.rs",
            "sheet.txt",
            "src/main.rs"
        ]
    );
    assert_eq!(program.files["earth.png"], b"\x89PNG");
    assert_eq!(
        program.left_out,
        [
            "ada/.cargo/config.toml: the grader's own settings of Cargo hold",
            "ada/film.raw: it is larger than 16384 KiB",
            "ada/rust-toolchain: the grader's own settings of Cargo hold",
        ]
    );
}

#[test]
fn a_manifest_stays_but_for_the_places_of_the_workbook() {
    let expected = MANIFEST_OF_ADA.replace("/home/ada/workbook/common", "../workbook/common")
        + "\n[workspace]\n";
    assert_eq!(in_grading_folder(MANIFEST_OF_ADA, 0).unwrap(), expected);
    let library =
        "[package]\nname = \"library\"\n\n[dependencies.common]\npath = \"../../common\"\n";
    let placed = in_grading_folder(library, 1).unwrap();
    assert_eq!(
        placed,
        library.replace("../../common", "../../workbook/common")
    );
}

#[test]
fn what_lies_outside_of_the_folder_needs_a_look() {
    for (manifest, words) in [
        (
            "[package]\nname = \"a\"\n[dependencies]\nmine = { path = \"../mine\" }",
            "the library mine lies outside of the folder that is handed in",
        ),
        (
            "[package]\nname = \"a\"\n[target.'cfg(unix)'.dependencies.mine]\npath = \"/mine\"",
            "the library mine lies outside of the folder that is handed in",
        ),
        (
            "[workspace]\nmembers = [\"a\", \"b\"]",
            "it is a workspace; hand in the folder of the program",
        ),
    ] {
        assert_eq!(in_grading_folder(manifest, 0).unwrap_err(), words);
    }
}
