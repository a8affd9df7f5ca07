//! `prove`: proves the exercises of a stage by starters, solutions and variants, and locks the
//! recorded answers.

use std::process::ExitCode;
use std::sync::{Arc, RwLock};
use std::{env, fs, panic};

use common::difference::compare_with_file;
use common::{Transfer, picture_file};
use exercise::{Record, compare_picture};
use libtest_mimic::{Arguments, Failed, Trial};

use super::folder::StageFolder;
use super::kind::{Exercise, Group, Variant};
use super::program::{Findings, Program, Reader};

/// Starters write into one list of missing parts, and so run alone.
static WITH_STARTER: RwLock<()> = RwLock::new(());

/// An exercise, and the codes by which it is proved.
pub struct Entry {
    name: &'static str,
    codes: Box<dyn Codes>,
}

/// The codes of an exercise.
trait Codes: Send + Sync {
    /// The starter and its examples.
    fn starter(&self, found: &[Vec<f64>]) -> (Program, fn());

    /// The solution, and the starter's examples.
    fn solution(&self, found: &[Vec<f64>]) -> (Program, fn());

    /// Right solutions in another style.
    fn right(&self, found: &[Vec<f64>]) -> Vec<(&'static str, Program)>;

    /// The usual mistakes of its kind.
    fn common_mistakes(&self, found: &[Vec<f64>]) -> Vec<(&'static str, Program)>;

    /// Further mistakes.
    fn wrong(&self, found: &[Vec<f64>]) -> Vec<(&'static str, Program)>;

    /// The record of the solution's answers, and of those of the mistakes.
    fn record(&self) -> Record;
}

/// The codes of an exercise of one type.
struct TypedExercise<C> {
    exercise: fn() -> Exercise<C>,
    starter: fn() -> C,
    starter_examples: fn(),
    solution: fn() -> C,
    solution_examples: fn(),
}

/// An exercise with its starter and its solution, and the examples of the starter with either.
pub fn entry<C: 'static>(
    name: &'static str,
    exercise: fn() -> Exercise<C>,
    starter: fn() -> C,
    starter_examples: fn(),
    solution: fn() -> C,
    solution_examples: fn(),
) -> Entry {
    let codes = Box::new(TypedExercise {
        exercise,
        starter,
        starter_examples,
        solution,
        solution_examples,
    });
    Entry { name, codes }
}

/// The lines of an exercise's first hint in the right order.
pub struct Hint {
    name: &'static str,
    program: Box<dyn Fn(&Record) -> Program + Send + Sync>,
}

/// The hint of an exercise with this code.
pub fn hint<C: 'static>(
    name: &'static str,
    exercise: fn() -> Exercise<C>,
    code: fn() -> C,
) -> Hint {
    let program = move |record: &Record| Program::new(exercise(), code(), &record.found);
    Hint {
        name,
        program: Box::new(program),
    }
}

impl<C: 'static> TypedExercise<C> {
    fn variants(
        &self,
        variants: Vec<Variant<C>>,
        found: &[Vec<f64>],
    ) -> Vec<(&'static str, Program)> {
        let variants = variants.into_iter().map(|variant| {
            let code = (variant.make)((self.solution)());
            (variant.about, Program::new((self.exercise)(), code, found))
        });
        variants.collect()
    }
}

impl<C: 'static> Codes for TypedExercise<C> {
    fn starter(&self, found: &[Vec<f64>]) -> (Program, fn()) {
        let program = Program::new((self.exercise)(), (self.starter)(), found);
        (program, self.starter_examples)
    }

    fn solution(&self, found: &[Vec<f64>]) -> (Program, fn()) {
        let program = Program::new((self.exercise)(), (self.solution)(), found);
        (program, self.solution_examples)
    }

    fn right(&self, found: &[Vec<f64>]) -> Vec<(&'static str, Program)> {
        self.variants((self.exercise)().right, found)
    }

    fn common_mistakes(&self, found: &[Vec<f64>]) -> Vec<(&'static str, Program)> {
        self.variants((self.exercise)().usual, found)
    }

    fn wrong(&self, found: &[Vec<f64>]) -> Vec<(&'static str, Program)> {
        self.variants((self.exercise)().wrong, found)
    }

    fn record(&self) -> Record {
        let exercise = (self.exercise)();
        let rounding_flaw = exercise.rounding_flaw;
        let solution = (self.solution)();
        let searches = exercise.questions.iter().filter_map(|group| match group {
            Group::Searched(search) => Some((search.find)(&solution)),
            Group::Known(_) => None,
        });
        let found: Vec<_> = searches.collect();
        let program = Program::new(exercise, solution, &found);
        let picture = program.scene().map(str::to_owned);
        let rows = program.rows(rounding_flaw.is_some());
        let mistakes = self
            .common_mistakes(&found)
            .into_iter()
            .chain(self.wrong(&found));
        let mistakes = mistakes.map(|(about, program)| program.mistake(about, &rows));
        let mistakes = mistakes.collect();
        Record {
            rounding_flaw: rounding_flaw.map(str::to_owned),
            picture,
            found,
            rows,
            mistakes,
        }
    }
}

