//! Programs as students hand them in.

use super::*;

const MANIFEST_OF_ADA: &str = "[package]\nname = \"ada\"\nedition = \"2021\"\nbuild = \"evil.rs\"\n\
    [dependencies]\nlibm = \"0.2.1\"\ncommon = { path = \"/home/ada/common\" }\n\
    rand = { version = \"0.9\", default-features = false, features = [\"std\"] }\n";

/// The programs in a folder: students, folders, sheets and problems.
fn found(files: &[(&str, &str)]) -> Vec<String> {
    let folder = tempfile::tempdir().unwrap();
    for (path, text) in files {
        let file = folder.path().join("class").join(path);
        fs::create_dir_all(file.parent().unwrap()).unwrap();
        fs::write(file, text).unwrap();
    }
    let mut lines = Vec::new();
    for program in find(&[folder.path().join("class")]).unwrap() {
        let problem = program.problem.unwrap_or_default();
        let (student, folder, sheets) = (program.student, program.folder, program.sheets);
        lines.push(format!("{student}|{folder}|{}|{problem}", sheets.join(" ")));
    }
    lines
}

#[test]
fn programs_are_found_by_their_files() {
    let of_two = [
        ("ada/my-tracer/Cargo.toml", MANIFEST_OF_ADA),
        ("ada/my-tracer/sheet.txt", "glass\nlens\n"),
        ("ada/my-tracer/src/main.rs", EMPTY),
        ("ada/my-tracer/own-library/Cargo.toml", MANIFEST_OF_ADA),
        ("Bob 2026-11-04 09-01/Cargo.toml", MANIFEST_OF_ADA),
    ];
    assert_eq!(
        found(&of_two),
        [
            "Bob|Bob 2026-11-04 09-01||it has no sheet.txt, which names the sheet",
            "ada|ada/my-tracer|glass lens|",
        ]
    );
    assert_eq!(found(&of_two[..3]), ["ada|ada/my-tracer|glass lens|"]);
    let here = [("sheet.txt", "glass")];
    assert_eq!(found(&here), ["class||glass|it has no Cargo.toml"]);
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
