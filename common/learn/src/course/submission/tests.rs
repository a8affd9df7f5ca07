//! Hand-ins as students and learning platforms make them, built here by their structure.

use std::io::{Cursor, Write};
use std::path::Path;

use tempfile::TempDir;
use zip::ZipWriter;
use zip::write::SimpleFileOptions;

use super::*;

/// A file of an exercise.
const CODE: &[u8] = b"pub fn exercise() {}\n";

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

/// What is found of some exercises in each submission, a line each: the file, or why there is none.
fn found(places: &[PathBuf], holds: Holds) -> Vec<String> {
    let course = crate::exercise::read_all().unwrap();
    let mut lines = Vec::new();
    for submission in read(places, holds, course).unwrap() {
        for name in ["ray", "sphere"] {
            let e = crate::exercise::find(name).unwrap();
            lines.push(format!(
                "{} {name}: {}",
                submission.name,
                words(submission.find(e))
            ));
        }
    }
    lines
}

fn words(found: Found) -> String {
    match found {
        Found::File { path, .. } => path.to_owned(),
        Found::Nothing => "not handed in".to_owned(),
        Found::Unclear(why) => format!("? {why}"),
    }
}

/// What is found in one place, a folder or a zip file, that has this name.
fn found_in(name: &str, bytes: &[u8]) -> Vec<String> {
    let folder = folder(&[(name, bytes)]);
    found(&[folder.path().join(name)], Holds::Export)
}

const RAY: &str = "a03-rays-cameras/exercises/ray.rs";
const SPHERE: &str = "a04-intersections/exercises/sphere.rs";

/// What `cargo learn submit` packs.
fn submitted() -> Vec<u8> {
    zip(&[(RAY, CODE), (SPHERE, CODE), ("results.txt", b"learn")])
}

#[test]
fn moodle() {
    let export = zip(&[
        ("Ada Byron_11_assignsubmission_file_/ada.zip", &submitted()),
        ("Bob_12_assignsubmission_file_/ray.rs", CODE),
        ("Bob_12_assignsubmission_file_/my work/sphere (1).rs", CODE),
        (
            "Bob_12_assignsubmission_onlinetext_/onlinetext.html",
            b"<p>done</p>",
        ),
        (
            "Cy_13_assignsubmission_onlinetext_/onlinetext.html",
            b"<p>pub fn</p>",
        ),
        ("Di_14_assignsubmission_file_ray.rs", CODE),
        ("Ed_15_assignsubmission_file_/ed.7z", b"7z"),
    ]);
    assert_eq!(
        found_in("Week 4-123.zip", &export),
        [
            format!("Ada Byron_11 ray: ada.zip/{RAY}"),
            format!("Ada Byron_11 sphere: ada.zip/{SPHERE}"),
            "Bob_12 ray: ray.rs".to_owned(),
            "Bob_12 sphere: my work/sphere (1).rs".to_owned(),
            "Cy_13 ray: ? no file has the name of an exercise; it has onlinetext.html".to_owned(),
            "Cy_13 sphere: ? no file has the name of an exercise; it has onlinetext.html"
                .to_owned(),
            "Di_14 ray: ray.rs".to_owned(),
            "Di_14 sphere: not handed in".to_owned(),
            "Ed_15 ray: ? no file has the name of an exercise; it has ed.7z".to_owned(),
            "Ed_15 sphere: ? no file has the name of an exercise; it has ed.7z".to_owned(),
        ]
    );
}

#[test]
fn ilias() {
    let export = zip(&[
        (
            "Week 4/Submissions/Byron_Ada_ab1_77/20261001123045_ada.zip",
            &submitted(),
        ),
        ("Week 4/Submissions/Cole_Bob_bc2_78/work/ray.rs", CODE),
        (
            "Week 4/Submissions/Cole_Bob_bc2_78/20261001123045_sphere.rs",
            CODE,
        ),
        ("Week 4/Week 4.xlsx", b"table"),
    ]);
    assert_eq!(
        found_in("export.zip", &export),
        [
            format!("Byron_Ada_ab1_77 ray: 20261001123045_ada.zip/{RAY}"),
            format!("Byron_Ada_ab1_77 sphere: 20261001123045_ada.zip/{SPHERE}"),
            "Cole_Bob_bc2_78 ray: work/ray.rs".to_owned(),
            "Cole_Bob_bc2_78 sphere: 20261001123045_sphere.rs".to_owned(),
        ]
    );
}

