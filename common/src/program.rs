//! The program of every stage: its command line.

use std::ffi::OsString;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Instant;

use clap::{Args, CommandFactory, FromArgMatches, Parser, Subcommand};

use crate::experiment::Experiment;
use crate::overrides::Overrides;
use crate::report::Measured;
use crate::{
    Effort, Error, Gallery, Image, NotShown, Scene, Stage, TerminalProgress, Viewer, extremes,
    picture_file, scene_report,
};

/// The folder that pictures land in, below the current one.
const DEFAULT_FOLDER: &str = "out";

#[derive(Parser)]
#[command(disable_help_subcommand = true, args_conflicts_with_subcommands = true)]
struct CommandLine {
    #[command(subcommand)]
    command: Option<Command>,

    #[command(flatten)]
    options: Showing,
}

/// How a scene is shown.
#[derive(Args)]
struct Showing {
    /// Open no window; write the PNG as if there were no display
    #[arg(long)]
    no_window: bool,

    #[command(flatten)]
    overrides: Overrides,
}

#[derive(Subcommand)]
enum Command {
    /// List the scenes, one a line
    List,
    /// Show a scene in a window; without a display, write its PNG
    Show {
        /// The scene, as `list` names it
        scene: String,
        #[command(flatten)]
        options: Showing,
    },
    /// Write scenes as PNG
    Render {
        /// The scenes, as `list` names them
        #[arg(required_unless_present = "all", conflicts_with = "all")]
        scenes: Vec<String>,

        /// Render all scenes of the stage
        #[arg(long)]
        all: bool,

        /// Where to: a PNG file for one scene, or a folder [default: out/]
        #[arg(short, long, value_name = "FILE|DIR")]
        output: Option<PathBuf>,

        #[command(flatten)]
        overrides: Overrides,
    },
    /// Report error against run time: a table, CSV and plots
    Report {
        /// Experiments; or `scene` and scenes, to see what their samples are worth [default: all experiments]
        names: Vec<String>,

        /// Measure less, in seconds
        #[arg(long)]
        quick: bool,

        /// The folder for CSV and plots [default: out/report/]
        #[arg(short, long, value_name = "DIR")]
        output: Option<PathBuf>,
    },
    /// Show the stiff and extreme cases; exit code 1 if one fails
    Extremes {
        /// Beginnings of ids, such as A or A01 [default: all]
        names: Vec<String>,
    },
}

/// Runs the program of `stage` with the arguments of this process.
///
/// Whatever goes wrong ends in one sentence on stderr and an exit code: 2 for
/// a wrong command line, 1 for the rest.
#[must_use]
pub fn run(stage: &Stage, viewer: Option<&dyn Viewer>) -> ExitCode {
    run_with(stage, viewer, std::env::args_os())
}

fn run_with(
    stage: &Stage,
    viewer: Option<&dyn Viewer>,
    arguments: impl IntoIterator<Item = OsString>,
) -> ExitCode {
    let grammar = CommandLine::command().name(stage.name).about(stage.about);
    let parsed = grammar
        .try_get_matches_from(arguments)
        .and_then(|matches| CommandLine::from_arg_matches(&matches));
    let outcome = match parsed {
        Ok(line) => execute(stage, viewer, line),
        Err(help_or_error) => {
            // A closed pipe is no reason to complain.
            let _ = help_or_error.print();
            return ExitCode::from(u8::from(help_or_error.use_stderr()) * 2);
        }
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            complain(&format!("error: {error}"));
            ExitCode::from(error.exit_code())
        }
    }
}

