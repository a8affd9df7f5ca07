//! Checks the book's page of exercises: it has a section for each, and no others.

use super::Exercise;

/// The problems of the page.
pub fn problems(page: &str, exercises: &[Exercise]) -> Vec<String> {
    let mut sections = page.split("\n## ").skip(1);
    let mut problems = Vec::new();
    for exercise in exercises {
        let section = sections.next().unwrap_or_default();
        let (heading, text) = section.split_once('\n').unwrap_or((section, ""));
        let (name, title) = (exercise.name, exercise.title);
        if heading != title {
            problems.push(format!(
                "the next heading is \"{heading}\", not \"{title}\""
            ));
            return problems;
        }
        for needed in [
            format!("{} minutes", exercise.minutes),
            format!("/exercises/{name}.rs"),
            format!("/exercises/solutions/{name}.rs"),
            format!("--test exercises -- {name}\n"),
        ] {
            if !text.contains(&needed) {
                problems.push(format!("\"{title}\" does not say \"{}\"", needed.trim()));
            }
        }
        let mut hints = text.split("<details>").skip(1).peekable();
        if hints.peek().is_none() || hints.any(|hint| !has_text(hint)) {
            problems.push(format!("\"{title}\" has no hint, or an empty one"));
        }
    }
    let more = sections.filter_map(|section| section.lines().next());
    problems.extend(more.map(|heading| format!("there is no exercise \"{heading}\"")));
    problems
}

/// Whether there is text between the summary of a hint and its end.
fn has_text(hint: &str) -> bool {
    hint.split_once("</summary>")
        .and_then(|(_, text)| text.split_once("</details>"))
        .is_some_and(|(text, _)| !text.trim().is_empty())
}

#[cfg(test)]
mod tests {
    use super::*;

    const PAGE: &str = "# Exercises

## The square

*10 minutes: a01/exercises/square.rs, a01/exercises/solutions/square.rs*

cargo test -p a01 --test exercises -- square

<details>
<summary>Hint</summary>

Multiply.

</details>
";

    fn found(page: &str) -> Vec<String> {
        let square = Exercise {
            name: "square",
            title: "The square",
            minutes: 10,
            starter: |_| (),
            solution: |_| (),
        };
        problems(page, &[square])
    }

    #[test]
    fn a_whole_section_has_no_problems() {
        assert_eq!(found(PAGE), [""; 0]);
    }

    #[test]
    fn missing_parts_of_a_section_are_named() {
        for (whole, broken, said) in [
            ("## The square", "## A square", "\"A square\", not"),
            ("10 minutes", "soon", "10 minutes"),
            ("/exercises/square", "/square", "/exercises/square.rs"),
            ("/solutions/", "/", "/solutions/square.rs"),
            ("-- square", "", "-- square"),
            ("Multiply.", "", "hint"),
            ("<details>", "", "hint"),
        ] {
            let problems = found(&PAGE.replacen(whole, broken, 1)).join("; ");
            assert!(problems.contains(said), "{problems}");
        }
        let two = format!("{PAGE}\n## The cube\n");
        assert_eq!(found(&two), ["there is no exercise \"The cube\""]);
    }
}
