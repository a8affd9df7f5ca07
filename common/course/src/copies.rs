//! Copies: hand-ins whose code is that of another student or of the workbook, but for names, comments and layout.
//!
//! This finds what is copied as it is. The page for lecturers names tools that find more.

use std::collections::{BTreeMap, BTreeSet};

use learn::tokens;
use proc_macro2::{Delimiter, TokenStream, TokenTree};

use crate::outcome::Graded;

/// Files with fewer tokens are alike by chance.
const MIN_TOKENS: usize = 150;

/// Whose code the workbook's own is.
const WORKBOOK: &str = "the workbook";

/// Code in which a name is the number of its first appearance.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Structure(Vec<String>);

impl Structure {
    /// The structure of a file; none if it is no Rust, or too short.
    pub fn read(text: &str) -> Option<Self> {
        let mut structure = Self::default();
        structure.add(tokens::read(text).ok()?, &mut BTreeMap::new());
        (structure.0.len() >= MIN_TOKENS).then_some(structure)
    }

    fn add(&mut self, tokens: TokenStream, names: &mut BTreeMap<String, usize>) {
        let tokens: Vec<_> = tokens.into_iter().collect();
        let mut at = 0;
        while let Some(token) = tokens.get(at) {
            let others = not_compared(&tokens[at..]);
            if others > 0 {
                at += others;
                continue;
            }
            at += 1;
            match token {
                TokenTree::Group(group) => {
                    self.0.push(format!("{:?}", group.delimiter()));
                    self.add(group.stream(), names);
                    self.0.push("end".to_owned());
                }
                TokenTree::Ident(name) => {
                    let next = names.len();
                    let number = *names.entry(name.to_string()).or_insert(next);
                    self.0.push(format!("name {number}"));
                }
                TokenTree::Punct(_) | TokenTree::Literal(_) => self.0.push(token.to_string()),
            }
        }
    }
}

/// How many of these tokens, from the first on, are a comment of documentation, or what the workbook gives to all: the
/// examples of an exercise, and a function `main`, whose lines stand in the book.
fn not_compared(tokens: &[TokenTree]) -> usize {
    let is_doc = |token: Option<&TokenTree>| {
        let Some(TokenTree::Group(bracket)) = token else {
            return false;
        };
        let inner: Vec<_> = bracket.stream().into_iter().collect();
        bracket.delimiter() == Delimiter::Bracket && tokens::begin(&inner, &["doc", "="])
    };
    let is_body = |token: &TokenTree| matches!(token, TokenTree::Group(group) if group.delimiter() == Delimiter::Brace);
    if tokens::begin(tokens, &["#"]) && is_doc(tokens.get(1)) {
        2
    } else if tokens::begin(tokens, &["#", "!"]) && is_doc(tokens.get(2)) {
        3
    } else if tokens::begin(tokens, &["fn", "main"])
        || tokens::begin(tokens, &["testing", ":", ":", "examples", "!"])
    {
        tokens.iter().position(is_body).map_or(0, |body| body + 1)
    } else {
        0
    }
}

/// The workbook's own code, by the names of exercises and sheets.
#[derive(Debug, Default)]
pub struct WorkbooksCode(BTreeMap<String, Vec<Structure>>);

impl WorkbooksCode {
    pub fn add(&mut self, name: &str, text: &str) {
        let of_name = self.0.entry(name.to_owned()).or_default();
        of_name.extend(Structure::read(text));
    }
}

/// A solution as a student would hand it in: with the code of each `missing!("what", for_now, {…})`.
pub fn with_code(solution: &str) -> Result<String, String> {
    tokens::replace(solution, &|tokens| {
        let [_, _, TokenTree::Group(call), ..] = tokens else {
            return Ok(None);
        };
        if !tokens::begin(tokens, &["missing", "!"]) {
            return Ok(None);
        }
        let code = call.stream().into_iter().last();
        let code = code.map_or(String::new(), |code| code.to_string());
        let code = code
            .strip_prefix('{')
            .and_then(|code| code.strip_suffix('}'));
        Ok(code.map(|code| (3, code.to_owned())))
    })
}