/// What the trials of an exercise share.
struct Proof {
    entry: Entry,
    folder: StageFolder,
    record: Result<Record, String>,
    is_shown: bool,
}

/// Proves that starters are to do, that examples hold for the solutions, that right variants are
/// accepted and mistakes refused and recognised, that the lines of hints are right, and that the
/// recorded answers are those of the solutions.
///
/// The arguments are those of every test. With a part of a name, the messages about
/// mistakes are printed, and the pictures of the solutions are saved, with the drawings of starters
/// and mistakes, which should show what is wrong. With `always` in the
/// variable `INSTA_UPDATE` of the environment, the answers are recorded anew.
#[must_use]
pub fn prove(folder: &StageFolder, entries: Vec<Entry>, hints: Vec<Hint>) -> ExitCode {
    let arguments = Arguments::from_args();
    let is_shown = arguments.filter.is_some();
    if env::var("INSTA_UPDATE").is_ok_and(|update| update == "always") {
        let filter = arguments.filter.as_deref().unwrap_or_default();
        let is_chosen = |entry: &&Entry| format!("{}::", entry.name).contains(filter);
        for entry in entries.iter().filter(is_chosen) {
            if let Err(problem) = update(folder, entry) {
                eprintln!("{}: {problem}", entry.name);
                return ExitCode::FAILURE;
            }
        }
    }
    panic::set_hook(Box::new(move |panic| {
        if is_shown {
            println!("{panic}");
        }
    }));
    // Starters come first, so that they do not wait for others to end.
    let (mut starters, mut trials) = (Vec::new(), Vec::new());
    for entry in entries {
        let proof = Arc::new(Proof {
            record: folder.record(entry.name),
            entry,
            folder: *folder,
            is_shown,
        });
        starters.push(proof.trial("starter", Proof::starter));
        trials.push(proof.trial("answers", Proof::answers));
        trials.push(proof.trial("solution", Proof::solution));
        let codes = &proof.entry.codes;
        for (index, (about, _)) in codes.right(&[]).into_iter().enumerate() {
            let prove = move |proof: &Proof, record: &Record| proof.right(record, index);
            trials.push(proof.trial(&format!("right: {about}"), prove));
        }
        for (index, (about, _)) in codes.wrong(&[]).into_iter().enumerate() {
            let prove = move |proof: &Proof, record: &Record| proof.wrong(record, index);
            trials.push(proof.trial(&format!("wrong: {about}"), prove));
        }
    }
    starters.extend(trials);
    for hint in hints {
        let (folder, name) = (*folder, hint.name);
        let prove = move || accept_hint(&hint, &folder);
        starters.push(Trial::test(format!("{name}::hint"), prove));
    }
    libtest_mimic::run(&arguments, starters).exit_code()
}

/// Fails if the lines of a hint, in the right order, are no right solution.
fn accept_hint(hint: &Hint, folder: &StageFolder) -> Result<(), Failed> {
    let _together = WITH_STARTER.read();
    let record = folder.record(hint.name)?;
    let found = (hint.program)(&record).run(|| (), &record, folder, Reader::Author);
    let is_right = found.verdict.wrong.is_empty() && found.missing.is_empty();
    is_right
        .then_some(())
        .ok_or(found.verdict.wrong.join("\n").into())
}

/// Records the answers of an exercise.
fn update(folder: &StageFolder, entry: &Entry) -> std::io::Result<()> {
    let file = folder.record_file(entry.name);
    file.parent().map_or(Ok(()), fs::create_dir_all)?;
    let record = entry.codes.record();
    fs::write(file, record.to_string())?;
    if let Some(scene) = record.picture
        && let Some((file, image)) = folder.recorded_picture(&scene).map_err(other)?
    {
        let bytes = image.to_rgb8(Transfer::Linear);
        picture_file::save_png(&file, image.size(), &bytes).map_err(other)?;
    }
    Ok(())
}

fn other(error: common::Error) -> std::io::Error {
    std::io::Error::other(error)
}

impl Proof {
    /// A trial that needs the record.
    fn trial(
        self: &Arc<Self>,
        about: &str,
        prove: impl FnOnce(&Self, &Record) -> Result<(), Failed> + Send + 'static,
    ) -> Trial {
        let proof = self.clone();
        Trial::test(format!("{}::{about}", proof.entry.name), move || {
            prove(&proof, proof.record.as_ref()?)
        })
    }

