//! Programs as students hand them in.

use super::*;
use crate::hand_in::files_in;

const MANIFEST_OF_ADA: &str = "[package]\nname = \"ada\"\nedition = \"2021\"\nbuild = \"evil.rs\"\n\
    [dependencies]\nlibm = \"0.2.1\"\ncommon = { path = \"/home/ada/common\" }\n\
    rand = { version = \"0.9\", default-features = false, features = [\"std\"] }\n";

/// The folder of the program that a student has handed in for the sheet `glass`, or why there is none.
fn found(files: &[(&str, &str)]) -> String {
    let folder = tempfile::tempdir().unwrap();
    let ada = folder.path().join("ada");
    fs::create_dir(&ada).unwrap();
    for (path, text) in files {
        let file = ada.join(path);
        fs::create_dir_all(file.parent().unwrap()).unwrap();
        fs::write(file, text).unwrap();
    }
    let all = sheet::read_all().unwrap();
    let glass = sheet::find(&all, "glass").unwrap();
    match find(&files_in(&ada), glass, &all) {
        Ok(program) => program.map_or("-".to_owned(), |program| program.folder),
        Err(why) => why,
    }
}

#[test]
fn programs_are_found_by_their_files() {
    let two = "my-tracer/sheet.txt";
    let program = ("my-tracer/Cargo.toml", MANIFEST_OF_ADA);
    let library = ("my-tracer/library/Cargo.toml", MANIFEST_OF_ADA);
    let other = ("other/Cargo.toml", MANIFEST_OF_ADA);
    let other_sheet = ("other/sheet.txt", "glass");
    for (files, is_found) in [
        (
            &[program, library, other, (two, "lens\nglass")][..],
            "ada/my-tracer",
        ),
        (
            &[program, other, (two, "lens")],
            "ada/other/Cargo.toml: beside it is no sheet.txt, which names the sheet",
        ),
        (&[program, library, (two, "lens")], "-"),
        (
            &[program, (two, "glass"), other, other_sheet],
            "there are 2 programs for this sheet; hand in one",
        ),
        (
            &[program, (two, "lens glas")],
            "ada/my-tracer/sheet.txt: no sheet is called glas; the nearest is glass",
        ),
        (&[("sheet.txt", "glass")], "ada: it has no Cargo.toml"),
        (
            &[("ada.zip", "text")],
            "ada/ada.zip: it is no zip file, or a damaged one",
        ),
        (&[], "it is empty"),
        (&[("report.pdf", "pdf")], "-"),
    ] {
        assert_eq!(found(files), is_found);
    }
}

#[test]
fn a_manifest_keeps_libraries_and_neither_paths_nor_scripts() {
    let manifest = manifest(MANIFEST_OF_ADA).unwrap();
    for line in [
        "name = \"ada\"",
        "edition = \"2021\"",
        "common = { path = \"../workbook/common\" }",
        "a07-transforms = { path = \"../workbook/a07-transforms\", default-features = false }",
        "\"libm\" = { version = \"0.2.1\", features = [], default-features = true }",
        "\"rand\" = { version = \"0.9\", features = [\"std\"], default-features = false }",
    ] {
        assert!(
            manifest.lines().any(|found| found == line),
            "{line}: {manifest}"
        );
    }
    assert!(
        !manifest.contains("evil") && !manifest.contains("/home"),
        "{manifest}"
    );
    let own = "[dependencies]\nmine = { path = \"../mine\" }\n";
    assert!(
        super::manifest(own)
            .unwrap_err()
            .contains("the library mine")
    );
}
