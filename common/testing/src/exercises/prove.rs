//! `prove`: proves the exercises of a stage by starters, solutions and mistakes, and locks the
//! recorded answers.

use std::error::Error;
use std::process::ExitCode;
use std::sync::RwLock;
use std::{env, fs, panic};

use common::difference::compare_with_file;
use common::{Image, Transfer, picture_file};
use exercise::{Record, compare_picture};
use libtest_mimic::{Arguments, Trial};

use super::exercise::{Exercise, Variant};
use super::folder::StageFolder;
use super::program::{Findings, Program, Reader};

/// Starters write into one list of missing parts, and so run alone.
static WITH_STARTER: RwLock<()> = RwLock::new(());

type Proof = Result<(), Box<dyn Error>>;

/// The codes of type `C` by which an exercise is proved.
pub struct Codes<C> {
    /// The exercise.
    pub exercise: fn() -> Exercise<C>,
    /// The code of the solution.
    pub solution: fn() -> C,
    /// The examples of the solution.
    pub examples: fn(),
    /// The code of the starter.
    pub starter: fn() -> C,
}

/// An exercise, and how it is proved.
pub struct Entry {
    name: &'static str,
    prove: Box<dyn Fn(&Author) -> Proof + Send + Sync>,
}

impl Entry {
    /// The exercise of this name.
    #[must_use]
    pub fn new<C: 'static>(name: &'static str, codes: Codes<C>) -> Self {
        let prove = Box::new(move |author: &Author| codes.prove(name, author));
        Self { name, prove }
    }
}

/// The author, who proves exercises.
#[derive(Clone, Copy)]
struct Author {
    folder: StageFolder,
    /// Whether messages about mistakes are printed, and pictures saved.
    is_shown: bool,
    /// Whether the answers are recorded anew.
    records: bool,
}

/// Proves that starters are to do, that solutions are accepted with their examples, that mistakes are
/// refused and recognised, and that the recorded answers are those of the solutions. A solution in
/// which something is missing, as in a workbook for students, is not proved.
///
/// The arguments are those of every test. With a part of a name, the messages about
/// mistakes are printed, and the pictures of the solutions are saved, with the drawings of starters
/// and mistakes, which should show what is wrong. With `always` in the
/// variable `INSTA_UPDATE` of the environment, the answers are recorded anew.
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
        let prove = move || (entry.prove)(&author).map_err(Into::into);
        trials.push(Trial::test(entry.name, prove));
    }
    libtest_mimic::run(&arguments, trials).exit_code()
}

impl<C: 'static> Codes<C> {
    fn program(&self, code: C) -> Program {
        Program::new((self.exercise)(), code)
    }

    /// The mistakes, each with what it overlooks.
    fn mistakes(&self) -> Vec<(&'static str, Program)> {
        let Exercise { usual, wrong, .. } = (self.exercise)();
        let program =
            |Variant { overlooks, make }| (overlooks, self.program(make((self.solution)())));
        usual.into_iter().chain(wrong).map(program).collect()
    }

    fn prove(&self, name: &str, author: &Author) -> Proof {
        let folder = &author.folder;
        let solution = self.program((self.solution)());
        {
            let _alone = WITH_STARTER.write();
            if solution.is_unfinished() {
                return Ok(());
            }
            let starter = self.program((self.starter)());
            if !starter.is_unfinished() {
                return Err("nothing is missing in the starter".into());
            }
            let drawing = starter.draw(true, author.reader());
            author.save_drawing(drawing.as_ref(), name, "unfinished");
        }
        let _together = WITH_STARTER.read();
        let mistakes = self.mistakes();
        if mistakes.len() < 3 {
            return Err("there are less than three mistakes".into());
        }
        let record = self.record(&solution, &mistakes);
        author.compare(name, &record)?;

        let found = solution.run(self.examples, &record, folder, author.reader());
        if !found.verdict.wrong.is_empty() {
            return Err(format!("the solution: {}", found.verdict.wrong.join("\n")).into());
        }
        author.compare_picture(name, &found)?;
        for (overlooks, program) in mistakes {
            let found = program.run(|| (), &record, folder, author.reader());
            let known = found.verdict.known.as_deref().unwrap_or_default();
            if author.is_shown {
                println!(
                    "{overlooks}\n  {}\n  {known}",
                    found.verdict.wrong.join("\n  ")
                );
            }
            author.save_drawing(found.drawing.as_ref(), name, overlooks);
            if !known.ends_with(&format!(" that {overlooks}")) {
                return Err(format!("{overlooks}: accepted, or taken for another: {known}").into());
            }
        }
        Ok(())
    }

    /// The record of the solution's answers, and of those of the mistakes.
    fn record(&self, solution: &Program, mistakes: &[(&str, Program)]) -> Record {
        let rounding_flaw = (self.exercise)().rounding_flaw;
        let rows = solution.rows(rounding_flaw.is_some());
        let mistakes = mistakes.iter();
        Record {
            rounding_flaw: rounding_flaw.map(str::to_owned),
            picture: solution.scene().map(str::to_owned),
            mistakes: mistakes
                .map(|(overlooks, program)| program.mistake(overlooks, &rows))
                .collect(),
            rows,
        }
    }
}

impl Author {
    fn reader(&self) -> Reader {
        if self.is_shown {
            Reader::Student
        } else {
            Reader::Author
        }
    }

    /// Records answers and the picture of a scene with few samples, or fails if the recorded ones
    /// differ.
    fn compare(&self, name: &str, record: &Record) -> Proof {
        let file = self.folder.record_file(name);
        let picture = match &record.picture {
            Some(scene) => self.folder.recorded_picture(scene)?,
            None => None,
        };
        let answers = record.to_string();
        if self.records {
            fs::write(file, answers)?;
            if let Some((file, image)) = picture {
                picture_file::save_png(&file, image.size(), &image.to_rgb8(Transfer::Linear))?;
            }
            return Ok(());
        }
        if let Some((file, image)) = picture {
            compare_with_file(&file, &image)?;
        }
        let recorded = fs::read_to_string(&file)?;
        let mut lines = (1..).zip(recorded.lines().zip(answers.lines()));
        match lines.find(|(_, (old, new))| old != new) {
            None if recorded.lines().count() == answers.lines().count() => Ok(()),
            None => Err("the recorded answers are incomplete".into()),
            Some((line, (old, new))) => Err(format!(
                "line {line} of the recorded answers is\n  {old}\nand would be\n  {new}\n\
                 if it is right, record it: INSTA_UPDATE=always"
            )
            .into()),
        }
    }

    /// Fails if the picture is not the one of this name in the book.
    fn compare_picture(&self, name: &str, found: &Findings) -> Proof {
        let Some(image) = found.drawing.as_ref().or(found.image.as_ref()) else {
            return Ok(());
        };
        let stage = self.folder.stage().name;
        let file = format!("{stage}-exercise-{}.png", name.replace('_', "-"));
        if self.is_shown {
            println!("{}", self.folder.save(image, &file));
        }
        let shown = self.folder.in_book(&file);
        if shown.is_file() {
            compare_picture(&shown, image, Some(&self.folder.pictures()))?;
        }
        Ok(())
    }

    /// Saves what code draws that is wrong or unfinished, if the author looks at this exercise.
    fn save_drawing(&self, drawing: Option<&Image>, name: &str, about: &str) {
        if let Some(drawing) = drawing.filter(|_| self.is_shown) {
            let words = about.replace(|letter: char| !letter.is_alphanumeric(), "-");
            println!(
                "{}",
                self.folder.save(drawing, &format!("{name}-{words}.png"))
            );
        }
    }
}
