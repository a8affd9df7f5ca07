//! The starter of an exercise: its solution without the code that the student writes.

use proc_macro2::TokenTree;

use crate::exercise::Exercise;
use crate::files::read;
use crate::tokens;

/// The text of the starter: the solution without its code. In a workbook without solutions, such a
/// file is a starter already.
pub fn starter(exercise: &Exercise) -> Result<String, String> {
    let file = exercise.solution_file();
    without_code(&read(&file)?).map_err(|error| format!("{file}: {error}"))
}

/// Leaves out the code of each `missing!("what", for_now, {…})`.
fn without_code(solution: &str) -> Result<String, String> {
    replace_missing(solution, |given, _| format!("testing::missing({given})"))
}

/// A solution as a student would hand it in: with the code of each `missing!("what", for_now, {…})`.
///
/// # Errors
///
/// Fails if a `missing!` is not complete.
pub fn with_code(solution: &str) -> Result<String, String> {
    replace_missing(solution, |_, code| code.to_owned())
}

/// Replaces each `missing!("what", for_now, {…})` by a text, made of the first two arguments and of the code.
fn replace_missing(solution: &str, text: impl Fn(&str, &str) -> String) -> Result<String, String> {
    tokens::replace(solution, &|tokens| {
        let [_, _, TokenTree::Group(call), ..] = tokens else {
            return Ok(None);
        };
        if !tokens::begin(tokens, &["missing", "!"]) {
            return Ok(None);
        }
        let arguments: Vec<_> = call.stream().into_iter().collect();
        match &*arguments {
            [given @ .., comma, TokenTree::Group(code)] if comma.to_string() == "," => {
                let given = &solution[tokens::range(given)];
                let code = code.stream().to_string();
                Ok(Some((3, text(given, &code))))
            }
            _ => Err("a `missing!` must end with `, {`, the code, and `})`".to_owned()),
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn starters_lack_the_code_and_nothing_else() {
        let solution = "// missing!(\"a\", 1, {\nconst A: &str = \"missing!(0, 1, {2})\";\n\
            fn f<'a>() -> Option<(char, &'a str)> {\n    missing!(\n        \"a }) b\", // It stays.\n        \
            None::<(char, &'a str)>,\n        { /* }) */ Some(('\"', r#\"})\"#)) }\n    )\n}\n";
        let starter = "// missing!(\"a\", 1, {\nconst A: &str = \"missing!(0, 1, {2})\";\n\
            fn f<'a>() -> Option<(char, &'a str)> {\n    testing::missing(\"a }) b\", // It stays.\n        \
            None::<(char, &'a str)>)\n}\n";
        assert_eq!(without_code(solution).as_deref(), Ok(starter));
        for (wrong, words) in [
            ("fn f() { missing!(\"a\", 1, 2) }", "must end with"),
            ("\nfn f() { missing!(\"a\", 1, {2} }", "line 2"),
        ] {
            let error = without_code(wrong).unwrap_err();
            assert!(error.contains(words), "{error}");
        }
        let whole = with_code("fn a() { missing!(\"one\", 0, { 1 + 2 }) }").unwrap();
        assert_eq!(whole.replace(' ', ""), "fna(){1+2}");
    }
}