fn execute(stage: &Stage, viewer: Option<&dyn Viewer>, line: CommandLine) -> Result<(), Error> {
    match line.command {
        None => show(stage, &stage.scenes[0], viewer, line.options),
        Some(Command::Show { scene, options }) => {
            show(stage, stage.scene(&scene)?, viewer, options)
        }
        Some(Command::List) => {
            list(stage);
            Ok(())
        }
        Some(Command::Report {
            names,
            quick,
            output,
        }) => report(stage, &names, quick, output),
        Some(Command::Extremes { names }) => extremes(stage, &names),
        Some(Command::Render {
            scenes,
            all,
            output,
            overrides,
        }) => {
            let scenes: Vec<&Scene> = if all {
                stage.scenes.iter().collect()
            } else {
                let known = scenes.iter().map(|name| stage.scene(name));
                known.collect::<Result<_, _>>()?
            };
            // Whatever can be refused is, before the first picture is begun.
            let target = Target::new(output, scenes.len())?;
            for scene in &scenes {
                overrides.settings(scene)?;
                target.check(stage, scene)?;
            }
            for scene in scenes {
                note_unheeded(scene, &overrides);
                let start = Instant::now();
                let image = render(scene, &overrides)?;
                let path = target.write(stage, scene, &image, &overrides)?;
                let (size, time) = (image.size(), start.elapsed().as_secs_f64());
                say(&format!("{}  {size}  {time:.2} s", path.display()));
            }
            Ok(())
        }
    }
}

fn list(stage: &Stage) {
    let names = stage.scenes.iter().map(|scene| scene.name.len());
    let width = names.max().unwrap_or(0);
    for scene in &stage.scenes {
        say(&format!("{:width$}  {}", scene.name, scene.about));
    }
}

/// Prints a line; a reader that has closed the pipe has seen enough.
fn say(line: &str) {
    let _ = writeln!(io::stdout(), "{line}");
}

/// Prints a line on stderr, where nobody may listen either.
fn complain(line: &str) {
    let _ = writeln!(io::stderr(), "{line}");
}

fn render(scene: &Scene, overrides: &Overrides) -> Result<Image, Error> {
    let settings = overrides.settings(scene)?;
    let progress = TerminalProgress::new(scene.name, settings.size);
    let threads = overrides.thread_pool()?;
    threads.install(|| scene.render(&settings, &progress))
}

fn note_unheeded(scene: &Scene, overrides: &Overrides) {
    for flag in overrides.unheeded(scene.heeds) {
        complain(&format!("note: {flag} changes nothing in {}", scene.name));
    }
}

fn show(
    stage: &Stage,
    scene: &Scene,
    viewer: Option<&dyn Viewer>,
    options: Showing,
) -> Result<(), Error> {
    let Showing {
        no_window,
        overrides,
    } = options;
    overrides.settings(scene)?;
    note_unheeded(scene, &overrides);
    let mut gallery = Gallery::new(stage, scene, overrides.clone());
    let shown = match viewer {
        _ if no_window => Ok(()),
        Some(viewer) => viewer.show(&mut gallery),
        None => Err(NotShown::NoWindow(
            "this build has none; the feature `window` brings it".to_owned(),
        )),
    };
    match shown {
        Ok(()) if !no_window => return Ok(()),
        Ok(()) => {}
        Err(NotShown::Failed(error)) => return Err(error),
        Err(NotShown::NoWindow(reason)) => complain(&format!("no window: {reason}")),
    }
    if scene.heeds.file && overrides.open.is_none() {
        complain("note: this is the picture of the program; --open FILE shows one of yours");
    }
    Target::Default.check(stage, scene)?;
    let image = render(scene, &overrides)?;
    let path = Target::Default.write(stage, scene, &image, &overrides)?;
    say(&format!("{}  {}", path.display(), image.size()));
    Ok(())
}

fn report(
    stage: &Stage,
    names: &[String],
    quick: bool,
    output: Option<PathBuf>,
) -> Result<(), Error> {
    let effort = if quick { Effort::Quick } else { Effort::Full };
    match names.split_first() {
        Some((first, scenes)) if first == "scene" => {
            if scenes.is_empty() {
                let all: Vec<_> = stage.scenes.iter().map(|scene| scene.name).collect();
                let all = all.join(", ");
                return Err(Error::Usage(format!("report scene takes a scene: {all}")));
            }
            let scenes = scenes.iter().map(|name| stage.scene(name));
            let experiments = scenes.map(|scene| scene_report::experiment(scene?));
            measure(
                stage,
                &experiments.collect::<Result<Vec<_>, _>>()?,
                effort,
                output,
            )
        }
        _ => measure(
            stage,
            &chosen((stage.experiments)(), names)?,
            effort,
            output,
        ),
    }
}

