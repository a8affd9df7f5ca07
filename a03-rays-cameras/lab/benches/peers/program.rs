//! `Program`: a renderer that runs as a child process, and its times, memory and picture.

use std::path::PathBuf;
use std::process::Command;
use std::{fs, io};

use common::{Error, Image, Settings, Size, picture_file};
use scene_export::{POV_RAY, Phrases, export};

use crate::support::scene::Scene;
use crate::written::{written, written_lights, written_materials};

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
pub const PROGRAMS: [Program; 3] = [
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

/// What a program prints about itself; NaN where it prints nothing.
#[derive(Clone, Copy)]
pub struct Figures {
    /// The seconds to build the structures that rays are traced in.
    pub build: f64,
    /// The seconds to trace the picture.
    pub trace: f64,
    /// The seconds to build and trace.
    pub total: f64,
    /// The peak of memory in KiB.
    pub memory: f64,
}

/// The figures of each of [`PROGRAMS`].
pub type OfPrograms = [Figures; PROGRAMS.len()];

impl Figures {
    pub const NONE: Self = Self {
        build: f64::NAN,
        trace: f64::NAN,
        total: f64::NAN,
        memory: f64::NAN,
    };

    /// The least of each figure.
    pub fn min(&self, other: &Self) -> Self {
        Self {
            build: self.build.min(other.build),
            trace: self.trace.min(other.trace),
            total: self.total.min(other.total),
            memory: self.memory.min(other.memory),
        }
    }
}

/// The folder of scenes and pictures.
pub fn folder() -> PathBuf {
    [env!("CARGO_TARGET_TMPDIR"), "peers"].iter().collect()
}

impl Program {
    /// The name of its files for a scene, without an ending.
    fn file(&self, scene: &Scene) -> String {
        format!("{}-{}", scene.name, self.name)
    }

    /// The picture that it rendered last.
    pub fn picture(&self, scene: &Scene) -> Result<Image, Error> {
        picture_file::open(&folder().join(self.file(scene) + ".png"))
    }

    /// Writes a scene in its language.
    pub fn write(&self, scene: &Scene, size: Size) -> io::Result<()> {
        let Some(language) = self.language else {
            return Ok(());
        };
        let settings = Settings {
            size,
            depth: scene.depth,
            ..Settings::default()
        };
        let (world, camera) = scene.world();
        let text = export(
            language,
            &world,
            &written(&world),
            &written_materials(&world),
            &written_lights(&world),
            &camera,
            &settings,
        );
        let text = text.map_err(io::Error::other)?;
        fs::write(folder().join(self.file(scene) + ".scene"), text)
    }

    /// Renders the scene that it has a file of.
    pub fn render(&self, scene: &Scene, size: Size, threads: u16) -> io::Result<Figures> {
        let words = [
            ("[ours]", std::env::current_exe()?.display().to_string()),
            ("[scene]", scene.name.to_owned()),
            ("[file]", self.file(scene)),
            ("[width]", size.width().to_string()),
            ("[height]", size.height().to_string()),
            ("[threads]", threads.to_string()),
        ];
        let mut command = Command::new("time");
        command.args(["-f", "memory: %M KiB"]);
        for argument in self.command.split_whitespace() {
            let mut argument = argument.to_owned();
            for (word, value) in &words {
                argument = argument.replace(word, value);
            }
            command.arg(argument);
        }
        let missing = |error| io::Error::other(format!("GNU time: {error}"));
        let output = command.current_dir(folder()).output().map_err(missing)?;
        let log = [output.stdout, output.stderr].concat();
        let log = String::from_utf8_lossy(&log);
        let [build, trace, memory] = self.labels.map(|label| number(&log, label));
        if trace.is_nan() {
            eprintln!("{} failed: {log}", self.name);
        }
        Ok(Figures {
            build,
            trace,
            total: build + trace,
            memory,
        })
    }
}

/// The last number in the last line with this label; NaN if there is none.
fn number(log: &str, label: &str) -> f64 {
    let Some((_, after)) = log.rsplit_once(label) else {
        return f64::NAN;
    };
    let line = after.lines().next().unwrap_or_default();
    for word in line.rsplit([' ', '(']) {
        if let Ok(number) = word.parse() {
            return number;
        }
    }
    f64::NAN
}
