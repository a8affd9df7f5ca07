//! A page with all pictures of a class, by sheets and students, and the error of each program against its run time.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::Path;

use crate::outcome::Graded;

const BEGINNING: &str = "<!doctype html>
<meta charset=\"utf-8\">
<title>Pictures of the class</title>
<style>
body { font-family: sans-serif; margin: 1rem }
figure { display: inline-block; margin: 0 .5rem .5rem 0; vertical-align: top }
figcaption { font-size: .8rem; color: #555; max-width: 16rem; overflow-wrap: anywhere }
img { height: 12rem }
img[src$=svg] { height: auto; max-width: 100% }
</style>
<h1>Pictures of the class</h1>
";

/// The page for the folder of the results; none if there is no picture.
pub fn page(folder: &Path, graded: &[Graded]) -> Option<String> {
    let mut sheets = BTreeMap::<_, Vec<_>>::new();
    for student in graded {
        for judged in &student.results {
            if !judged.outcome.pictures.is_empty() {
                let of_sheet = sheets.entry(&judged.name).or_default();
                of_sheet.push((&student.name, &judged.outcome));
            }
        }
    }
    if sheets.is_empty() {
        return None;
    }
    let mut page = BEGINNING.to_owned();
    for (sheet, programs) in sheets {
        let _ = writeln!(page, "<h2>{sheet}</h2>");
        for (student, outcome) in programs {
            let (name, mistake) = (escaped(student), escaped(&outcome.mistake));
            let count = outcome.message.lines().next().unwrap_or_default();
            let _ = writeln!(page, "<h3>{name}</h3>\n<p>{count}<br>{mistake}</p>");
            for path in &outcome.pictures {
                let path = path.strip_prefix(folder).unwrap_or(path).to_string_lossy();
                let (_, file) = path.rsplit_once('/').unwrap_or_default();
                let _ = writeln!(
                    page,
                    "<figure><img src=\"{path}\" alt=\"\" loading=\"lazy\"><figcaption>{file}</figcaption></figure>"
                );
            }
        }
    }
    Some(page)
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;")
}
