//! `sheet`: judges the student's own program by the pictures that it draws for an open sheet.

mod history;
mod own_program;
mod precision;
mod speed_up;

use std::fs;
use std::path::{Path, PathBuf, absolute};

use clap::ArgGroup;
use common::{Median, atomic_file, text};
use judge::pictures::{Facts, Judgement, NAMES, Sheet, ask_facts};

use crate::build::{Build, build_own};
use crate::files::{self, MANIFEST, with_path};
use crate::screen::Screen;
use crate::{print, told};
use history::History;
pub use own_program::OwnProgram;
use precision::Report;

/// The folder of the sheets.
const SHEETS: &str = "common/judge/sheets";

/// The rounds of a report: as many as there is time for, in seconds.
const MIN_ROUNDS: usize = 3;
const MAX_ROUNDS: usize = 9;
const ENOUGH: f64 = 30.0;

/// The earlier reports that a diagram shows.
const SHOWN: usize = 5;

const NONE: &str = "this workbook has no sheets; later stages bring them";

/// Lists the open sheets, shows what one asks for, or judges your program by its pictures
#[derive(clap::Args)]
#[command(group(ArgGroup::new("judged").args(["folder", "program"]).multiple(true)))]
pub struct Command {
    /// A sheet [default: lists all]
    name: Option<String>,
    /// The folder of your program, which is built and asked for the pictures of the sheet
    folder: Option<PathBuf>,
    /// Starts a program in another language by these words, in the folder [default: this one], instead of a build
    #[arg(long, value_name = "WORDS", requires = "name")]
    program: Option<String>,
    /// Asks all facts, also after one that fails
    #[arg(long, requires = "judged")]
    all: bool,
    /// Draws error against run time of your program, in turns, and compares it with theory and your earlier reports
    #[arg(long, requires = "judged", conflicts_with = "all")]
    report: bool,
}

impl Command {
    /// Does what the command says, and returns its last words, which are an error if a fact fails.
    pub fn run(&self) -> Result<String, String> {
        let sheets = read_all()?;
        let Some(name) = &self.name else {
            return if sheets.is_empty() {
                Err(NONE.to_owned())
            } else {
                Ok(list(&sheets))
            };
        };
        let sheet = find(&sheets, name)?;
        let (folder, words) = match (&self.folder, &self.program) {
            (None, None) => return Ok(Screen::new().wrap(&about(sheet))),
            (Some(folder), None) => match built(sheet, folder)? {
                Some(executable) => (&**folder, vec![executable]),
                None => return Ok(String::new()),
            },
            (folder, Some(words)) => {
                let words = words.split_whitespace().map(str::to_owned).collect();
                (folder.as_deref().unwrap_or(Path::new(".")), words)
            }
        };
        let program = OwnProgram::new(sheet, folder, &words)?;
        if self.report {
            program.report(sheet)
        } else if self.all {
            judge_own_program(sheet, &program, Facts::All)
        } else {
            judge_own_program(sheet, &program, Facts::UntilOneFails)
        }
    }
}

/// The sheets of the workbook, in the order in which they are set.
///
/// # Errors
///
/// Fails if one cannot be read, with the file, the row and the key.
pub fn read_all() -> Result<Vec<Sheet>, String> {
    let mut sheets = Vec::new();
    for name in NAMES {
        let file = format!("{SHEETS}/{name}.toml");
        if files::shortest(&file).exists() {
            sheets.push(Sheet::read(name, &files::read(&file)?)?);
        }
    }
    Ok(sheets)
}

/// What a person reads about sheets that are open now.
pub(crate) fn open_words(sheets: &[Sheet]) -> String {
    let mut words = Vec::new();
    for Sheet { title, name, .. } in sheets {
        words.push(format!("{title} (`cargo learn sheet {name}`)"));
    }
    format!("open for your own program: {}", words.join(", "))
}

/// The exercises whose functions move into the student's program for a sheet.
pub(crate) fn steps() -> Result<Vec<String>, String> {
    Ok(read_all()?
        .into_iter()
        .flat_map(|sheet| sheet.steps)
        .collect())
}

