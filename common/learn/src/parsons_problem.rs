//! A Parsons problem: the lines of a solution in shuffled order, as the first hint of an exercise of
//! the core path. (Parsons and Haden, Parson's Programming Puzzles, 2006)

use common::fnv1a;

use crate::exercise::Exercise;
use crate::files;

/// The hint of an exercise; none of an exercise beyond the core path.
pub fn hint(exercise: &Exercise) -> Option<String> {
    let mut blocks = Vec::new();
    for pieces in functions(exercise)? {
        let lines = shuffled(exercise.name, &pieces).join("\n");
        blocks.push(format!("\n```text\n{lines}\n```\n"));
    }
    if blocks.is_empty() {
        return None;
    }
    let blocks = blocks.concat();
    Some(format!(
        "\nHint: the lines in another order\n\nThese are lines of a solution in shuffled order, without \
         indents,\ncomments and brackets that stand alone. Which line needs the result of which?\n{blocks}"
    ))
}

/// The pieces of each function that is to be written, in the right order, from the file
/// `exercises/hints/NAME.rs`: the starter with lines that the check accepts. A line that the
/// starter has, too, is no piece.
fn functions(exercise: &Exercise) -> Option<Vec<Vec<String>>> {
    let path = format!("{}/exercises/hints/{}.rs", exercise.stage, exercise.name);
    let right = files::read(&path).ok()?;
    let starter = files::starter(exercise).ok()?;
    let mut functions = Vec::new();
    for opening in openings(&starter) {
        let given: Vec<_> = body(&starter, opening)?.lines().collect();
        let written = body(&right, opening)?;
        let new: Vec<_> = written
            .lines()
            .filter(|line| !given.contains(line))
            .collect();
        functions.push(pieces(&new.join("\n")));
    }
    Some(functions)
}

/// The beginnings of the functions of a starter in which something is missing.
fn openings(starter: &str) -> Vec<&str> {
    let mut opening = "";
    let mut openings = Vec::new();
    for line in starter.lines().map(str::trim) {
        if let Some((before, _)) = line.split_once('(')
            && (before.starts_with("fn ") || before.starts_with("pub fn "))
        {
            opening = &line[..=before.len()];
        }
        if line.contains("testing::missing") && !line.starts_with("//") {
            openings.push(opening);
        }
    }
    openings.dedup();
    openings
}

/// The lines of a function, which a bracket opens and another one at the same depth closes.
fn body<'a>(text: &'a str, opening: &str) -> Option<&'a str> {
    let (_, rest) = text.split_once(opening)?;
    let (_, rest) = rest.split_once("{\n")?;
    let mut depth = 1;
    let end = rest.find(|letter| {
        depth += match letter {
            '{' => 1,
            '}' => -1,
            _ => 0,
        };
        depth == 0
    })?;
    Some(&rest[..end])
}

/// The pieces of the code in their right order: its statements and the beginnings of its blocks, or,
/// of a single statement, the terms of its expression. None if there is nothing to put in order.
fn pieces(body: &str) -> Vec<String> {
    let mut pieces: Vec<String> = Vec::new();
    for line in body.lines().map(str::trim) {
        if line.starts_with("//") {
            continue;
        }
        if let Some(before) = pieces.last_mut()
            && (line.starts_with('.') || is_unfinished(before))
        {
            let is_member = line.starts_with('.') && !line.starts_with("..");
            let has_space = !is_member && !line.starts_with(')') && !before.ends_with('(');
            *before += if has_space { " " } else { "" };
            *before += line;
            *before = before.replace(",)", ")").replace(", }", " }");
        } else if !line.chars().all(|letter| "(){}[];,".contains(letter)) {
            pieces.push(line.to_owned());
        }
    }
    if let [line] = &*pieces {
        pieces = terms(line);
    }
    if pieces.len() < 2 {
        pieces.clear();
    }
    pieces
}

/// Whether a statement goes on in the next line, because of its brackets. A block is no part of the
/// statement that begins it.
fn is_unfinished(statement: &str) -> bool {
    let count = |bracket| statement.matches(bracket).count();
    let is_open = count('(') > count(')') || count('{') > count('}');
    statement.ends_with('=') || is_open && !begins_block(statement)
}

/// Whether a block begins at the end of a statement, and not the fields of a structure, whose name
/// has a capital letter.
fn begins_block(statement: &str) -> bool {
    let Some(before) = statement.strip_suffix(" {") else {
        return false;
    };
    let name = before.rsplit([' ', '(', ':']).next().unwrap_or_default();
    let has_condition = ["if ", "} else if "]
        .iter()
        .any(|word| statement.starts_with(word));
    has_condition || !name.starts_with(char::is_uppercase)
}

