//! Hand-ins as students make them, built here by their structure.

use std::io::{Cursor, Write};
use std::path::Path;

use learn::files::workspace;
use tempfile::TempDir;
use zip::ZipWriter;
use zip::write::SimpleFileOptions;

use super::*;
use crate::collected::Collected;

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
fn rows(folder: &Path) -> Vec<String> {
    let course = learn::exercise::read_all().unwrap();
    let collected = Collected::read(&[folder.to_owned()], course).unwrap();
    let mut rows = Vec::new();
    if !collected.of_nobody.is_empty() {
        rows.push(format!("nobody: {}", collected.of_nobody.join(", ")));
    }
    for student in &collected.students {
        let files = student.files();
        let submission = Submission::new(&files, course);
        let mut words = Vec::new();
        for name in ["ray", "sphere"] {
            let e = learn::exercise::find(name).unwrap();
            words.push(match submission.find(e) {
                Found::File { path, .. } => path,
                Found::Nothing => "-".to_owned(),
                Found::Unclear(why) => format!("? {why}"),
            });
        }
        words.dedup();
        let name = student.name.replace(&*folder.to_string_lossy(), "…");
        rows.push(format!("{name}: {}", words.join("; ")));
    }
    rows
}

#[test]
fn each_folder_and_archive_is_a_student_and_nothing_else() {
    let submitted = zip(&[(RAY, CODE), (SPHERE, CODE), ("results.txt", b"learn")]);
    let class = folder(&[
        ("Ada Byron_11/ada.zip", &submitted),
        ("Bob.zip", &submitted),
        ("bob/ray.rs", CODE),
        ("bob.tar.gz", b"gz"),
        ("cut.zip", &submitted[..200]),
        ("dan/week 4/RAY.RS", CODE),
        ("dan/week 4/again/ray.rs", CODE),
        ("dan/week 4/sphere.rs", CODE),
        ("dan/old/sphere.rs", OTHER),
        ("grades.csv", b"table"),
        ("Gü/ray (1).rs", CODE),
        ("__MACOSX/Ada/._ray.rs", b""),
        ("sphere.rs", CODE),
    ]);
    std::fs::create_dir(class.path().join("Flo")).unwrap();
    assert_eq!(
        rows(class.path()),
        [
            "nobody: __MACOSX, grades.csv",
            "Ada Byron_11: Ada Byron_11/ada.zip/a03-rays-cameras/exercises/ray.rs; \
             Ada Byron_11/ada.zip/a04-intersections/exercises/sphere.rs",
            "Bob: Bob.zip/a03-rays-cameras/exercises/ray.rs; Bob.zip/a04-intersections/exercises/sphere.rs",
            "Flo: ? it is empty",
            "Gü: ? no file has the name of an exercise; it has Gü/ray (1).rs",
            "bob: bob/ray.rs; -",
            "…/bob.tar.gz: ? no file has the name of an exercise; \
             it has bob.tar.gz (it is another archive than a zip file)",
            "cut: ? no file has the name of an exercise; \
             it has cut.zip (it is no zip file, or a damaged one)",
            "dan: dan/week 4/RAY.RS; \
             ? there are 2 files: dan/old/sphere.rs, dan/week 4/sphere.rs; hand in one",
            "sphere: -; sphere.rs",
        ]
    );
}

/// Archives that were added to by some tools have two files of one name.
#[test]
fn of_two_files_of_one_name_in_a_zip_file_nobody_knows_which_counts() {
    let mut twice = zip(&[("a/ray.rs", CODE), ("b/ray.rs", OTHER), ("sphere.rs", CODE)]);
    for place in 0..twice.len() - 8 {
        if &twice[place..place + 8] == b"b/ray.rs" {
            twice[place] = b'a';
        }
    }
    let class = folder(&[("ada.zip", &twice)]);
    assert_eq!(
        rows(class.path()),
        [
            "ada: ? there are 2 files: ada.zip/a/ray.rs, ada.zip/a/ray.rs; hand in one; ada.zip/sphere.rs"
        ]
    );
}

/// Of a whole workbook only files in `exercises` of a stage are a student's.
#[test]
fn files_of_the_workbook_are_no_students() {
    let course = learn::exercise::read_all().unwrap();
    let mut files = Vec::new();
    let mut open = vec![workspace()];
    while let Some(folder) = open.pop() {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            let inner = path.strip_prefix(workspace()).unwrap();
            let parts = inner.iter().map(|part| part.to_string_lossy().into_owned());
            let path_of_file = [vec!["ada".to_owned()], parts.collect()].concat();
            if path.is_dir()
                && !path_of_file
                    .iter()
                    .any(|part| crate::handed_file::is_added(part))
            {
                open.push(path);
            } else if path_of_file.len() > 3 && path_of_file[path_of_file.len() - 2] != "exercises"
            {
                let content = Content::Bytes(Vec::new());
                files.push(HandedFile {
                    path: path_of_file,
                    content,
                });
            }
        }
    }
    assert!(files.len() > 1000, "{}", files.len());
    files.retain(|file| may_be_rust(file.name()));
    let submission = Submission::new(&files, course);
    let left = submission.files.iter().map(|file| file.path_text());
    let left = left.filter(|path| !path.contains("/fuzz/") && !path.contains("/.ci/"));
    assert_eq!(left.collect::<Vec<_>>(), [""; 0]);
}