fn measure(
    stage: &Stage,
    experiments: &[Experiment],
    effort: Effort,
    output: Option<PathBuf>,
) -> Result<(), Error> {
    let folder = match output {
        Some(folder) => folder,
        None => make_default_folder()?.join("report"),
    };
    std::fs::create_dir_all(&folder).map_err(|error| Error::Write {
        path: folder.clone(),
        reason: error.to_string(),
    })?;
    for experiment in experiments {
        let measured = Measured::new(experiment, effort);
        say(&measured.table());
        for path in measured.write(&folder, stage.name)? {
            say(&format!("  {}", path.display()));
        }
    }
    Ok(())
}

/// The experiments of these names; all without a name.
fn chosen(
    experiments: Vec<Experiment<'static>>,
    names: &[String],
) -> Result<Vec<Experiment<'static>>, Error> {
    let known: Vec<_> = experiments.iter().map(|e| e.name).collect();
    for name in names {
        if !known.contains(&name.as_str()) {
            let known = known.join(", ");
            return Err(Error::Usage(format!(
                "there is no experiment \"{name}\"; there are {known}, and scene NAME"
            )));
        }
    }
    let is_wanted = |e: &Experiment| names.is_empty() || names.iter().any(|name| name == e.name);
    Ok(experiments.into_iter().filter(is_wanted).collect())
}

fn extremes(stage: &Stage, names: &[String]) -> Result<(), Error> {
    let cases = extremes::select((stage.extremes)(Effort::of_build()), names)?;
    for case in &cases {
        say(&case.to_string());
    }
    let failed = cases.iter().filter(|case| !case.holds()).count();
    say(&format!("{} cases, {failed} of them failed", cases.len()));
    if failed > 0 {
        return Err(Error::Extremes(failed));
    }
    Ok(())
}

/// Where pictures go.
enum Target {
    /// `out/`, made where it is missing.
    Default,
    Folder(PathBuf),
    File(PathBuf),
}

impl Target {
    /// Reads the argument of `-o`, for this many pictures.
    fn new(output: Option<PathBuf>, pictures: usize) -> Result<Self, Error> {
        let Some(path) = output else {
            return Ok(Self::Default);
        };
        let is_png = |end: &std::ffi::OsStr| end.eq_ignore_ascii_case("png");
        if path.is_dir() {
            Ok(Self::Folder(path))
        } else if !path.extension().is_some_and(is_png) {
            Err(Error::Usage(format!(
                "-o {} must be a folder that exists or the name of a PNG file, ending in .png",
                path.display()
            )))
        } else if pictures > 1 {
            Err(Error::Usage(format!(
                "-o {} has room for one picture, not {pictures}; give a folder",
                path.display()
            )))
        } else {
            Ok(Self::File(path))
        }
    }

    fn path(&self, stage: &Stage, scene: &Scene) -> PathBuf {
        let name = picture_name(stage, scene);
        match self {
            Self::Default => Path::new(DEFAULT_FOLDER).join(name),
            Self::Folder(folder) => folder.join(name),
            Self::File(path) => path.clone(),
        }
    }

    /// Says what would keep the picture of `scene` from being written.
    fn check(&self, stage: &Stage, scene: &Scene) -> Result<(), Error> {
        let folder = Path::new(DEFAULT_FOLDER);
        match self {
            // The folder can be made where a file can.
            Self::Default if !folder.exists() => picture_file::check_writable(folder),
            _ => picture_file::check_writable(&self.path(stage, scene)),
        }
    }

    fn write(
        &self,
        stage: &Stage,
        scene: &Scene,
        image: &Image,
        overrides: &Overrides,
    ) -> Result<PathBuf, Error> {
        self.check(stage, scene)?;
        let path = self.path(stage, scene);
        if matches!(self, Self::Default) {
            make_default_folder()?;
        }
        picture_file::save_png(&path, image.size(), &image.to_rgb8(overrides.transfer))?;
        Ok(path)
    }
}

/// Makes `out/` where it is missing.
pub(crate) fn make_default_folder() -> Result<&'static Path, Error> {
    let folder = Path::new(DEFAULT_FOLDER);
    std::fs::create_dir_all(folder).map_err(|error| Error::Write {
        path: folder.to_owned(),
        reason: error.to_string(),
    })?;
    Ok(folder)
}

/// The file name of a scene's picture, `STAGE-SCENE.png`.
#[must_use]
pub fn picture_name(stage: &Stage, scene: &Scene) -> String {
    format!("{}-{}.png", stage.name, scene.name)
}