#[test]
fn canvas() {
    let export = zip(&[
        ("byronada_11_501_ray-1.rs", CODE),
        ("byronada_11_502_sphere.rs", CODE),
        ("colebob_LATE_12_503_bob.zip", &submitted()),
    ]);
    assert_eq!(
        found_in("submissions.zip", &export),
        [
            "byronada_11 ray: ray-1.rs".to_owned(),
            "byronada_11 sphere: sphere.rs".to_owned(),
            format!("colebob_12 ray: bob.zip/{RAY}"),
            format!("colebob_12 sphere: bob.zip/{SPHERE}"),
        ]
    );
}

#[test]
fn blackboard() {
    let time = "attempt_2026-10-01-12-30-45";
    let ada = format!("Week 4_ada_{time}");
    let bob = format!("Week 4_bob_{time}");
    let export = zip(&[
        (&format!("{ada}.txt"), b"Name: Ada"),
        (&format!("{ada}_ray.rs"), CODE),
        (&format!("{bob}.txt"), b"Name: Bob"),
        (&format!("{bob}_bob.zip"), &submitted()),
    ]);
    assert_eq!(
        found_in("gradebook.zip", &export),
        [
            "Week 4_ada ray: ray.rs".to_owned(),
            "Week 4_ada sphere: not handed in".to_owned(),
            format!("Week 4_bob ray: bob.zip/{RAY}"),
            format!("Week 4_bob sphere: bob.zip/{SPHERE}"),
        ]
    );
}

#[test]
fn google_classroom() {
    let export = zip(&[
        ("Week 4/Ada Byron - ray.rs", CODE),
        ("Week 4/Bob Cole - work.zip", &submitted()),
        ("Week 4/sphere.rs", CODE),
    ]);
    assert_eq!(
        found_in("drive.zip", &export),
        [
            "drive.zip ray: not handed in".to_owned(),
            "drive.zip sphere: Week 4/sphere.rs".to_owned(),
            "drive.zip/Week 4/Ada Byron ray: ray.rs".to_owned(),
            "drive.zip/Week 4/Ada Byron sphere: not handed in".to_owned(),
            format!("drive.zip/Week 4/Bob Cole ray: work.zip/{RAY}"),
            format!("drive.zip/Week 4/Bob Cole sphere: work.zip/{SPHERE}"),
        ]
    );
}

#[test]
fn folders_of_a_class() {
    let of_class = folder(&[
        ("1/submission.zip", &submitted()),
        ("2/submission.zip", &zip(&[(RAY, CODE)])),
    ]);
    let zips = ["1", "2"].map(|name| of_class.path().join(name).join("submission.zip"));
    let rows = |name| {
        [
            format!("1{name} ray: {name_in}{RAY}", name_in = ""),
            format!("1{name} sphere: {SPHERE}"),
            format!("2{name} ray: {RAY}"),
            format!("2{name} sphere: not handed in"),
        ]
    };
    assert_eq!(found(&zips, Holds::Export), rows("/submission.zip"));
    let whole = [of_class.path().to_owned()];
    let of_class = found(&whole, Holds::Class);
    assert_eq!(of_class.len(), 4);
    assert_eq!(of_class[0], format!("1 ray: submission.zip/{RAY}"));
    // A folder around all.
    let export = zip(&[("class/ada/ray.rs", CODE), ("class/bob.zip", &submitted())]);
    let export = folder(&[("class.zip", &export)]);
    assert_eq!(
        found(&[export.path().join("class.zip")], Holds::Class),
        [
            "ada ray: ray.rs".to_owned(),
            "ada sphere: not handed in".to_owned(),
            format!("bob.zip ray: {RAY}"),
            format!("bob.zip sphere: {SPHERE}"),
        ]
    );
}

