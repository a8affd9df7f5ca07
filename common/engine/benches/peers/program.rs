//! Programs run as child processes, by turns, and their times, memory and pictures.

use std::fs;
use std::io;
use std::path::PathBuf;
use std::process::Command;

use common::{Error, Image, Settings, Size, picture_file};
use scene_file::{POV_RAY, Phrases, export};

use crate::support::scene::Scene;

/// A program that renders.
pub struct Program {
    pub name: &'static str,
    /// Its file and its language; none for this benchmark itself.
    other: Option<(&'static str, Phrases)>,
    /// The arguments, with words in brackets.
    arguments: &'static str,
    /// The words before the seconds to build and to trace in its output.
    labels: [&'static str; 2],
}

/// Ours is the first. POV-Ray writes 8 bits a channel, linear, and takes one sample in each
/// pixel; of three highlights of Tachyon one is Phong's own.
pub static PROGRAMS: [Program; 3] = [
    Program {
        name: "ours",
        other: None,
        arguments: "[scene] --render [file].png --size [width]x[height] --threads [threads]",
        labels: ["build:", "trace:"],
    },
    Program {
        name: "POV-Ray",
        other: Some(("povray", POV_RAY)),
        arguments: "+I[file].scene +O[file].png +W[width] +H[height] +WT[threads] \
                    +FN8 File_Gamma=1 -A -D -V",
        labels: ["Bounding Time:", "Trace Time:"],
    },
    Program {
        name: "Tachyon",
        other: Some(("tachyon", Phrases(include_str!("tachyon.txt"), " "))),
        arguments: "[file].scene -o [file].png -numthreads [threads] \
                    -format PNG -fullshade -shade_phong +V",
        labels: ["Preprocessing Time:", "Ray Tracing Time:"],
    },
];

/// The figures of a run.
pub const BUILD: usize = 0;
pub const TRACE: usize = 1;
pub const TOTAL: usize = 2;
pub const MEMORY: usize = 3;

/// The folder of scenes and pictures.
pub fn folder() -> PathBuf {
    [env!("CARGO_TARGET_TMPDIR"), "peers"].iter().collect()
}

/// A scene rendered by a program, several times.
pub struct Run {
    pub program: &'static Program,
    pub scene: &'static Scene,
    pub size: Size,
    pub threads: u16,
    /// The least seconds to build the structures that rays are traced in, to trace the picture
    /// and to do both, and the least peak of memory in bytes; NaN where there are none.
    pub best: [f64; 4],
}

impl Run {
    /// The name of its files, without an ending.
    fn name(&self) -> String {
        let (scene, program, threads) = (self.scene.name, self.program.name, self.threads);
        format!("{scene}-{program}-{threads}")
    }

    /// The picture that was rendered.
    pub fn picture(&self) -> Result<Image, Error> {
        picture_file::open(&folder().join(self.name() + ".png"))
    }

    fn write_scene(&self) -> io::Result<()> {
        let Some((_, language)) = self.program.other else {
            return Ok(());
        };
        let settings = Settings {
            size: self.size,
            depth: self.scene.depth,
            ..Settings::default()
        };
        let (world, camera) = self.scene.world();
        let text = export(language, &world, &camera, &settings).map_err(io::Error::other)?;
        fs::write(folder().join(self.name() + ".scene"), text)
    }

    fn render(&mut self) -> io::Result<()> {
        let file = match self.program.other {
            Some((file, _)) => file.into(),
            None => std::env::current_exe()?,
        };
        let numbers = [self.size.width(), self.size.height(), self.threads.into()];
        let [width, height, threads] = numbers.map(|number| number.to_string());
        let arguments = self.program.arguments.replace("[scene]", self.scene.name);
        let arguments = arguments.replace("[file]", &self.name());
        let arguments = arguments
            .replace("[width]", &width)
            .replace("[height]", &height);
        let arguments = arguments.replace("[threads]", &threads);
        let mut command = Command::new("time");
        command.args(["-f", "memory: %M KiB"]).arg(file);
        command.args(arguments.split_whitespace());
        let missing = |error| io::Error::other(format!("GNU time: {error}"));
        let output = command.current_dir(folder()).output().map_err(missing)?;
        let log = [output.stdout, output.stderr].concat();
        let log = String::from_utf8_lossy(&log);
        let [build, trace] = self
            .program
            .labels
            .map(|label| number(&log, label, "seconds"));
        if trace.is_nan() {
            eprintln!("{} failed: {log}", self.program.name);
        }
        let memory = 1024.0 * number(&log, "memory:", "KiB");
        let now = [build, trace, build + trace, memory];
        self.best = std::array::from_fn(|i| self.best[i].min(now[i]));
        Ok(())
    }
}

/// Lets all runs that are possible take turns, round after round; only ours if we are alone.
pub fn by_turns(runs: &mut [Run], rounds: u32, alone: bool) -> io::Result<()> {
    let mut possible = Vec::new();
    let wanted = runs
        .iter_mut()
        .filter(|run| !alone || run.program.other.is_none());
    for run in wanted {
        match run.write_scene() {
            Ok(()) => possible.push(run),
            Err(error) => eprintln!("{}: {error}", run.name()),
        }
    }
    for _ in 0..rounds {
        possible.iter_mut().try_for_each(|run| run.render())?;
    }
    Ok(())
}

/// The number before the last unit in the line with this label; NaN if there is none.
fn number(log: &str, label: &str, unit: &str) -> f64 {
    let number = || {
        let (_, after) = log.rsplit_once(label)?;
        let (before, _) = after.lines().next()?.rsplit_once(unit)?;
        before.trim().rsplit([' ', '(']).next()?.parse().ok()
    };
    number().unwrap_or(f64::NAN)
}
