//! `Unnamed`: files of a class that are wrong in the same way, which no known mistake explains. A lecturer
//! sees which sentence is worth writing.

use std::cmp::Reverse;
use std::fs;

use common::fnv1a;
use judge::answers::{KnownMistake, Record, StudentAnswer, verdict};
use learn::exercise::Exercise;
use learn::files::{self, with_path};

use crate::exercise_record::record;

/// The folder with a file of each group, in the lecturer's workbook. No student's program sees it.
const FOLDER: &str = "target/unnamed";

/// The most groups that are shown.
const MAX_GROUPS: usize = 10;

/// Groups of files.
#[derive(Default)]
pub struct Unnamed {
    groups: Vec<Group>,
}

/// Files of an exercise that give the same wrong answers.
struct Group {
    exercise: &'static Exercise,
    /// The right answers, and these wrong ones as a mistake.
    record: Record,
    /// The first student, and the text of the file.
    student: String,
    text: String,
    count: usize,
}

impl Unnamed {
    /// Adds a student's file by its wrong answers. A program that panics says itself why.
    pub fn add(
        &mut self,
        e: &'static Exercise,
        student: &str,
        text: &str,
        given: &[StudentAnswer],
    ) -> Result<(), String> {
        if given.is_empty() {
            return Ok(());
        }
        for group in &mut self.groups {
            if group.exercise == e && verdict(&group.record, given).known.is_some() {
                group.count += 1;
                return Ok(());
            }
        }
        let record = record(e)?;
        let mut its = Vec::new();
        for (question, StudentAnswer { answer, .. }) in record.questions.iter().zip(given) {
            let Some(answer) = answer else {
                return Ok(());
            };
            its.push(question.right.with_answer(answer.clone()));
        }
        let mistakes = vec![KnownMistake::new("", &record.questions, &its)];
        self.groups.push(Group {
            exercise: e,
            record: Record { mistakes, ..record },
            student: student.to_owned(),
            text: text.to_owned(),
            count: 1,
        });
        Ok(())
    }

    /// The groups of two and more, the largest first, each with the command that names it. A file of each
    /// is saved for this command.
    pub fn list(mut self) -> Result<String, String> {
        self.groups.retain(|group| group.count > 1);
        self.groups.sort_by_key(|group| Reverse(group.count));
        let mut list =
            vec!["wrong in the same way, without a sentence that says why:\n".to_owned()];
        for group in self.groups.iter().take(MAX_GROUPS) {
            let (count, name, student) = (group.count, group.exercise.name, &group.student);
            let file = group.save()?;
            list.push(format!("  {count} of {name}, such as {student}'s\n"));
            list.push(format!(
                "      cargo course mistake {file} \"the fact they overlook\"\n"
            ));
        }
        Ok(if self.groups.is_empty() {
            String::new()
        } else {
            list.concat()
        })
    }
}

impl Group {
    /// Saves the file under the name of its exercise, and returns its place.
    fn save(&self) -> Result<String, String> {
        let hash = fnv1a(self.text.as_bytes()) >> 40;
        let folder = files::shortest(&format!("{FOLDER}/{hash:06x}"));
        fs::create_dir_all(&folder).map_err(with_path(&folder))?;
        let file = folder.join(format!("{}.rs", self.exercise.name));
        fs::write(&file, &self.text).map_err(with_path(&file))?;
        Ok(file.display().to_string())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_with_the_same_wrong_answers_are_one_group() {
        let e = learn::exercise::find("reflected").unwrap();
        let Record {
            questions,
            mistakes,
            ..
        } = record(e).unwrap();
        let given = |mistake: usize| {
            let mut given = Vec::new();
            for answer in mistakes[mistake].answers(&questions) {
                given.push(StudentAnswer {
                    answer: Some(answer),
                    ..StudentAnswer::default()
                });
            }
            given
        };
        let mut panics = given(2);
        panics[0].answer = None;
        let mut unnamed = Unnamed::default();
        for (student, given) in [
            ("ada", given(0)),
            ("bob", given(1)),
            ("cleo", given(0)),
            ("dan", panics.clone()),
            ("eve", panics),
            ("fay", Vec::new()),
        ] {
            unnamed.add(e, student, "// Ada's", &given).unwrap();
        }
        let list = unnamed.list().unwrap();
        let (_, list) = list.split_once('\n').unwrap();
        let (about, command) = list.split_once('\n').unwrap();
        assert_eq!(about, "  2 of reflected, such as ada's");
        let words: Vec<_> = command.split_whitespace().collect();
        assert_eq!(words[..3], ["cargo", "course", "mistake"]);
        assert_eq!(fs::read_to_string(words[3]).unwrap(), "// Ada's");
        assert_eq!(list.lines().count(), 2, "{list}");
    }
}
