//! The program of every stage.

use std::ffi::OsString;
use std::path::Path;
use std::process::ExitCode;

use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{CommandFactory, FromArgMatches};
use common::{Error, Scene, Stage, text};

use crate::Viewer;
use crate::grammar::{Command, CommandLine};
use crate::print::{ignore_broken_pipe, print, warn};
use crate::target::is_same_file;
use crate::{render, show};

/// Runs the program of `stage` with the arguments of this process.
///
/// Every error ends in one sentence on stderr and an exit code: 2 for a wrong
/// command line, 1 for all others.
#[must_use]
pub fn run(stage: &Stage, viewer: Option<Viewer>) -> ExitCode {
    run_with(stage, viewer, std::env::args_os())
}

/// Like [`run`], with the given arguments, the first of which is the program's name.
#[must_use]
pub fn run_with(
    stage: &Stage,
    viewer: Option<Viewer>,
    arguments: impl IntoIterator<Item = OsString>,
) -> ExitCode {
    let words = arguments.into_iter().collect::<Vec<_>>();
    if let Some(problem) = words.iter().find_map(one_hyphen) {
        return exit_code(Err(Error::Usage(problem)));
    }
    let outcome = match parse(stage, words) {
        Ok(line) => execute(stage, viewer, line),
        Err(mut help_or_error) => {
            if let Some(tip) = tip(stage, &help_or_error) {
                let tip = ContextValue::StyledStrs(vec![tip.into()]);
                help_or_error.insert(ContextKind::Suggested, tip);
            }
            return print_clap_error(help_or_error);
        }
    };
    exit_code(outcome)
}

/// What is wrong with a word that is a flag but for its hyphens: one, which clap reads as a flag of one letter, or a
/// dash of a text processor.
fn one_hyphen(word: &OsString) -> Option<String> {
    let word = word.to_str()?;
    let flag = word.strip_prefix(['-', '–', '—'])?;
    if flag.starts_with('-') {
        return None;
    }
    let (name, _) = flag.split_once('=').unwrap_or((flag, ""));
    let is_flag = |command: &clap::Command| {
        let mut flags = command.get_arguments();
        flags.any(|argument| argument.get_long() == Some(name))
    };
    let is_flag = CommandLine::command().get_subcommands().any(is_flag);
    is_flag.then(|| format!("{word} is no flag: two hyphens begin it, as in --{name}"))
}

/// Reads a command line. A scene instead of a command is shown.
fn parse(stage: &Stage, mut words: Vec<OsString>) -> Result<CommandLine, clap::Error> {
    let parse = |words: &[OsString]| {
        let matches = CommandLine::of(stage).try_get_matches_from(words)?;
        CommandLine::from_arg_matches(&matches)
    };
    parse(&words).or_else(|error| {
        let wrong = word(&error, ContextKind::InvalidSubcommand);
        let is_help = words.get(1).is_some_and(|first| first == "help");
        if is_help || !wrong.is_some_and(|word| names_scene(stage, word)) {
            return Err(error);
        }
        words.insert(1, "show".into());
        parse(&words)
    })
}

/// The word that is wrong in this way.
fn word(error: &clap::Error, kind: ContextKind) -> Option<&str> {
    match error.get(kind) {
        Some(ContextValue::String(word)) => Some(word),
        _ => None,
    }
}

/// Whether a word is meant as a scene: it has the name of one, or of a file.
fn names_scene(stage: &Stage, word: &str) -> bool {
    let is_file =
        Path::new(word).extension().is_some() || Path::new(&format!("{word}.toml")).exists();
    is_file || stage.scenes.iter().any(|scene| scene.name == word)
}

/// What is right instead of a mistake in a command line, if it is about scenes.
fn tip(stage: &Stage, error: &clap::Error) -> Option<String> {
    let lacks_scene = match error.get(ContextKind::InvalidArg) {
        Some(ContextValue::Strings(needed)) => needed.iter().any(|word| word.starts_with("<SCENE")),
        _ => false,
    };
    let is_no_command = error.kind() == ErrorKind::InvalidSubcommand
        && error.get(ContextKind::SuggestedSubcommand).is_none();
    if lacks_scene || is_no_command {
        let names: Vec<_> = stage.scenes.iter().map(|scene| scene.name).collect();
        let scenes = format!("the scenes are {}", names.join(", "));
        if lacks_scene {
            return Some(scenes);
        }
        let line = CommandLine::command();
        let commands: Vec<_> = line
            .get_subcommands()
            .map(clap::Command::get_name)
            .collect();
        return Some(format!(
            "{scenes}; the commands are {}",
            commands.join(", ")
        ));
    }
    let takes_one = match error.get(ContextKind::Usage) {
        Some(ContextValue::StyledStr(usage)) => usage.to_string().ends_with(" <SCENE>"),
        _ => false,
    };
    let more = word(error, ContextKind::InvalidArg)?;
    if CommandLine::command().find_subcommand(more).is_some() {
        return Some(format!(
            "the command `{more}` stands before the other words"
        ));
    }
    (takes_one && names_scene(stage, more))
        .then(|| "this command takes one scene; `render` takes several".to_owned())
}

