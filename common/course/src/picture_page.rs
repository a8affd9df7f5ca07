//! A page with all pictures of a class, by sheets and students.

use std::fmt::Write;

use crate::outcome::Graded;

const BEGINNING: &str = "<!doctype html>
<meta charset=\"utf-8\">
<title>Pictures of the class</title>
<style>
body { font-family: sans-serif; margin: 1rem }
figure { display: inline-block; margin: 0 .5rem .5rem 0; vertical-align: top }
figcaption { font-size: .8rem; color: #555; max-width: 16rem; overflow-wrap: anywhere }
img { height: 12rem }
</style>
<h1>Pictures of the class</h1>
";

/// The page; none if no picture is kept.
pub fn page(graded: &[Graded]) -> Option<String> {
    let results = graded.iter().flat_map(|student| &student.results);
    let mut sheets = Vec::new();
    for judged in results {
        if !judged.pictures.is_empty() && !sheets.contains(&&judged.name) {
            sheets.push(&judged.name);
        }
    }
    if sheets.is_empty() {
        return None;
    }
    let mut page = BEGINNING.to_owned();
    for sheet in sheets {
        let _ = writeln!(page, "<h2>{}</h2>", escaped(sheet));
        for student in graded {
            for judged in student
                .results
                .iter()
                .filter(|judged| judged.name == *sheet)
            {
                let first = judged
                    .outcome
                    .message
                    .lines()
                    .next()
                    .unwrap_or("all facts hold");
                let (name, first) = (escaped(&student.name), escaped(first));
                let state = judged.outcome.state.words();
                let _ = writeln!(page, "<h3>{name}</h3>\n<p>{state}: {first}</p>");
                for path in &judged.pictures {
                    let (_, file) = path.rsplit_once('/').unwrap_or_default();
                    let (path, file) = (url(path), escaped(file));
                    let _ = writeln!(
                        page,
                        "<figure><img src=\"{path}\" alt=\"\" loading=\"lazy\"><figcaption>{file}</figcaption></figure>"
                    );
                }
            }
        }
    }
    Some(page)
}

fn escaped(text: &str) -> String {
    let text = text.replace('&', "&amp;").replace('<', "&lt;");
    text.replace('"', "&quot;")
}

/// A path as an address.
fn url(path: &str) -> String {
    let mut url = String::new();
    for byte in path.bytes() {
        if byte.is_ascii_alphanumeric() || b"-_./".contains(&byte) {
            url.push(byte.into());
        } else {
            let _ = write!(url, "%{byte:02X}");
        }
    }
    url
}