#[test]
fn names_with_backslashes_and_zips_in_zips() {
    let [ray, sphere] = [RAY, SPHERE].map(|path| path.replace('/', "\\"));
    let windows = zip(&[(&ray, CODE), (&sphere, CODE)]);
    assert_eq!(
        found_in("ada.zip", &windows),
        [
            format!("ada.zip ray: {RAY}"),
            format!("ada.zip sphere: {SPHERE}")
        ]
    );
    let nested = zip(&[("hand in/ada.zip", &zip(&[("ada.zip", &windows)]))]);
    assert_eq!(
        found_in("ada.zip", &nested)[1],
        format!("ada.zip sphere: hand in/ada.zip/ada.zip/{SPHERE}")
    );
    // Unpacked by a tool that keeps the names.
    let unpacked = folder(&[(&sphere, CODE)]);
    let unpacked = found(&[unpacked.path().to_owned()], Holds::Export);
    assert!(
        unpacked[1].ends_with(&format!("sphere: {SPHERE}")),
        "{}",
        unpacked[1]
    );
}

#[test]
fn of_a_whole_workbook_only_the_files_of_exercises_count() {
    let whole = zip(&[
        ("me/a04-intersections/src/sphere.rs", CODE),
        ("me/a04-intersections/tests/exercises/sphere.rs", CODE),
        ("me/a04-intersections/exercises/starters/sphere.rs", CODE),
        ("me/a04-intersections/exercises/sphere.rs", CODE),
        ("me/a04-intersections/src/own_shape.rs", CODE),
        ("me/common/src/size.rs", CODE),
        ("me/src/ray.rs", CODE),
    ]);
    assert_eq!(
        found_in("ada.zip", &whole),
        [
            "ada.zip ray: not handed in".to_owned(),
            format!("ada.zip sphere: me/{SPHERE}"),
        ]
    );
}

#[test]
fn what_is_unclear_is_named() {
    let twice = zip(&[
        ("old/sphere.rs", CODE),
        ("new/sphere.rs", CODE),
        ("Ray.rs", CODE),
    ]);
    assert_eq!(
        found_in("ada.zip", &twice),
        [
            "ada.zip ray: Ray.rs",
            "ada.zip sphere: ? there are 2 copies: new/sphere.rs, old/sphere.rs; hand in one",
        ]
    );
    // The writer refuses a second file of a name, so one is renamed in its bytes.
    let mut one_name = zip(&[("sphere.rs", CODE), ("spherf.rs", b"")]);
    for at in 0..one_name.len() - 6 {
        if one_name[at..].starts_with(b"spherf") {
            one_name[at + 5] = b'e';
        }
    }
    let large = vec![b' '; 64 * 1024 + 1];
    for (name, bytes, problem) in [
        ("a.zip", zip(&[]), "it is empty"),
        (
            "a.zip",
            b"text".to_vec(),
            "a.zip, which is no zip file, or a damaged one",
        ),
        (
            "a.zip",
            one_name,
            "a.zip, which has several files of one name",
        ),
        ("a.7z", b"7z".to_vec(), "a.7z"),
        (
            "a.zip",
            zip(&[("b.zip", b"x")]),
            "b.zip, which is no zip file, or a damaged one",
        ),
        (
            "sphere.rs",
            b"\xff\xfeu\0".to_vec(),
            "sphere.rs is no text in UTF-8",
        ),
        (
            "sphere.rs",
            b"// \xe4".to_vec(),
            "sphere.rs is no text in UTF-8",
        ),
        ("sphere.rs", large, "sphere.rs is larger than 64 KiB"),
        (
            "a.zip",
            zip(&[("sphere.rs.txt", CODE), ("ray.rs", CODE)]),
            "not found, unless it is in sphere.rs.txt",
        ),
    ] {
        let found = found_in(name, &bytes).remove(1);
        assert!(
            found.contains("sphere: ? ") && found.ends_with(problem),
            "{found}"
        );
    }
}

#[cfg(unix)]
#[test]
fn links_are_not_followed() {
    let secret = folder(&[("sphere.rs", CODE)]);
    let linked = folder(&[]);
    let link = |name: &str, to: &Path| {
        std::os::unix::fs::symlink(to, linked.path().join(name)).unwrap();
    };
    link("sphere.rs", &secret.path().join("sphere.rs"));
    link("ray", secret.path());
    let found = found(&[linked.path().to_owned()], Holds::Export);
    assert!(
        found[1].ends_with("sphere.rs is a link; hand in the file itself"),
        "{}",
        found[1]
    );
}
