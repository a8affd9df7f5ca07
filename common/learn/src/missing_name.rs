//! `find_missing_name`: a name that a check asks for and that a student's file does not define, or
//! hides. The compiler would send the student into the check, or to the lesson's item of this name.

use crate::exercise::Exercise;
use crate::files;

/// Words before the name of an item.
const KINDS: [&str; 6] = ["const", "enum", "fn", "static", "struct", "type"];

/// Words by which a file may define a name without an item.
const OTHER_MEANS: [&str; 4] = ["macro_rules!", "pub use", "pub(crate) use", "include!"];

/// How a text defines a name.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Definition {
    Missing,
    Private,
    Public,
}

/// What is wrong with a student's text that lacks a name which the check asks for.
pub fn find_missing_name(e: &Exercise, text: &str) -> Option<String> {
    let check = files::read(&format!("{}/tests/exercises/{}.rs", e.stage, e.name)).ok()?;
    let (_, asked) = check.split_once("yours! {")?;
    // The names stand before `=>`, or alone.
    let names = asked.split(['=', '}']).next()?;
    for name in names
        .split(',')
        .map(str::trim)
        .filter(|name| !name.is_empty())
    {
        match find_definition(text, name) {
            Definition::Missing => return Some(format!("the file lacks `{name}`")),
            Definition::Private => {
                return Some(format!(
                    "the check does not see `{name}`; write `pub` before it"
                ));
            }
            Definition::Public => {}
        }
    }
    None
}

/// How a text defines a name. By other means than an item, it may do so.
fn find_definition(text: &str, name: &str) -> Definition {
    if OTHER_MEANS.iter().any(|means| text.contains(means)) {
        return Definition::Public;
    }
    let mut found = Definition::Missing;
    let mut last = "";
    let mut is_public = false;
    for line in text.lines() {
        let code = line.split("//").next().unwrap_or_default();
        for word in code.split(|c: char| !c.is_alphanumeric() && c != '_') {
            if word == name && KINDS.contains(&last) {
                if is_public {
                    return Definition::Public;
                }
                found = Definition::Private;
            }
            if !word.is_empty() {
                // Between `pub` and a name are words of the language only.
                is_public = word == "pub" || is_public && is_between(word);
                last = word;
            }
        }
    }
    found
}

/// Whether the word may stand between `pub` and the name of an item.
fn is_between(word: &str) -> bool {
    KINDS.contains(&word)
        || ["crate", "super", "self", "in", "unsafe", "async", "mut"].contains(&word)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_a_file_without_the_item_lacks_it() {
        let sphere = crate::exercise::find("sphere").unwrap();
        let starter = files::starter(sphere).unwrap();
        let found = |old: &str, new: &str| {
            let text = starter.replace(old, new);
            find_missing_name(sphere, &text).unwrap_or_default()
        };
        let lacks = "the file lacks `Sphere`";
        assert_eq!(found("struct Sphere", "struct Ball"), lacks);
        assert_eq!(found("pub struct Sphere", "// pub struct Sphere"), lacks);
        assert_eq!(find_missing_name(sphere, "").unwrap(), lacks);
        let hides = "the check does not see `Sphere`; write `pub` before it";
        assert_eq!(found("pub struct Sphere", "struct Sphere"), hides);
        // Other styles are right.
        assert_eq!(
            found("pub struct Sphere", "pub(crate) struct\n    Sphere"),
            ""
        );
        let type_of_another = "struct Ball;\npub type Sphere = Ball;\nstruct Old";
        assert_eq!(found("pub struct Sphere", type_of_another), "");
        assert!(find_definition("pub const fn f() {}", "f") == Definition::Public);
        // All starters have what their checks ask for.
        for e in crate::exercise::read_all().unwrap() {
            let starter = files::starter(e).unwrap();
            assert_eq!(find_missing_name(e, &starter), None, "{}", e.name);
        }
    }
}