/// An expression, cut before the operators outside of inner brackets. An expression in brackets is
/// cut inside of them, unless they hold several arguments.
fn terms(line: &str) -> Vec<String> {
    let mut depths = Vec::new();
    let mut depth = 0;
    for letter in line.chars() {
        depth += match letter {
            '(' => 1,
            ')' => -1,
            _ => 0,
        };
        depths.push(depth);
    }
    let letters: Vec<char> = line.chars().collect();
    let is_operator = |at: usize| matches!(letters[at..], [' ', '+' | '-' | '*' | '/', ' ', ..]);
    let least = (0..letters.len())
        .filter(|at| is_operator(*at))
        .map(|at| depths[at])
        .min();
    let has_arguments =
        (0..letters.len()).any(|at| letters[at] == ',' && Some(depths[at]) == least);
    if has_arguments {
        return vec![line.to_owned()];
    }
    let mut terms = vec![String::new()];
    for (at, letter) in letters.iter().enumerate() {
        if is_operator(at) && Some(depths[at]) == least {
            terms.push(String::new());
        } else if let Some(term) = terms.last_mut() {
            term.push(*letter);
        }
    }
    terms
}

/// The pieces in another order, which is always the same for an exercise.
fn shuffled(exercise: &str, pieces: &[String]) -> Vec<String> {
    let mut shuffled = pieces.to_vec();
    shuffled.sort_by_cached_key(|piece| fnv1a([exercise, piece].concat().as_bytes()));
    if shuffled == pieces {
        shuffled.rotate_left(1);
    }
    shuffled
}

/// The first hint of an exercise, if it has lines to put in order, and then the others.
pub fn add_first_hint(exercise: &mut Exercise) {
    if let Some(hint) = hint(exercise) {
        exercise.hints.insert(0, hint);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exercise;

    #[test]
    fn each_core_exercise_has_its_lines_in_another_order() {
        for e in exercise::read_all().unwrap() {
            let first = &e.hints[0];
            let name = e.name;
            assert_eq!(
                first.contains("shuffled order"),
                e.is_core,
                "{name}: {first}"
            );
            assert!(e.hints.len() > usize::from(e.is_core), "{name}");
            let functions = functions(e).unwrap_or_default();
            assert_eq!(functions.is_empty(), !e.is_core, "{name}");
            for right in functions {
                let mut shuffled = shuffled(name, &right);
                assert!(right.len() > 1, "{name}: {right:?}");
                assert_ne!(shuffled, right, "{name}");
                let is_trimmed = shuffled.iter().all(|line| line.trim() == line);
                assert!(is_trimmed, "{name}: {shuffled:?}");
                let mut right = right;
                shuffled.sort();
                right.sort();
                assert_eq!(shuffled, right, "{name}");
            }
        }
    }

    #[test]
    fn a_line_alone_is_cut_before_its_operators() {
        assert_eq!(
            pieces("    a.b() * (c - 1.0) + d\n"),
            ["a.b()", "* (c - 1.0)", "+ d"]
        );
        assert_eq!(
            pieces("Self(a * (b - c) - d)"),
            ["Self(a", "* (b - c)", "- d)"]
        );
        assert!(pieces("    f(a * b, c)\n").is_empty());
        assert!(pieces("// Words.\n-a\n").is_empty());
    }

    #[test]
    fn lines_are_whole_statements_without_indents() {
        let code =
            "let a =\n    b;\n// Why.\nlet c = a\n    .d();\nif c {\n    return;\n}\n(a, c)\n";
        let pieces = pieces(code);
        assert_eq!(
            pieces,
            [
                "let a = b;",
                "let c = a.d();",
                "if c {",
                "return;",
                "(a, c)"
            ]
        );
        let brackets = "f(\n    a,\n    b,\n);\nif a == B {\n    c(|d| {\n        e\n    });\n}\nSome(A {\n    b,\n    ..c\n})";
        let lines = [
            "f(a, b);",
            "if a == B {",
            "c(|d| {",
            "e",
            "Some(A { b, ..c })",
        ];
        assert_eq!(super::pieces(brackets), lines);
        // An order that the hashes find right is changed, too.
        for name in ["a", "b", "c", "d", "e", "f", "g", "h"] {
            assert_ne!(shuffled(name, &pieces[..2]), pieces[..2]);
        }
    }
}