/// Writes into each hand-in who else has the same code, and returns a line for each.
pub fn mark(graded: &mut [Graded], workbooks: &WorkbooksCode) -> Vec<String> {
    let mut owners = BTreeMap::<_, BTreeSet<&str>>::new();
    for (name, structures) in &workbooks.0 {
        for structure in structures {
            owners
                .entry((name, structure))
                .or_default()
                .insert(WORKBOOK);
        }
    }
    for student in &*graded {
        for judged in &student.results {
            for structure in &judged.structures {
                let owners = owners.entry((&judged.name, structure)).or_default();
                owners.insert(&student.name);
            }
        }
    }
    let mut same = Vec::new();
    for student in &*graded {
        for judged in &student.results {
            let mut others = BTreeSet::<&str>::new();
            for structure in &judged.structures {
                others.extend(owners[&(&judged.name, structure)].iter().copied());
            }
            others.remove(&*student.name);
            same.push(others.into_iter().collect::<Vec<_>>().join(", "));
        }
    }
    let mut lines = Vec::new();
    let mut same = same.into_iter();
    for student in graded {
        for judged in &mut student.results {
            judged.same_code_as = same.next().unwrap_or_default();
            if !judged.same_code_as.is_empty() {
                let (name, others) = (&judged.name, &judged.same_code_as);
                lines.push(format!("  {name} of {}: as that of {others}", student.name));
            }
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::outcome::{Judged, Outcome, State};

    /// A function whose name, comment and layout a copy changes, or whose number differs.
    fn code(name: &str, comment: &str, number: u32) -> String {
        let line = format!("{comment}\n    {name}_sum = {name}_sum * x + f64::from({number});\n");
        let lines = line.repeat(20);
        format!(
            "pub fn {name}(x: f64) -> f64 {{\n    let mut {name}_sum = x;\n{lines}    {name}_sum\n}}\n"
        )
    }

    #[test]
    fn copies_are_found_under_other_names() {
        let structure = |text: &str| Structure::read(text).unwrap();
        let hand_in = |student: &str, code: &str| Graded {
            name: student.to_owned(),
            file_name: student.to_owned(),
            results: vec![Judged {
                stage: "sheet",
                name: "glass".to_owned(),
                file: String::new(),
                structures: vec![structure(code)],
                same_code_as: String::new(),
                outcome: Outcome::without_answers(State::Right, ""),
            }],
        };
        let mut graded = [
            hand_in("ada", &code("refract", "", 3)),
            hand_in("bob", &code("bend", "// my own\n\n", 3)),
            hand_in(
                "eva",
                &format!("//! Mine.\n{}", code("bend", "/// Mine, too.\n", 3)),
            ),
            hand_in("cleo", &code("refract", "", 4)),
            hand_in("dan", &code("solved", "", 5)),
        ];
        let mut workbooks = WorkbooksCode::default();
        workbooks.add("glass", &code("answer", "", 5));
        let lines = mark(&mut graded, &workbooks);
        let same: Vec<_> = graded
            .iter()
            .map(|of| &*of.results[0].same_code_as)
            .collect();
        assert_eq!(same, ["bob, eva", "ada, eva", "ada, bob", "", WORKBOOK]);
        assert_eq!(lines[1], "  glass of bob: as that of ada, eva");
        assert_eq!(Structure::read("pub fn a() {}"), None);
        let solution = with_code("fn a() { missing!(\"one\", 0, { 1 + 2 }) }").unwrap();
        assert_eq!(solution.replace(' ', ""), "fna(){1+2}");
    }

    #[test]
    fn what_the_workbook_gives_is_not_compared() {
        let long = code("refract", "", 3);
        let whole = |head: &str| Structure::read(&format!("{head} {{ {long} }}\n"));
        assert!(whole("fn other() -> u8").is_some());
        assert_eq!(whole("fn main() -> Result<(), Error>"), None);
        assert_eq!(whole("testing::examples!"), None);
    }
}
