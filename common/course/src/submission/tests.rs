//! Hand-ins as students and learning platforms make them, built here by their structure.

use std::io::{Cursor, Write};

use tempfile::TempDir;
use zip::ZipWriter;
use zip::write::SimpleFileOptions;

use super::*;

/// A file of an exercise, and another version of it.
const CODE: &[u8] = b"pub fn exercise() {}\n";
const OTHER: &[u8] = b"pub fn exercise() { }\r\n";

const RAY: &str = "a03-rays-cameras/exercises/ray.rs";
const SPHERE: &str = "a04-intersections/exercises/sphere.rs";

/// A zip file with files of these names.
fn zip(files: &[(&str, &[u8])]) -> Vec<u8> {
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    for (name, bytes) in files {
        zip.start_file(*name, SimpleFileOptions::default()).unwrap();
        zip.write_all(bytes).unwrap();
    }
    zip.finish().unwrap().into_inner()
}

/// A folder with files of these names.
fn folder(files: &[(&str, &[u8])]) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    for (name, bytes) in files {
        let file = folder.path().join(name);
        std::fs::create_dir_all(file.parent().unwrap()).unwrap();
        std::fs::write(file, bytes).unwrap();
    }
    folder
}

/// Who has handed in, and what is found of two exercises: the files, or why there is none.
fn found(folder: &TempDir, places: &[&str]) -> Vec<String> {
    let course = learn::exercise::read_all().unwrap();
    let places: Vec<_> = places.iter().map(|name| folder.path().join(name)).collect();
    let mut lines = Vec::new();
    for submission in read(&places, course).unwrap() {
        let mut words = Vec::new();
        for name in ["ray", "sphere"] {
            let e = learn::exercise::find(name).unwrap();
            words.push(match submission.find(e) {
                Found::File { path, note, .. } if note.is_empty() => path.to_owned(),
                Found::File { path, note, .. } => format!("{path} ({note})"),
                Found::Nothing => "-".to_owned(),
                Found::Unclear(why) => format!("? {why}"),
            });
        }
        words.dedup();
        // A place that is alone is named by its whole path, here that of a temporary folder.
        let name = submission.name.split('/').next_back().unwrap();
        lines.push(format!("{name}: {}", words.join("; ")));
    }
    lines
}

/// Checks who and what is found in a zip file with these files.
fn check(files: &[(&str, &[u8])], expected: &[&str]) {
    let folder = folder(&[("export.zip", &zip(files))]);
    assert_eq!(found(&folder, &["export.zip"]), expected);
}

#[test]
fn folders_of_students_with_tables_beside_them() {
    let submitted = zip(&[(RAY, CODE), (SPHERE, CODE), ("results.txt", b"learn")]);
    check(
        &[
            ("Week 4/grades.csv", b"table"),
            ("Week 4/Submissions/Ada_11/ada.zip", &submitted),
            ("Week 4/Submissions/Bob_12/comments.txt", b"text"),
            ("Week 4/Submissions/Bob_12/attachment(s)/ray (1).rs", CODE),
            ("Week 4/Submissions/Cy_13/onlinetext.html", b"<p>pub fn</p>"),
            ("Week 4/Submissions/Di_14/report.pdf", b"pdf"),
            ("Week 4/Submissions/Ed_15/ed.7z", b"7z"),
            ("Week 4/Submissions/Flo_16/", b""),
            ("Week 4/Submissions/late/Gü_17/RAY.RS", CODE),
            ("__MACOSX/Week 4/._ray.rs", b""),
        ],
        &[
            "Ada_11: Week 4/Submissions/Ada_11/ada.zip/a03-rays-cameras/exercises/ray.rs; \
             Week 4/Submissions/Ada_11/ada.zip/a04-intersections/exercises/sphere.rs",
            "Bob_12: Week 4/Submissions/Bob_12/attachment(s)/ray (1).rs; -",
            "Cy_13: ? no file has the name of an exercise; it has Week 4/Submissions/Cy_13/onlinetext.html",
            "Di_14: ? no file has the name of an exercise; it has Week 4/Submissions/Di_14/report.pdf",
            "Ed_15: ? no file has the name of an exercise; it has Week 4/Submissions/Ed_15/ed.7z",
            "Flo_16: ? it is empty",
            "Gü_17: Week 4/Submissions/late/Gü_17/RAY.RS (late); -",
        ],
    );
}

