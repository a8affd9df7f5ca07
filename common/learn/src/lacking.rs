//! `lacking`: a name that a check asks for and that a student's file does not define. The compiler
//! would answer that the lesson's item of this name is private.

use crate::exercise::Exercise;
use crate::files;

/// Words before the name of an item.
const KINDS: [&str; 6] = ["const", "enum", "fn", "static", "struct", "type"];

/// What is wrong with a student's text that lacks a name which the check asks for.
pub fn lacking(e: &Exercise, text: &str) -> Option<String> {
    let check = files::read(&format!("{}/tests/exercises/{}.rs", e.stage, e.name));
    let check = check.unwrap_or_default();
    let (_, asked) = check.split_once("yours! {")?;
    // The names stand before `=>`, or alone.
    let names = asked.split(['=', '}']).next()?;
    let mut names = names.split(',').map(str::trim);
    let name = names.find(|name| !name.is_empty() && !may_define(text, name))?;
    Some(format!("the file lacks `{name}`"))
}

/// Whether a text defines this name, or may do so by other means than an item.
fn may_define(text: &str, name: &str) -> bool {
    if ["macro_rules!", "pub use", "include!"]
        .iter()
        .any(|means| text.contains(means))
    {
        return true;
    }
    let words: Vec<_> = text
        .split(|c: char| !c.is_alphanumeric() && c != '_')
        .filter(|word| !word.is_empty())
        .collect();
    let mut pairs = words.windows(2);
    pairs.any(|pair| KINDS.contains(&pair[0]) && pair[1] == name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_a_file_without_the_item_lacks_it() {
        let sphere = crate::exercise::find("sphere").unwrap();
        let starter = files::starter(sphere).unwrap();
        assert_eq!(lacking(sphere, &starter), None);
        let renamed = starter.replace("struct Sphere", "struct Ball");
        let lacks = Some("the file lacks `Sphere`".to_owned());
        assert_eq!(lacking(sphere, &renamed), lacks);
        // All starters have what their checks ask for.
        for e in crate::exercise::read_all().unwrap() {
            assert_eq!(lacking(e, &files::starter(e).unwrap()), None, "{}", e.name);
        }
    }
}
