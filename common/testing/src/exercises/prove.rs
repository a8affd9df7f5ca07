//! `prove`: proves the exercises of a stage by starters, solutions and known mistakes, and locks the
//! recorded answers.

use std::error::Error;
use std::process::ExitCode;
use std::{env, fs, panic};

use common::difference::{compare_with_file, leave_pictures};
use common::{Transfer, picture_file};
use exercise::{Record, Row};
use libtest_mimic::{Arguments, Trial};

use super::exercise::Picture;
use super::findings::{Findings, Reader, difference};
use super::folder::StageFolder;
use super::{Entry, as_starter};

type Proof = Result<(), Box<dyn Error>>;

/// The author, who proves exercises.
#[derive(Clone, Copy)]
struct Author {
    folder: StageFolder,
    /// Whether messages about mistakes are printed, and the picture saved.
    is_shown: bool,
    /// Whether the answers are recorded anew.
    records: bool,
}

/// Proves that starters are to do, that solutions are accepted with their examples, that known mistakes
/// are wrong and recognised, and that the recorded answers are those of the solutions. A solution in
/// which something is missing, as in a workbook for students, is not proved.
///
/// The arguments are those of every test. With a part of a name, the messages about mistakes are
/// printed, and the picture of the solution is saved. With `always` in the variable `INSTA_UPDATE` of the
/// environment, the answers are recorded anew.
#[must_use]
pub fn prove(folder: &StageFolder, entries: Vec<Entry>) -> ExitCode {
    let arguments = Arguments::from_args();
    let author = Author {
        folder: *folder,
        is_shown: arguments.filter.is_some(),
        records: env::var("INSTA_UPDATE").is_ok_and(|update| update == "always"),
    };
    panic::set_hook(Box::new(move |panic| {
        if author.is_shown {
            println!("{panic}");
        }
    }));
    let mut trials = Vec::new();
    for entry in entries {
        let name = entry.name;
        let prove = move || author.prove(&entry).map_err(Into::into);
        trials.push(Trial::test(name, prove));
    }
    libtest_mimic::run(&arguments, trials).exit_code()
}

impl Author {
    fn prove(&self, entry: &Entry) -> Proof {
        let (name, folder) = (entry.name, &self.folder);
        let mut exercise = (entry.exercise)();
        let recorded = folder.record(name, &mut exercise)?;
        if exercise.is_unfinished() {
            return Ok(());
        }
        if !as_starter(|| exercise.is_unfinished()) {
            return Err("nothing is missing in the starter".into());
        }
        let record = self.compare(name, recorded, exercise.rows(), &exercise.picture)?;
        let found = exercise.run(entry.examples, Some(&record), folder, self.reader());
        if !found.verdict.wrong.is_empty() {
            return Err(format!("the solution: {}", found.verdict.wrong.join("\n")).into());
        }
        self.compare_picture(name, &found)?;
        let asked = exercise.questions.iter();
        let questions: Vec<_> = asked.map(|asked| asked.question.text.clone()).collect();
        for mistake in &record.mistakes {
            let overlooks = &mistake.overlooks;
            let verdict = record.prove(mistake, &questions);
            let verdict = verdict.map_err(|problem| format!("mistake {overlooks}: {problem}"))?;
            if self.is_shown {
                let known = verdict.known.unwrap_or_default();
                println!("{}\n{known}\n", verdict.wrong.join("\n"));
            }
        }
        Ok(())
    }

    fn reader(&self) -> Reader {
        if self.is_shown {
            Reader::Student
        } else {
            Reader::Author
        }
    }

    /// Records the rows of the solution and the picture of a scene with few samples, or fails if the
    /// recorded ones differ. Known mistakes stay.
    fn compare(
        &self,
        name: &str,
        recorded: Record,
        rows: Vec<Row>,
        picture: &Picture<()>,
    ) -> Result<Record, Box<dyn Error>> {
        let file = self.folder.record_file(name);
        let picture = match picture {
            Picture::Scene(scene, _) => self.folder.recorded_picture(scene)?,
            _ => None,
        };
        if self.records {
            let (record, messages) = recorded.with_rows(rows);
            for message in messages {
                println!("{name}: {message}");
            }
            fs::write(file, record.to_string())?;
            if let Some((file, image)) = picture {
                picture_file::save_png(&file, image.size(), &image.to_rgb8(Transfer::Linear))?;
            }
            return Ok(record);
        }
        if let Some((file, image)) = picture {
            compare_with_file(&file, &image)?;
        }
        let record = Record { rows, ..recorded };
        let (recorded, answers) = (fs::read_to_string(&file)?, record.to_string());
        let mut lines = (1..).zip(recorded.lines().zip(answers.lines()));
        if let Some((line, (old, new))) = lines.find(|(_, (old, new))| old != new) {
            return Err(format!(
                "line {line} of the recorded answers is\n  {old}\nand would be\n  {new}\n\
                 if it is right, record it: INSTA_UPDATE=always"
            )
            .into());
        }
        if recorded != answers {
            return Err("the recorded answers are incomplete".into());
        }
        Ok(record)
    }

    /// Fails if the picture is not the one of this name in the book.
    fn compare_picture(&self, name: &str, found: &Findings) -> Proof {
        let Some(image) = &found.image else {
            return Ok(());
        };
        let stage = self.folder.stage().name;
        let file = format!("{stage}-exercise-{}.png", name.replace('_', "-"));
        if self.is_shown {
            println!("{}", self.folder.save(image, &file));
        }
        let shown = self.folder.in_book(&file);
        if shown.is_file()
            && let Some(difference) = difference(&shown, image)
        {
            return Err(leave_pictures(&self.folder.pictures(), &shown, image, &difference).into());
        }
        Ok(())
    }
}