    fn run(&self, record: &Record, program: &Program, examples: fn()) -> Findings {
        let reader = if self.is_shown {
            Reader::Student
        } else {
            Reader::Author
        };
        program.run(examples, record, &self.folder, reader)
    }

    /// Saves what code draws that is wrong or unfinished, if the author looks at this exercise.
    fn save_drawing(&self, found: &Findings, about: &str) {
        if let Some(drawing) = found.drawing.as_ref().filter(|_| self.is_shown) {
            let words = about.replace(|letter: char| !letter.is_alphanumeric(), "-");
            let name = format!("{}-{words}.png", self.entry.name);
            println!("{}", self.folder.save(drawing, &name));
        }
    }

    fn starter(&self, record: &Record) -> Result<(), Failed> {
        let _alone = WITH_STARTER.write();
        let (starter, examples) = self.entry.codes.starter(&record.found);
        let found = self.run(record, &starter, examples);
        self.save_drawing(&found, "unfinished");
        let is_to_do = !found.missing.is_empty();
        is_to_do.then_some(()).ok_or("nothing is missing".into())
    }

    /// Fails if the recorded answers are not those of the solution and of the mistakes.
    fn answers(&self, record: &Record) -> Result<(), Failed> {
        let _together = WITH_STARTER.read();
        if let Some(scene) = &record.picture
            && let Some((file, image)) = self.folder.recorded_picture(scene)?
        {
            compare_with_file(&file, &image)?;
        }
        let printed = self.entry.codes.record().to_string();
        let recorded = record.to_string();
        let mut lines = (1..).zip(recorded.lines().zip(printed.lines()));
        let Some((line, (old, new))) = lines.find(|(_, (old, new))| old != new) else {
            let is_equal = recorded == printed;
            return is_equal
                .then_some(())
                .ok_or("the record is incomplete".into());
        };
        Err(format!(
            "line {line} of the recorded answers is\n  {old}\nand would be\n  {new}\n\
             if it is right, record it: INSTA_UPDATE=always"
        )
        .into())
    }

    fn solution(&self, record: &Record) -> Result<(), Failed> {
        let _together = WITH_STARTER.read();
        let codes = &self.entry.codes;
        let (solution, examples) = codes.solution(&record.found);
        let found = self.run(record, &solution, examples);
        let (stage, name) = (self.folder.stage().name, self.entry.name.replace('_', "-"));
        self.accept(&found, Some(&format!("{stage}-exercise-{name}.png")))?;
        if record.mistakes.len() < 3 {
            return Err("there are less than three mistakes".into());
        }
        for (about, program) in codes.common_mistakes(&record.found) {
            self.refuse(about, &self.run(record, &program, || ()))?;
        }
        Ok(())
    }

    fn right(&self, record: &Record, index: usize) -> Result<(), Failed> {
        let _together = WITH_STARTER.read();
        let (_, program) = self.entry.codes.right(&record.found).swap_remove(index);
        self.accept(&self.run(record, &program, || ()), None)
    }

    fn wrong(&self, record: &Record, index: usize) -> Result<(), Failed> {
        let _together = WITH_STARTER.read();
        let (about, program) = self.entry.codes.wrong(&record.found).swap_remove(index);
        self.refuse(about, &self.run(record, &program, || ()))
    }

    /// Fails if right code is refused, or if its picture is not the one of this name in the book.
    fn accept(&self, found: &Findings, picture: Option<&str>) -> Result<(), Failed> {
        let mut problems = found.verdict.wrong.clone();
        for missing in &found.missing {
            problems.push(format!("it lacks {}", missing.what));
        }
        let shown = found.drawing.as_ref().or(found.image.as_ref());
        if let (Some(image), Some(name)) = (shown, picture) {
            if self.is_shown {
                println!("{}", self.folder.save(image, name));
            }
            let shown = self.folder.in_book(name);
            if shown.is_file() {
                let compared = compare_picture(&shown, image, Some(&self.folder.pictures()));
                problems.extend(compared.err());
            }
        }
        let is_right = problems.is_empty();
        is_right.then_some(()).ok_or(problems.join("\n").into())
    }

    /// Fails if a mistake is accepted, or if it is not recognised.
    fn refuse(&self, about: &str, found: &Findings) -> Result<(), Failed> {
        let known = found.verdict.known.as_deref().unwrap_or_default();
        if self.is_shown {
            println!("{about}\n  {}\n  {known}", found.verdict.wrong.join("\n  "));
        }
        self.save_drawing(found, about);
        let is_known = known.starts_with("this is") && known.ends_with(about);
        let accepted = || format!("the check accepts it, or takes it for another: {known}").into();
        is_known.then_some(()).ok_or_else(accepted)
    }
}
