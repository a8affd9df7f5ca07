//! Runs the exercises of a stage, and proves their starters and solutions.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use common::atomic_file;

use super::check::{Findings, Pictures};
use super::starter::starter;
use super::task::{Task, asked_for};
use super::{Exercise, Stage, page};

/// The result of an exercise.
enum Verdict {
    Passed(&'static str),
    Failed(Vec<String>),
    ToDo(Vec<String>),
}

/// Runs the exercises that the arguments of this process select.
///
/// As for every test, a part of a name selects exercises, and the other arguments of
/// `cargo test` are allowed. It fails if an exercise has been begun and is wrong.
#[must_use]
pub fn run(stage: &Stage, exercises: &[Exercise]) -> ExitCode {
    let (task, names) = asked_for(std::env::args().skip(1));
    let wanted: Vec<_> = exercises
        .iter()
        .filter(|e| names.is_empty() || names.iter().any(|name| e.name.contains(name)))
        .collect();
    if std::env::args().any(|argument| argument == "--list") {
        for exercise in wanted {
            println!("{}: test", exercise.name);
        }
        return ExitCode::SUCCESS;
    }

    println!("\nexercises of {}", stage.name);
    if wanted.is_empty() {
        let known: Vec<_> = exercises.iter().map(|exercise| exercise.name).collect();
        println!(
            "none is called {}; there are {}",
            names.join(", "),
            known.join(", ")
        );
    }
    let mut verdicts = Vec::new();
    for exercise in wanted {
        let place = Place { stage, exercise };
        let verdict = match task {
            Task::Check => place.check(!names.is_empty()),
            Task::Starters => place.prove_starter(),
            Task::Solutions => place.prove_solution(!names.is_empty()),
            Task::WriteStarters => place.write_starter(),
        };
        report(exercise.name, &verdict);
        verdicts.push(verdict);
    }
    if task == Task::Starters {
        let verdict = prove_page(stage, exercises);
        report("page of the book", &verdict);
        verdicts.push(verdict);
    }
    sum_up(&verdicts)
}

/// The paths of the files of an exercise.
struct Place<'a> {
    stage: &'a Stage,
    exercise: &'a Exercise,
}

impl Place<'_> {
    fn starter(&self) -> PathBuf {
        let file = format!("exercises/{}.rs", self.exercise.name);
        Path::new(self.stage.folder).join(file)
    }

    /// The starter, made from the solution.
    fn generated(&self) -> Result<String, String> {
        let file = format!("exercises/solutions/{}.rs", self.exercise.name);
        starter(&read(&Path::new(self.stage.folder).join(file))?)
    }

    /// The path for a picture, if its folder can be made.
    fn left(&self, ending: &str) -> Option<PathBuf> {
        let folder = Path::new(self.stage.folder).parent()?.join("out/exercises");
        fs::create_dir_all(&folder).ok()?;
        let name = self.exercise.name.replace('_', "-");
        Some(folder.join(format!("{}-{name}{ending}.png", self.stage.name)))
    }

    /// The picture of the solution in the book, if there is one.
    fn shown(&self) -> Option<PathBuf> {
        let name = self.exercise.name.replace('_', "-");
        let file = format!("{}-exercise-{name}.png", self.stage.name);
        let path = Path::new(self.stage.folder)
            .join("../book/src/pictures")
            .join(file);
        path.exists().then_some(path)
    }

    fn check(&self, paint: bool) -> Verdict {
        let pictures = Pictures {
            left: paint.then(|| self.left("")).flatten(),
            shown: None,
        };
        let Findings { missing, wrong } = Findings::of(self.exercise.starter, pictures);
        if !missing.is_empty() {
            Verdict::ToDo(missing)
        } else if wrong.is_empty() {
            Verdict::Passed("done")
        } else {
            Verdict::Failed(wrong)
        }
    }

    fn prove_starter(&self) -> Verdict {
        let problem = match (self.generated(), read(&self.starter())) {
            (Err(problem), _) | (_, Err(problem)) => problem,
            (Ok(generated), Ok(starter)) if generated != starter => {
                "it is not what its solution makes it; --write-starters does".to_owned()
            }
            _ => {
                let Findings { missing, wrong } =
                    Findings::of(self.exercise.starter, Pictures::default());
                if missing.is_empty() {
                    "it does not say what is missing".to_owned()
                } else if wrong.is_empty() {
                    "nothing is written, and nothing differs".to_owned()
                } else {
                    return Verdict::Passed("ok");
                }
            }
        };
        Verdict::Failed(vec![problem])
    }

    fn prove_solution(&self, paint: bool) -> Verdict {
        let pictures = Pictures {
            left: paint.then(|| self.left("-solution")).flatten(),
            shown: self.shown(),
        };
        let Findings { missing, wrong } = Findings::of(self.exercise.solution, pictures);
        if missing.is_empty() && wrong.is_empty() {
            Verdict::Passed("ok")
        } else {
            Verdict::Failed([missing, wrong].concat())
        }
    }

    fn write_starter(&self) -> Verdict {
        let written = self.generated().and_then(|text| {
            let written = atomic_file::write(&self.starter(), text.as_bytes());
            written.map_err(|error| error.to_string())
        });
        match written {
            Ok(()) => Verdict::Passed("written"),
            Err(problem) => Verdict::Failed(vec![problem]),
        }
    }
}

fn prove_page(stage: &Stage, exercises: &[Exercise]) -> Verdict {
    let number = stage.name.split('-').next().unwrap_or_default();
    let path = format!("../book/src/{number}-exercises.md");
    let problems = match read(&Path::new(stage.folder).join(path)) {
        Ok(page) => page::problems(&page, exercises),
        Err(problem) => vec![problem],
    };
    if problems.is_empty() {
        Verdict::Passed("ok")
    } else {
        Verdict::Failed(problems)
    }
}

fn read(path: &Path) -> Result<String, String> {
    let text = fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()))?;
    // On Windows, Git may check out files with its line endings.
    Ok(text.replace("\r\n", "\n"))
}

fn report(name: &str, verdict: &Verdict) {
    match verdict {
        Verdict::Passed(word) => println!("exercise {name} ... {word}"),
        Verdict::ToDo(missing) => println!("exercise {name} ... to do: {}", missing.join("; ")),
        Verdict::Failed(reasons) => {
            println!("exercise {name} ... not yet");
            for reason in reasons {
                println!("    {reason}");
            }
        }
    }
}

/// Prints the last line, in the format of all tests.
fn sum_up(verdicts: &[Verdict]) -> ExitCode {
    let count = |is: fn(&Verdict) -> bool| verdicts.iter().filter(|v| is(v)).count();
    let passed = count(|v| matches!(v, Verdict::Passed(_)));
    let failed = count(|v| matches!(v, Verdict::Failed(_)));
    let to_do = count(|v| matches!(v, Verdict::ToDo(_)));
    let word = if failed == 0 { "ok" } else { "FAILED" };
    println!("\ntest result: {word}. {passed} passed; {failed} failed; {to_do} to do\n");
    ExitCode::from(u8::from(failed > 0))
}
