//! Signatures: what a check calls in a student's file. Where the file has another form, the compiler
//! reports an error in the check, which is not the student's.

use crate::exercise::Exercise;
use crate::files;

/// Beginnings of lines that say the form of an item.
const BEGINNINGS: [&str; 5] = ["pub fn ", "pub struct ", "pub enum ", "pub type ", "fn "];

/// The form that the check asks for, if the first error of the compiler is outside of the student's
/// file.
pub fn explain_outside_error(e: &Exercise, errors: &str) -> Option<String> {
    let place = errors.lines().find(|line| line.contains("--> "))?;
    let file = format!("exercises/{}.rs:", e.name);
    if place.contains(&file) && !place.contains("tests/exercises/") {
        return None;
    }
    let starter = files::starter(e).ok()?;
    Some(format!(
        "the check calls your code in the form that the starter has:\n{}",
        find_signatures(&starter)
    ))
}

/// The signatures in a starter before its examples, one a line.
fn find_signatures(starter: &str) -> String {
    let code = starter.split("testing::examples!").next();
    let mut signatures = Vec::new();
    let mut unfinished = String::new();
    for line in code.unwrap_or_default().lines().map(str::trim) {
        let begins = BEGINNINGS.iter().any(|words| line.starts_with(words));
        if unfinished.is_empty() && !begins {
            continue;
        }
        if !unfinished.is_empty() {
            unfinished.push(' ');
        }
        unfinished += line;
        if line.ends_with(['{', ';', '}']) {
            let signature = unfinished.trim_end_matches([' ', '{', ';']);
            let signature = signature.replace("( ", "(").replace(", )", ")");
            signatures.push(format!("    {signature}"));
            unfinished.clear();
        }
    }
    signatures.join("\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_error_in_the_check_shows_the_form_of_the_starter() {
        let sphere = crate::exercise::find("sphere").unwrap();
        let own = "error: x\n --> a04-intersections/exercises/sphere.rs:4:12\n";
        assert_eq!(explain_outside_error(sphere, own), None);
        for place in [
            "a04-intersections/tests/exercises/sphere.rs:5:1",
            "out/exercises.rs:1",
        ] {
            let words = explain_outside_error(sphere, &format!("error: x\n  --> {place}\n{own}"));
            let words = words.unwrap();
            assert!(words.contains("\n    pub struct Sphere\n"), "{words}");
            assert!(words.ends_with("Option<Hit>"), "{words}");
        }
        let broken = "pub fn f(\n    x: f64,\n) -> f64 {\n    x\n}\ntesting::examples! {}";
        assert_eq!(find_signatures(broken), "    pub fn f(x: f64) -> f64");
        for e in crate::exercise::read_all().unwrap() {
            let signatures = find_signatures(&files::starter(e).unwrap());
            assert!(signatures.contains("    pub "), "{}: {signatures}", e.name);
        }
    }
}
