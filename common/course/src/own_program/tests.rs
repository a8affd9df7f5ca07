//! Programs as students hand them in.

use super::*;
use crate::hand_in::files_in;

const MANIFEST_OF_ADA: &str = "[package]\nname = \"ada\"\nedition = \"2021\"\nbuild = \"evil.rs\"\n\
    [dependencies]\nlibm = \"0.2.1\"\ncommon = { path = \"/home/ada/common\" }\n\
    rand = { version = \"0.9\", default-features = false, features = [\"std\"] }\n";

/// The programs of a student: folders, sheets and problems.
fn found(files: &[(&str, &str)]) -> Vec<String> {
    let folder = tempfile::tempdir().unwrap();
    let ada = folder.path().join("ada");
    fs::create_dir(&ada).unwrap();
    for (path, text) in files {
        let file = ada.join(path);
        fs::create_dir_all(file.parent().unwrap()).unwrap();
        fs::write(file, text).unwrap();
    }
    let mut lines = Vec::new();
    for program in find(&files_in(&ada)) {
        let problem = program.problem.unwrap_or_default();
        let (folder, sheets) = (program.folder, program.sheets.join(" "));
        lines.push(format!("{folder}|{sheets}|{problem}"));
    }
    lines
}

#[test]
fn programs_are_found_by_their_files() {
    let of_two = [
        ("my-tracer/Cargo.toml", MANIFEST_OF_ADA),
        ("my-tracer/sheet.txt", "glass\nlens\n"),
        ("my-tracer/src/main.rs", EMPTY),
        ("my-tracer/own-library/Cargo.toml", MANIFEST_OF_ADA),
        ("other/Cargo.toml", MANIFEST_OF_ADA),
    ];
    assert_eq!(
        found(&of_two),
        [
            "ada/my-tracer|glass lens|",
            "ada/other||it has no sheet.txt, which names the sheet",
        ]
    );
    let here = [("sheet.txt", "glass")];
    assert_eq!(found(&here), ["ada|glass|it has no Cargo.toml"]);
    let broken = [("ada.zip", "text")];
    assert_eq!(
        found(&broken),
        ["ada/ada.zip||it is no zip file, or a damaged one"]
    );
    assert_eq!(found(&[]), ["||it is empty"]);
    assert_eq!(found(&[("report.pdf", "pdf")]), [""; 0]);
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
