//! The program of every stage: its command line.

use std::ffi::OsString;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Instant;

use clap::{CommandFactory, FromArgMatches, Parser, Subcommand};

use crate::overrides::Overrides;
use crate::{Error, Image, Scene, Stage, TerminalProgress, Viewer, picture_file};

/// The folder that pictures land in, below the current one.
const DEFAULT_FOLDER: &str = "out";

#[derive(Parser)]
#[command(disable_help_subcommand = true, args_conflicts_with_subcommands = true)]
struct CommandLine {
    #[command(subcommand)]
    command: Option<Command>,

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
        overrides: Overrides,
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
        None => show(stage, &stage.scenes[0], viewer, &line.overrides),
        Some(Command::Show { scene, overrides }) => {
            show(stage, stage.scene(&scene)?, viewer, &overrides)
        }
        Some(Command::List) => {
            list(stage);
            Ok(())
        }
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
    for flag in overrides.unheeded(scene.heeds) {
        complain(&format!("note: {flag} changes nothing in {}", scene.name));
    }
    let threads = rayon::ThreadPoolBuilder::new()
        .num_threads(overrides.threads())
        .build()?;
    let progress = TerminalProgress::new(scene.name, settings.size);
    threads.install(|| scene.render(&settings, &progress))
}

fn show(
    stage: &Stage,
    scene: &Scene,
    viewer: Option<&dyn Viewer>,
    overrides: &Overrides,
) -> Result<(), Error> {
    if viewer.is_none() {
        Target::Default.check(stage, scene)?;
    }
    let image = render(scene, overrides)?;
    let title = format!("{}: {}", stage.name, scene.name);
    let shown = match viewer {
        Some(viewer) => viewer
            .show(&title, image.size(), &packed(&image, overrides))
            .map_err(|no_window| no_window.to_string()),
        None => Err("this build has none; the feature `window` brings it".to_owned()),
    };
    if let Err(reason) = shown {
        complain(&format!("no window: {reason}"));
        let path = Target::Default.write(stage, scene, &image, overrides)?;
        say(&format!("{}  {}", path.display(), image.size()));
    }
    Ok(())
}

fn packed(image: &Image, overrides: &Overrides) -> Vec<u32> {
    let rgb = image.to_rgb8(overrides.transfer);
    let pack = |rgb: &[u8]| u32::from_be_bytes([0, rgb[0], rgb[1], rgb[2]]);
    rgb.chunks_exact(3).map(pack).collect()
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
            // What already exists is no error, and `check` has seen the rest.
            let _ = std::fs::create_dir(DEFAULT_FOLDER);
        }
        picture_file::save_png(&path, image.size(), &image.to_rgb8(overrides.transfer))?;
        Ok(path)
    }
}

/// The file name of a scene's picture, `STAGE-SCENE.png`.
#[must_use]
pub fn picture_name(stage: &Stage, scene: &Scene) -> String {
    format!("{}-{}.png", stage.name, scene.name)
}
