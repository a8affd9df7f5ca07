//! `OwnProgram`: the student's program, which draws one picture after the other within limits.

use std::ffi::OsStr;
use std::path::{PathBuf, absolute};
use std::process::Stdio;
use std::time::{Duration, Instant, SystemTime};
use std::{env, fs, io};

use crate::files::with_path;
use crate::output::OutputReader;
use crate::phase::{Phase, Watcher};
use crate::process::{limited, run};
use judge::pictures::{Drawn, MARKED_EXTENSION, RequestedPicture, Run, last_words, no_picture};

/// The student's program.
pub struct OwnProgram {
    /// The file that runs, or a name that the system finds.
    pub executable: PathBuf,
    /// Its words before the scene.
    pub arguments: Vec<String>,
    /// Its folder, in which it runs.
    pub folder: PathBuf,
    /// Where its pictures are kept.
    pub pictures: PathBuf,
    /// Variables of its environment, by which tests choose what it draws.
    pub environment: Vec<(&'static str, String)>,
}

impl OwnProgram {
    /// Draws a picture. The error is a sentence about the program.
    pub fn draw(
        &self,
        picture: &RequestedPicture,
        of: &Run,
        watcher: Watcher,
    ) -> Result<Drawn, String> {
        let file = self.pictures.join(of.file());
        let whole = absolute(&file).map_err(with_path(&file))?;
        // Nothing of an earlier run shall look like this one's.
        for old in [&file, &file.with_extension(MARKED_EXTENSION)] {
            match fs::remove_file(old) {
                Err(error) if error.kind() != io::ErrorKind::NotFound => {
                    return Err(with_path(old)(error));
                }
                _ => {}
            }
        }
        let with_program = with_path(&self.executable);
        let mut program = limited(&self.executable);
        program.args(&self.arguments);
        program.args([&*of.scene, "--samples", &of.samples.to_string(), "-o"]);
        program.arg(whole).current_dir(&self.folder);
        let (output, to_output) = io::pipe().map_err(&with_program)?;
        program.env("RUST_BACKTRACE", "0");
        for (name, value) in &self.environment {
            program.env(name, value);
        }
        program.stdout(Stdio::null()).stderr(to_output);
        let output = OutputReader::start(output);

        let limit = env::var("LEARN_SECONDS").ok();
        let seconds = limit.and_then(|n| n.parse().ok());
        let seconds = seconds.unwrap_or(picture.seconds);
        let limit = Duration::from_secs(seconds.into());
        let (start, began) = (Instant::now(), SystemTime::now());
        let status = run(program, &mut || {
            let elapsed = start.elapsed();
            elapsed < limit && watcher(Phase::Drawing, elapsed)
        });
        let elapsed = start.elapsed().as_secs_f64();
        match status.map_err(with_program)? {
            Some(status) if status.success() => {}
            Some(_) => {
                let printed = output.finish().kept;
                return Err(last_words(&String::from_utf8_lossy(&printed)));
            }
            None => {
                return Err(format!(
                    "it takes longer than {seconds} seconds, the limit for this picture"
                ));
            }
        }
        if file.exists() {
            return Ok(Drawn {
                file,
                seconds: elapsed,
            });
        }
        Err(no_picture(self.picture_since(began).as_deref()))
    }

    /// A picture that the program has written into its own folder.
    fn picture_since(&self, began: SystemTime) -> Option<PathBuf> {
        let entries = fs::read_dir(&self.folder).ok()?;
        let mut paths = entries.flatten().map(|entry| entry.path());
        paths.find(|path| {
            let saved = fs::metadata(path).and_then(|file| file.modified());
            // Some file systems count whole seconds.
            let is_new = |saved| saved + Duration::from_secs(1) >= began;
            path.extension() == Some(OsStr::new("png")) && saved.is_ok_and(is_new)
        })
    }
}
