//! `Watch`: says when the files of a scene have been saved.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant, SystemTime};

/// The files are looked at again after this time.
pub const PERIOD: Duration = Duration::from_millis(200);

/// Why nothing can be watched.
pub const NOT_WATCHED: &str = "--watch needs one scene file, which ends in .toml";

/// The files of a scene, and what was known of them at the last call.
pub struct Watch {
    files: Vec<Watched>,
    looked: Instant,
}

struct Watched {
    path: PathBuf,
    saved: Option<Saved>,
}

/// When a file was saved, and its length in bytes.
#[derive(PartialEq, Eq)]
struct Saved {
    time: SystemTime,
    length: u64,
}

impl Watch {
    /// Watches a file from now on, whether it is there or not.
    pub fn new(path: &Path) -> Self {
        let mut watch = Self {
            files: Vec::new(),
            looked: Instant::now(),
        };
        watch.add(path);
        watch
    }

    /// Watches one more file, unless it is watched already.
    pub fn add(&mut self, path: &Path) {
        if self.files.iter().all(|file| file.path != path) {
            self.files.push(Watched {
                path: path.to_owned(),
                saved: saved(path),
            });
        }
    }

    /// Whether one of the files has been saved since the last look at them, which this call repeats if
    /// [`PERIOD`] is over.
    pub fn has_changed(&mut self) -> bool {
        if self.looked.elapsed() < PERIOD {
            return false;
        }
        self.looked = Instant::now();
        let mut has_changed = false;
        for file in &mut self.files {
            let now = saved(&file.path);
            // Some editors delete a file for a moment while they save it.
            if now.is_some() && now != file.saved {
                file.saved = now;
                has_changed = true;
            }
        }
        has_changed
    }
}

fn saved(path: &Path) -> Option<Saved> {
    let metadata = fs::metadata(path).ok()?;
    Some(Saved {
        time: metadata.modified().ok()?,
        length: metadata.len(),
    })
}
