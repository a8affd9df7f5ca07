//! The students' names in the exports of learning platforms.
//!
//! A platform exports the hand-ins of a class as one zip file. It names a folder or a file after the
//! student, and may write the file's own name behind that.

use super::hand_in::has_extension;

/// A student, by the name that a platform gives to a folder or a file.
#[derive(Debug, PartialEq, Eq)]
pub struct Named {
    /// The name, with the numbers that tell students of the same name apart.
    pub student: String,
    /// The name that the student gave to the file; none for a folder.
    pub file: Option<String>,
}

/// Folders whose folders ILIAS names after students.
const ILIAS: [&str; 2] = ["Submissions", "Abgaben"];

/// The student whom a platform names in a part of a path, which is the last part, of a file, or not,
/// and is in a folder of this name.
pub fn named(folder: Option<&str>, part: &str, is_file: bool) -> Option<Named> {
    if let Some(named) = in_moodle(part) {
        return Some(named);
    }
    if is_file {
        return on_blackboard(part)
            .or_else(|| in_canvas(part))
            .or_else(|| in_classroom(part));
    }
    in_ilias(folder?, part)
}

/// Moodle: a folder `Ada Lovelace_12345_assignsubmission_file_`, or, without folders, a file that
/// begins so. What students type into a page is `onlinetext` instead of `file`.
fn in_moodle(part: &str) -> Option<Named> {
    let (student, rest) = part.split_once("_assignsubmission_")?;
    let (_, file) = rest.split_once('_')?;
    Some(Named {
        student: student.to_owned(),
        file: (!file.is_empty()).then(|| file.to_owned()),
    })
}

/// ILIAS: a folder `Lovelace_Ada_login_12345` in the folder `Submissions`.
fn in_ilias(folder: &str, part: &str) -> Option<Named> {
    let (name, id) = part.rsplit_once('_')?;
    let is_student = ILIAS.contains(&folder) && name.contains('_') && is_number(id);
    is_student.then(|| Named {
        student: part.to_owned(),
        file: None,
    })
}

/// Canvas: a file `lovelaceada_12345_67890_sphere-1.rs`, after the name `LATE` if it is: the
/// student's number, and that of the file.
fn in_canvas(part: &str) -> Option<Named> {
    let (name, rest) = part.split_once('_')?;
    let rest = rest.strip_prefix("LATE_").unwrap_or(rest);
    let (student, rest) = rest.split_once('_')?;
    let (number, file) = rest.split_once('_')?;
    let is_student = !name.is_empty() && is_number(student) && is_number(number);
    is_student.then(|| Named {
        student: format!("{name}_{student}"),
        file: Some(file.to_owned()),
    })
}

/// Blackboard: a file `Week 4_ada_attempt_2026-10-01-12-30-45_sphere.rs`, and without the last name a
/// text about it.
fn on_blackboard(part: &str) -> Option<Named> {
    let (student, rest) = part.split_once("_attempt_")?;
    let file = rest.split_once('_').map_or("receipt", |(_, file)| file);
    Some(Named {
        student: student.to_owned(),
        file: Some(file.to_owned()),
    })
}

/// Google Classroom: a file `Ada Lovelace - sphere.rs`, where it has made a copy for each student.
fn in_classroom(part: &str) -> Option<Named> {
    let (student, file) = part.split_once(" - ")?;
    let is_handed_in = has_extension(file, "rs") || has_extension(file, "zip");
    is_handed_in.then(|| Named {
        student: student.to_owned(),
        file: Some(file.to_owned()),
    })
}

fn is_number(word: &str) -> bool {
    !word.is_empty() && word.chars().all(|c| c.is_ascii_digit())
}

/// The name that a student gave to a file: without the time that ILIAS writes before it, and without
/// the number that platforms and browsers give to a further file of a name.
pub fn own_name(name: &str) -> String {
    let name = match name.split_once('_') {
        Some((time, name)) if time.len() == 14 && is_number(time) => name,
        _ => name,
    };
    let Some((stem, extension)) = name.rsplit_once('.') else {
        return name.to_owned();
    };
    format!("{}.{extension}", without_number(stem))
}

/// A name without a number at its end, as in `sphere-1`, `sphere (1)` and `sphere(1)`.
fn without_number(stem: &str) -> &str {
    if let Some((name, number)) = stem.rsplit_once('-')
        && is_number(number)
    {
        return name;
    }
    if let Some((name, number)) = stem.rsplit_once('(')
        && number.strip_suffix(')').is_some_and(is_number)
    {
        return name.trim_end();
    }
    stem
}

#[cfg(test)]
mod tests {
    use super::*;

    fn student(folder: &str, part: &str, is_file: bool) -> Option<(String, Option<String>)> {
        let Named { student, file } = named(Some(folder), part, is_file)?;
        Some((student, file))
    }

    #[test]
    fn students_are_found_in_the_names_of_platforms() {
        let [folder, file] = [false, true];
        for (before, part, is_file, student_and_file) in [
            (
                "x",
                "Ada Lovelace_1_assignsubmission_file_",
                folder,
                ("Ada Lovelace_1", ""),
            ),
            (
                "x",
                "Ada_1_assignsubmission_onlinetext_",
                folder,
                ("Ada_1", ""),
            ),
            (
                "x",
                "Ada_1_assignsubmission_file_ray.rs",
                file,
                ("Ada_1", "ray.rs"),
            ),
            (
                "Submissions",
                "Byron_Ada_ab1_77",
                folder,
                ("Byron_Ada_ab1_77", ""),
            ),
            (
                "x",
                "byronada_12_345_my_ray-1.rs",
                file,
                ("byronada_12", "my_ray-1.rs"),
            ),
            (
                "x",
                "byronada_LATE_12_345_a.zip",
                file,
                ("byronada_12", "a.zip"),
            ),
            (
                "x",
                "W 4_ada_attempt_2026-10-01-12-30-45_ray.rs",
                file,
                ("W 4_ada", "ray.rs"),
            ),
            (
                "x",
                "W 4_ada_attempt_2026-10-01-12-30-45.txt",
                file,
                ("W 4_ada", "receipt"),
            ),
            (
                "x",
                "Ada Lovelace - ray.rs",
                file,
                ("Ada Lovelace", "ray.rs"),
            ),
        ] {
            let (name, own) = student_and_file;
            let own = (!own.is_empty()).then(|| own.to_owned());
            assert_eq!(
                student(before, part, is_file),
                Some((name.to_owned(), own)),
                "{part}"
            );
        }
        for (before, part, is_file) in [
            ("Submissions", "week_4", folder),
            ("x", "Byron_Ada_ab1_77", folder),
            ("x", "axis_aligned_box.rs", file),
            ("x", "set_1_pixel.rs", file),
            ("x", "notes - old.txt", file),
        ] {
            assert_eq!(student(before, part, is_file), None, "{part}");
        }
    }

    #[test]
    fn numbers_of_further_files_are_no_part_of_their_names() {
        for name in [
            "ray.rs",
            "ray-1.rs",
            "ray (2).rs",
            "ray(13).rs",
            "20261001123045_ray.rs",
        ] {
            assert_eq!(own_name(name), "ray.rs");
        }
        assert_eq!(own_name("six_planes.rs"), "six_planes.rs");
    }
}