/// The sheet of this name.
///
/// # Errors
///
/// Fails if there is none; the error has the nearest name.
pub fn find<'a>(sheets: &'a [Sheet], name: &str) -> Result<&'a Sheet, String> {
    let names: Vec<_> = sheets.iter().map(|sheet| &*sheet.name).collect();
    let found = sheets.iter().find(|sheet| sheet.name == name);
    found.ok_or_else(|| {
        let wrong = text::name(name);
        match text::nearest(&names, name) {
            _ if names.is_empty() => NONE.to_owned(),
            Some(nearest) => format!("no sheet is called {wrong}; the nearest is {nearest}"),
            None => format!("no sheet is called {wrong}; they are {}", names.join(", ")),
        }
    })
}

fn list(sheets: &[Sheet]) -> String {
    let mut lines = Vec::new();
    for Sheet {
        name,
        stage,
        hours,
        title,
        page,
        ..
    } in sheets
    {
        let page = files::page(page);
        lines.push(format!(
            "{name:10}  {stage:.3}  {hours:>2} h  {title:36} {page}"
        ));
    }
    lines.push(String::new());
    lines.push("`cargo learn sheet NAME` shows what it asks for".to_owned());
    lines.push("`cargo learn sheet NAME ../my-tracer` judges your program".to_owned());
    lines.join("\n")
}

/// What a sheet asks for.
fn about(sheet: &Sheet) -> String {
    let Sheet {
        name,
        title,
        page,
        hours,
        ..
    } = sheet;
    let page = files::page(page);
    let mut lines = vec![format!("{title} ({hours} h): {page}")];
    lines.push("\nYour program draws:".to_owned());
    for picture in &sheet.pictures {
        let samples: Vec<_> = picture.samples.iter().map(u32::to_string).collect();
        let (scene, size, samples) = (&picture.scene, picture.size, samples.join(", "));
        lines.push(format!("  {scene}, {size} pixels, samples: {samples}"));
    }
    lines.push("\nThe facts:".to_owned());
    for fact in &sheet.facts {
        lines.push(format!("  {}: {}", fact.name, fact.says));
    }
    lines.push(format!(
        "\n`cargo learn sheet {name} ../my-tracer` judges your program"
    ));
    lines.join("\n")
}

/// Builds the program in a folder; none if a person stops it.
fn built(sheet: &Sheet, folder: &Path) -> Result<Option<String>, String> {
    let shown = text::path(folder);
    if !folder.join(MANIFEST).is_file() {
        return Err(format!(
            "{shown} has no {MANIFEST}: it is not the folder of your program, which `cargo new` has made"
        ));
    }
    match build_own(folder, Screen::new().space(), &mut told(""))? {
        Build::Program(program) => Ok(Some(program)),
        Build::Failed(printed) => {
            print(&printed)?;
            Err(format!("{}: {shown} does not compile", sheet.name))
        }
        Build::Stopped => Ok(None),
    }
}

/// Asks the pictures of a program the facts, and prints what they say. The last words count the facts.
fn judge_own_program(sheet: &Sheet, program: &OwnProgram, facts: Facts) -> Result<String, String> {
    let judgement = program.judge(sheet, facts)?;
    print(&Screen::new().wrap(&judgement.report()))?;
    let words = format!(
        "{}: {}; the pictures are in {}",
        sheet.name,
        judgement.summary(),
        text::path(&program.pictures),
    );
    if judgement.first_failure().is_some() {
        return Err(words);
    }
    for picture in &sheet.pictures {
        if sheet.timed.as_ref() == Some(&picture.scene) {
            print(&program.speed_up(picture)?)?;
        }
    }
    Ok(words)
}

/// The diagram of a program that is judged already, as SVG, with the time of one run for each number of samples. None if
/// its pictures lack an error.
#[must_use]
pub fn diagram(judgement: &Judgement) -> Option<String> {
    let precision = judgement.precision().ok()?;
    let seconds: Vec<_> = precision.points.iter().map(|point| point.seconds).collect();
    let seconds = seconds.into_iter().map(|seconds| Median::of(vec![seconds]));
    let report = Report::new(judgement.sheet, precision, seconds).ok()?;
    report.diagrams(&[]).into_iter().next().map(|(_, svg)| svg)
}

