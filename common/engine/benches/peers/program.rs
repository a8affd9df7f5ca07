//! Programs run as child processes, by turns, and their times, memory and pictures.

use std::path::PathBuf;
use std::process::Command;
use std::{fs, io};

use common::{Error, Image, Settings, Size, picture_file};
use scene_file::{POV_RAY, Phrases, export};

use crate::support::scene::Scene;

/// A program that renders.
pub struct Program {
    pub name: &'static str,
    /// Its language; none for this benchmark itself.
    language: Option<Phrases>,
    /// The command with words in brackets.
    command: &'static str,
    /// The words before the seconds to build and to trace, and before the peak of memory.
    labels: [&'static str; 3],
}

/// Ours is the first. POV-Ray writes 8 bits a channel, linear, and takes one sample in each
/// pixel; of three highlights of Tachyon one is Phong's own.
pub static PROGRAMS: [Program; 3] = [
    Program {
        name: "ours",
        language: None,
        command: "[ours] [scene] --render [file].png --size [width]x[height] --threads [threads]",
        labels: ["build:", "trace:", "memory:"],
    },
    Program {
        name: "POV-Ray",
        language: Some(POV_RAY),
        command: "povray +I[file].scene +O[file].png +W[width] +H[height] +WT[threads] \
                  +FN8 File_Gamma=1 -A -D -V",
        labels: ["Bounding Time:", "Trace Time:", "memory:"],
    },
    Program {
        name: "Tachyon",
        language: Some(Phrases(include_str!("tachyon.txt"), " ")),
        command: "tachyon [file].scene -o [file].png -numthreads [threads] \
                  -format PNG -fullshade -shade_phong +V",
        labels: ["Preprocessing Time:", "Ray Tracing Time:", "memory:"],
    },
];

/// The figures of a run.
pub const BUILD: usize = 0;
pub const TRACE: usize = 1;
pub const MEMORY: usize = 2;
pub const TOTAL: usize = 3;

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
    /// The least seconds to build the structures that rays are traced in, and to trace the
    /// picture, the least peak of memory in KiB, and the least seconds to build and trace; NaN
    /// where there are none.
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
        let Some(language) = self.program.language else {
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
        let words = [
            ("[ours]", std::env::current_exe()?.display().to_string()),
            ("[scene]", self.scene.name.to_owned()),
            ("[file]", self.name()),
            ("[width]", self.size.width().to_string()),
            ("[height]", self.size.height().to_string()),
            ("[threads]", self.threads.to_string()),
        ];
        let arguments = self.program.command.split_whitespace().map(|argument| {
            let replace = |text: String, (word, value): &(_, String)| text.replace(word, value);
            words.iter().fold(argument.to_owned(), replace)
        });
        let mut command = Command::new("time");
        command.args(["-f", "memory: %M KiB"]).args(arguments);
        let missing = |error| io::Error::other(format!("GNU time: {error}"));
        let output = command.current_dir(folder()).output().map_err(missing)?;
        let log = [output.stdout, output.stderr].concat();
        let log = String::from_utf8_lossy(&log);
        let [build, trace, memory] = self
            .program
            .labels
            .map(|label| number(&log, label).unwrap_or(f64::NAN));
        if trace.is_nan() {
            eprintln!("{} failed: {log}", self.program.name);
        }
        let now = [build, trace, memory, build + trace];
        self.best = std::array::from_fn(|i| self.best[i].min(now[i]));
        Ok(())
    }
}

/// Lets all runs that are possible take turns, round after round; only ours if we are alone.
pub fn by_turns(runs: &mut [Run], rounds: u32, alone: bool) -> io::Result<()> {
    let mut possible: Vec<_> = runs.iter_mut().collect();
    possible.retain(|run| {
        let written = run.write_scene();
        let lacks = |error| eprintln!("{}: {error}", run.name());
        (!alone || run.program.language.is_none()) && written.map_err(lacks).is_ok()
    });
    for _ in 0..rounds {
        possible.iter_mut().try_for_each(|run| run.render())?;
    }
    Ok(())
}

/// The last number in the last line with this label; none if there is none.
fn number(log: &str, label: &str) -> Option<f64> {
    let (_, after) = log.rsplit_once(label)?;
    let mut words = after.lines().next()?.rsplit([' ', '(']);
    words.find_map(|word| word.parse().ok())
}