#[test]
fn files_that_are_named_after_students() {
    check(
        &[
            ("index.html", b"table"),
            ("byronada_11_501_ray-1.rs", CODE),
            ("byronada_11_502_sphere.rs", CODE),
            ("colebob_LATE_12_503_bob.zip", &zip(&[(RAY, CODE)])),
        ],
        &[
            "byronada_11: byronada_11_501_ray-1.rs; byronada_11_502_sphere.rs",
            "colebob_LATE_12_503_bob: \
             colebob_LATE_12_503_bob.zip/a03-rays-cameras/exercises/ray.rs (late); -",
        ],
    );
}

#[test]
fn of_dated_hand_ins_the_latest_counts() {
    check(
        &[
            ("112-22 - Bob Cole - 2026-11-05 09-01/sphere.rs", OTHER),
            ("112-22 - Bob Cole - 2026-11-04 21-01/sphere.rs", CODE),
            ("Ada/20261001123045_ray.rs", CODE),
            ("Ada/20261003080000_ray.rs", OTHER),
            ("Cy/ray.rs", CODE),
            ("Cy/old/ray.rs", OTHER),
            ("Di/ray.rs", CODE),
            ("Di/copy/ray.rs", CODE),
        ],
        &[
            "112-22 - Bob Cole: -; \
             112-22 - Bob Cole - 2026-11-05 09-01/sphere.rs (the latest of 2)",
            "Ada: Ada/20261003080000_ray.rs (the latest of 2); -",
            "Cy: ? there are 2 copies: Cy/old/ray.rs, Cy/ray.rs; hand in one; -",
            "Di: Di/copy/ray.rs; -",
        ],
    );
}

#[test]
fn a_student_alone() {
    let repository: &[(&str, &[u8])] = &[
        ("ada/Cargo.toml", b""),
        ("ada/a03-rays-cameras/exercises/ray.rs", CODE),
        ("ada/a03-rays-cameras/exercises/solutions/ray.rs", OTHER),
        ("ada/a03-rays-cameras/src/ray.rs", OTHER),
        ("ada/a04-intersections/tests/exercises/sphere.rs", OTHER),
        ("ada/common/src/color.rs", OTHER),
        ("ada/target/package/ray.rs", OTHER),
        ("bob/sphere.rs", CODE),
        ("bob/my work/ray.rs", CODE),
    ];
    let folder = folder(repository);
    assert_eq!(
        found(&folder, &["ada"]),
        ["ada: a03-rays-cameras/exercises/ray.rs; -"]
    );
    assert_eq!(found(&folder, &["bob"]), ["bob: my work/ray.rs; sphere.rs"]);
    assert_eq!(found(&folder, &["ada", "bob"]).len(), 2);
    assert_eq!(found(&folder, &["."]).len(), 2);
    assert_eq!(found(&folder, &["bob/sphere.rs"]), ["bob: -; sphere.rs"]);
}

#[test]
fn what_cannot_be_read_is_named() {
    let utf_16: Vec<_> = "\u{FEFF}fn"
        .encode_utf16()
        .flat_map(u16::to_le_bytes)
        .collect();
    let bomb = vec![b' '; 1 << 20];
    check(
        &[
            ("Ada/ray.rs", &utf_16),
            ("Ada/sphere.rs.txt", CODE),
            ("Bob/ray.rs", b"// gr\xfcn"),
            ("Cy/ray.rs", &bomb),
            ("Di/di.zip", b"PK"),
            ("Ed/a.zip", &zip(&[("b.zip", &zip(&[("ray.rs", CODE)]))])),
            ("Flo/my_ray.rs", CODE),
            ("../../Gil/ray.rs", CODE),
            ("..\\Hal\\ray.rs", CODE),
        ],
        &[
            "Ada: ? Ada/ray.rs: it is a text in UTF-16; save it in UTF-8; \
             ? not found, unless it is in Ada/sphere.rs.txt",
            "Bob: ? Bob/ray.rs: line 1 has a letter that is not in UTF-8; save the file in UTF-8; -",
            "Cy: ? Cy/ray.rs: it is larger than 64 KiB; -",
            "Di: ? no file has the name of an exercise; it has Di/di.zip (it is no zip file, or a damaged one)",
            "Ed: ? no file has the name of an exercise; \
             it has Ed/a.zip/b.zip (it is a zip file in two others; unpack one)",
            "Flo: ? no file has the name of an exercise; it has Flo/my_ray.rs",
            "Gil: Gil/ray.rs; -",
            "Hal: Hal/ray.rs; -",
        ],
    );
}

#[cfg(unix)]
#[test]
fn links_are_not_followed() {
    let folder = folder(&[("ada/sphere.rs", CODE)]);
    std::os::unix::fs::symlink("/etc/passwd", folder.path().join("ada/ray.rs")).unwrap();
    let expected = "ada: ? ray.rs: it is a link; hand in the file itself; sphere.rs";
    assert_eq!(found(&folder, &["ada"]), [expected]);
}