/// Prints the help, or the mistake in a command line, and returns the exit code.
#[must_use]
pub fn print_clap_error(mut help_or_error: clap::Error) -> ExitCode {
    if help_or_error.kind() == ErrorKind::InvalidUtf8 {
        let problem = "a name has a letter that is not in UTF-8; give its file another name";
        return exit_code(Err(Error::Usage(problem.to_owned())));
    }
    // No scene begins with a hyphen, and clap takes words for similar that have little in common.
    if let Some(ContextValue::StyledStrs(tips)) = help_or_error.remove(ContextKind::Suggested) {
        let tips = tips
            .into_iter()
            .filter(|tip| !tip.to_string().contains(" as a value, "))
            .collect();
        help_or_error.insert(ContextKind::Suggested, ContextValue::StyledStrs(tips));
    }
    let [wrong, similar] = [ContextKind::InvalidArg, ContextKind::SuggestedArg]
        .map(|kind| word(&help_or_error, kind).map(|flag| flag.trim_start_matches('-')));
    if let (Some(wrong), Some(similar)) = (wrong, similar)
        && text::nearest(&[similar], wrong).is_none()
    {
        help_or_error.remove(ContextKind::SuggestedArg);
    }
    if !help_or_error.use_stderr() {
        return exit_code(ignore_broken_pipe(help_or_error.print()).map(|()| ExitCode::SUCCESS));
    }
    // The words of the command line stand in the error: a terminal must not obey them.
    let mut words = help_or_error.context().map(|(_, word)| word.to_string());
    if words.all(|word| text::message(&word) == word) {
        let _ = help_or_error.print();
    } else {
        warn(help_or_error.render().to_string().trim_end());
    }
    ExitCode::from(2)
}

/// The exit code of a program, whose error is printed.
#[must_use]
pub fn exit_code(outcome: Result<ExitCode, Error>) -> ExitCode {
    outcome.unwrap_or_else(|error| {
        warn(&format!("error: {error}"));
        ExitCode::from(error.exit_code())
    })
}

fn execute(stage: &Stage, viewer: Option<Viewer>, line: CommandLine) -> Result<ExitCode, Error> {
    let done = match line.command {
        None => show::show(stage, None, viewer, &line.showing),
        Some(Command::List) => list(stage),
        Some(Command::Show { scene, showing }) => show::show(stage, Some(&scene), viewer, &showing),
        Some(Command::Render {
            scenes,
            all,
            output,
            watch,
            work,
            options,
        }) => {
            let render = |scenes: &[Scene]| {
                render::render_to_files(stage, scenes, output.clone(), work, &options)
            };
            if watch {
                return render::watch(stage, &scenes, render).map(|()| ExitCode::SUCCESS);
            }
            let mut chosen = named(stage, &scenes)?;
            if all {
                chosen.extend_from_slice(&stage.scenes);
            }
            render(&chosen)
        }
        Some(Command::Laboratory(it)) => return crate::laboratory::execute(stage, it),
    };
    done.map(|()| ExitCode::SUCCESS)
}

/// The scenes of these names; one that is named twice counts once. An error if two have one picture file.
fn named(stage: &Stage, names: &[String]) -> Result<Vec<Scene>, Error> {
    let mut chosen: Vec<(&str, Scene)> = Vec::new();
    for name in names {
        let scene = stage.scene(name)?;
        let Some((other, _)) = chosen.iter().find(|(_, other)| other.name == scene.name) else {
            chosen.push((name, scene));
            continue;
        };
        if *other != name && !is_same_file(other.as_ref(), name.as_ref()) {
            let [other, name] = [*other, name].map(text::name);
            return Err(Error::Usage(format!(
                "{other} and {name} would be written to one file; render each by itself, with -o"
            )));
        }
    }
    Ok(chosen.into_iter().map(|(_, scene)| scene).collect())
}

fn list(stage: &Stage) -> Result<(), Error> {
    let names = stage.scenes.iter().map(|scene| scene.name.len());
    let width = names.max().unwrap_or(0);
    let mut scenes = stage.scenes.iter();
    scenes.try_for_each(|scene| print(&format!("{:width$}  {}", scene.name, scene.about)))
}