#[test]
fn a_program_for_a_sheet_is_no_trace_of_an_exercise() {
    let class = folder(&[
        ("Ada/ada/Cargo.toml", b""),
        ("Ada/ada/sheet.txt", b"lens"),
        ("Ada/ada/src/functions.rs", CODE),
        ("Ada/ada/src/functions/sphere.rs", OTHER),
        ("Ada/ada/src/lens.rs", CODE),
        ("Ada/a04-intersections/exercises/sphere.rs", CODE),
        ("Bob/sheet.txt", b"lens"),
        ("Bob/src/functions/ray.rs", CODE),
        ("Bob/src/lens.rs", CODE),
        ("Cy/sheet.txt", b"lens"),
        ("Cy/tracer.py", b"print()"),
        ("Dan/sheet.txt", b"lens"),
        ("Dan/sphere (1).rs", CODE),
        ("Eva/src/lens.rs", CODE),
    ]);
    assert_eq!(
        rows(class.path()),
        [
            "Ada: -; Ada/a04-intersections/exercises/sphere.rs",
            "Bob: -",
            "Cy: -",
            "Dan: ? not found, unless it is in Dan/sphere (1).rs",
            "Eva: ? no file has the name of an exercise; it has Eva/src/lens.rs",
        ],
    );
}

#[test]
fn a_folder_of_the_workbook_is_no_student() {
    let ada = folder(&[(RAY, CODE)]);
    let course = learn::exercise::read_all().unwrap();
    let read = Collected::read(&[ada.path().to_owned()], course);
    assert!(read.unwrap_err().contains("no student"));
    let zip = folder(&[("ada.zip", &zip(&[(RAY, CODE)]))]);
    let read = Collected::read(&[zip.path().join("ada.zip")], course);
    assert_eq!(read.unwrap().students[0].name, "ada");
}

#[test]
fn what_cannot_be_read_is_named() {
    let utf_16: Vec<_> = "\u{FEFF}fn"
        .encode_utf16()
        .flat_map(u16::to_le_bytes)
        .collect();
    let bomb = vec![b' '; 1 << 20];
    let within = zip(&[("b.zip", &zip(&[("ray.rs", CODE)]))]);
    let class = folder(&[
        ("Ada/ray.rs", &utf_16),
        ("Ada/sphere.rs.txt", CODE),
        ("Bob/ray.rs", b"// gr\xfcn"),
        ("Cy/ray.rs", &bomb),
        ("Di/di.zip", b"PK"),
        ("Ed.zip", &zip(&[("a.zip", &within)])),
        (
            "Gil.zip",
            &zip(&[("../../ray.rs", CODE), ("..\\Hal\\sphere.rs", CODE)]),
        ),
        ("Jo/report.pdf", b"pdf"),
    ]);
    assert_eq!(
        rows(class.path()),
        [
            "Ada: ? Ada/ray.rs: it is a text in UTF-16; save it in UTF-8; \
             ? not found, unless it is in Ada/sphere.rs.txt",
            "Bob: ? Bob/ray.rs: line 1 has a letter that is not in UTF-8; save the file in UTF-8; -",
            "Cy: ? Cy/ray.rs: it is larger than 64 KiB; -",
            "Di: ? no file has the name of an exercise; it has Di/di.zip (it is no zip file, or a damaged one)",
            "Ed: ? no file has the name of an exercise; \
             it has Ed.zip/a.zip/b.zip (it is a zip file in two others; unpack one)",
            "Gil: Gil.zip/ray.rs; Gil.zip/Hal/sphere.rs",
            "Jo: ? no file has the name of an exercise; it has Jo/report.pdf",
        ],
    );
}

#[cfg(unix)]
#[test]
fn links_are_not_followed() {
    let class = folder(&[("ada/sphere.rs", CODE)]);
    let link = |name: &str| {
        std::os::unix::fs::symlink("/etc/passwd", class.path().join(name)).unwrap();
    };
    link("ada/ray.rs");
    link("bob");
    let is_link = "it is a link; hand in the file itself";
    assert_eq!(
        rows(class.path()),
        [
            format!("ada: ? ada/ray.rs: {is_link}; ada/sphere.rs"),
            format!("bob: ? no file has the name of an exercise; it has bob ({is_link})"),
        ]
    );
}