impl OwnProgram {
    /// The program in a folder that these words start.
    fn new(sheet: &Sheet, folder: &Path, words: &[String]) -> Result<Self, String> {
        let [executable, arguments @ ..] = words else {
            return Err(
                "--program needs the words that start it, such as \"python3 my.py\"".to_owned(),
            );
        };
        Ok(Self {
            executable: executable.into(),
            arguments: arguments.to_vec(),
            folder: folder.to_owned(),
            pictures: files::shortest(&format!("out/sheets/{}", sheet.name)),
            environment: Vec::new(),
        })
    }

    /// Asks the program's pictures the facts of a sheet.
    pub fn judge<'a>(&self, sheet: &'a Sheet, facts: Facts) -> Result<Judgement<'a>, String> {
        fs::create_dir_all(&self.pictures).map_err(with_path(&self.pictures))?;
        Ok(ask_facts(sheet, facts, &mut |picture, run| {
            self.draw(picture, run, &mut told(&format!(": {}", run.words())))
        }))
    }

    /// Draws the pictures of which theory knows the error, in rounds, and prints error against run time. The last words are
    /// the paths of the diagrams.
    fn report(&self, sheet: &Sheet) -> Result<String, String> {
        let judgement = self.judge(sheet, Facts::WithTheory)?;
        let precision = judgement.precision()?;
        // The first runs have filled caches, and say how many rounds there is time for.
        let round: f64 = precision.points.iter().map(|point| point.seconds).sum();
        let rounds = ((ENOUGH / round) as usize).clamp(MIN_ROUNDS, MAX_ROUNDS);
        if round > 1.0 {
            eprintln!("{rounds} rounds of {round:.0} s");
        }
        let mut seconds = vec![Vec::new(); precision.points.len()];
        for _ in 0..rounds {
            for (seconds, run) in seconds.iter_mut().zip(precision.runs) {
                let drawn = self.draw(precision.picture, run, &mut |_, _| true)?;
                seconds.push(drawn.seconds);
            }
        }
        let report = Report::new(sheet, precision, seconds.into_iter().map(Median::of))?;

        let program = text::path(&absolute(&self.folder).unwrap_or(self.folder.clone()));
        let file = self.pictures.join("reports.csv");
        let history = History::read(&file, &program)?;
        let last = history.earlier.len().saturating_sub(SHOWN);
        let words = report.words(history.earlier.last());
        print(&Screen::new().wrap(&words))?;
        let mut paths = Vec::new();
        for (ending, svg) in report.diagrams(&history.earlier[last..]) {
            let path = self.pictures.join(format!("report.{ending}"));
            atomic_file::write(&path, svg.as_bytes()).map_err(|error| error.to_string())?;
            paths.push(text::path(&path));
        }
        history.add(&file, &program, &report)?;
        Ok(format!("{}: {}", sheet.name, paths.join(", ")))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exercise;

    #[test]
    fn sheets_have_their_pages_and_exercises() {
        let [summary, part_two, readme] =
            ["book/src/SUMMARY.md", "book/src/part-two.md", "README.md"]
                .map(|path| files::read(path).unwrap());
        for sheet in read_all().unwrap() {
            let Sheet {
                title,
                page,
                stage,
                hours,
                steps,
                ..
            } = sheet;
            assert!(summary.contains(&format!("({page})")), "{page}");
            assert!(
                files::shortest(&format!("book/src/{page}")).exists(),
                "{page}"
            );
            for step in steps {
                let step = exercise::find(&step).unwrap();
                assert!(step.stage <= &*stage, "{}", step.name);
            }
            // Tables name the stage that opens it, and the hours.
            let number = stage[..3].trim_start_matches("a0");
            let row = format!("[{title}]({page}): ");
            let row = part_two.lines().find(|line| line.contains(&row)).unwrap();
            assert!(row.ends_with(&format!(" | {number} | {hours} |")), "{row}");
            let row = format!("| [`{stage}`]");
            let row = readme.lines().find(|line| line.starts_with(&row)).unwrap();
            assert!(row.contains(&format!("(book/src/{page})")), "{row}");
        }
    }
}
