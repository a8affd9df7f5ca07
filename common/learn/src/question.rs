//! `Question`: one of the questions in the section "Check yourself" of a chapter, which the book
//! shows with its answer folded.

use crate::exercise::Exercise;
use crate::files;

/// The heading of the section, and what stands around an answer.
const HEADING: &str = "\n## Check yourself\n";
const BEFORE_ID: &str = "\n\n<details class=\"answer\" id=\"";
const BEFORE_ANSWER: &str = "\">\n<summary>Answer</summary>\n\n";
const BEHIND_ANSWER: &str = "\n\n</details>\n";

/// A question. Its texts live as long as the program.
#[derive(Debug, PartialEq, Eq)]
pub struct Question {
    /// Its name in the page's address and in the file of what was asked.
    pub id: &'static str,
    /// The crate of the chapter.
    pub stage: &'static str,
    /// The heading of the chapter.
    pub chapter: &'static str,
    pub words: &'static str,
    pub answer: &'static str,
}

impl Question {
    /// The page on which it stands, in the workbook.
    pub fn page(&self) -> String {
        page(self.stage)
    }
}

fn page(stage: &str) -> String {
    format!("book/src/{stage}.md")
}

/// The questions of all chapters whose pages are there, in the order of the book.
pub fn read_all(course: &[Exercise]) -> Result<Vec<Question>, String> {
    let mut questions = Vec::new();
    for of_stage in course.chunk_by(|a, b| a.stage == b.stage) {
        let stage = of_stage[0].stage;
        let page = page(stage);
        if files::shortest(&page).exists() {
            let text = files::read(&page)?.replace("\r\n", "\n").leak();
            let of_chapter = read_page(stage, text);
            questions.append(&mut of_chapter.map_err(|problem| format!("{page}: {problem}"))?);
        }
    }
    Ok(questions)
}

/// The questions of a page; none if it has no such section.
fn read_page(stage: &'static str, text: &'static str) -> Result<Vec<Question>, String> {
    let Some((_, section)) = text.split_once(HEADING) else {
        return Ok(Vec::new());
    };
    let section = section.split("\n## ").next().unwrap_or_default();
    let heading = text.lines().next().unwrap_or_default();
    let mut questions = Vec::new();
    let mut rest = section;
    while let Some((before, details)) = rest.split_once(BEFORE_ID) {
        let words = before.rsplit("\n\n").next().unwrap_or_default();
        let words = words.trim().trim_matches('*');
        let answer = details.split_once(BEFORE_ANSWER);
        let answer = answer.and_then(|(id, rest)| Some((id, rest.split_once(BEHIND_ANSWER)?)));
        let Some((id, (answer, behind))) = answer else {
            return Err(format!("the question \"{words}\" has no id or no answer"));
        };
        questions.push(Question {
            id,
            stage,
            chapter: heading.trim_start_matches("# "),
            words,
            answer,
        });
        rest = behind;
    }
    Ok(questions)
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;
    use crate::exercise;

    /// Three questions a chapter, which ask why; an answer of some sentences, and no formula, which
    /// a terminal would show as code.
    #[test]
    fn each_chapter_has_three_questions() {
        let course = exercise::read_all().unwrap();
        let questions = read_all(course).unwrap();
        let mut ids = BTreeSet::new();
        for q in &questions {
            let id = q.id;
            let is_named = id.bytes().all(|b| b.is_ascii_lowercase() || b == b'-');
            assert!(is_named && ids.insert(id), "{id}");
            assert!(q.words.ends_with('?'), "{id}: {}", q.words);
            assert!(q.words.to_lowercase().contains("why"), "{id}");
            let words = q.answer.split_whitespace().count();
            assert!(
                (20..=90).contains(&words),
                "{id}: an answer of {words} words"
            );
            for text in [q.words, q.answer] {
                assert!(!text.contains(['$', '<', '*']), "{id}: {text}");
            }
        }
        let stages = course.chunk_by(|a, b| a.stage == b.stage);
        let stages: Vec<_> = stages.map(|of_stage| of_stage[0].stage).collect();
        for stage in stages {
            let count = questions.iter().filter(|q| q.stage == stage).count();
            assert_eq!(count, 3, "{stage}");
        }
    }

    #[test]
    fn a_question_without_an_answer_is_named() {
        let page = "# Rays\n\n## Check yourself\n\nAloud.\n\n**Why\nis it so?**\n\n\
            <details class=\"answer\" id=\"so\">\n<summary>Answer</summary>\n\nBecause.\n\n\
            </details>\n\n## Next\n";
        let question = Question {
            id: "so",
            stage: "a03",
            chapter: "Rays",
            words: "Why\nis it so?",
            answer: "Because.",
        };
        assert_eq!(read_page("a03", page).unwrap(), [question]);
        let broken = page.replace("</details>", "").leak();
        let problem = read_page("a03", broken).unwrap_err();
        assert!(problem.contains("Why\nis it so?"), "{problem}");
        assert!(read_page("a03", "# Rays\n").unwrap().is_empty());
    }
}
