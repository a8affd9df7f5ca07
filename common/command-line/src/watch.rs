//! `Watch`: says when the files of a scene have been saved.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant, SystemTime};

use common::fnv1a;

/// A file that is missing for this time is gone: an editor deletes one for a moment only, while it
/// saves.
const GONE: Duration = Duration::from_secs(1);

/// The files are looked at again after this time.
pub const PERIOD: Duration = Duration::from_millis(200);

/// The content of a file of at most this size, in bytes, is compared, too: two saves of the same length may
/// have the same time. That of larger ones, which no person types, would take too long to read so often.
const MAX_COMPARED: u64 = 1 << 20;

/// Why nothing can be watched.
pub const NOT_WATCHED: &str = "--watch needs one scene file, which ends in .toml";

/// The files of a scene, and what was known of them at the last call.
pub struct Watch {
    files: Vec<Watched>,
    looked: Instant,
}

struct Watched {
    path: PathBuf,
    /// The file as it was saved; none for one that is gone.
    saved: Option<Saved>,
    /// The time of the first call that did not find it.
    missing_since: Option<Instant>,
}

#[derive(PartialEq, Eq)]
struct Saved {
    time: SystemTime,
    bytes: u64,
    /// The hash of the content; 0 for a large file.
    hash: u64,
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
                missing_since: None,
            });
        }
    }

    /// Whether one of the files has been saved or deleted since the last look at them, which this call
    /// repeats if [`PERIOD`] is over.
    pub fn has_changed(&mut self) -> bool {
        let now = Instant::now();
        if now - self.looked < PERIOD {
            return false;
        }
        self.looked = now;
        self.has_changed_at(now)
    }

    fn has_changed_at(&mut self, time: Instant) -> bool {
        let mut has_changed = false;
        for file in &mut self.files {
            let now = saved(&file.path);
            let is_gone = if now.is_none() {
                time - *file.missing_since.get_or_insert(time) >= GONE
            } else {
                file.missing_since = None;
                false
            };
            if now != file.saved && (now.is_some() || is_gone) {
                file.saved = now;
                has_changed = true;
            }
        }
        has_changed
    }
}

fn saved(path: &Path) -> Option<Saved> {
    let metadata = fs::metadata(path).ok()?;
    let bytes = metadata.len();
    let hash = if bytes <= MAX_COMPARED && metadata.is_file() {
        fnv1a(&fs::read(path).ok()?)
    } else {
        0
    };
    Some(Saved {
        time: metadata.modified().ok()?,
        bytes,
        hash,
    })
}

#[cfg(test)]
mod tests {
    use std::io::Write;

    use super::*;

    #[test]
    fn files_that_are_saved_come_or_go_have_changed() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("w.toml");
        let mut watch = Watch::new(&path);
        let start = Instant::now();
        let mut has_changed = |milliseconds| {
            let time = start + Duration::from_millis(milliseconds);
            watch.has_changed_at(time)
        };
        assert!(!has_changed(0));
        fs::write(&path, "a").unwrap();
        assert_eq!([has_changed(0), has_changed(0)], [true, false]);
        // The same length and the same time, as of two saves at once.
        let time = fs::metadata(&path).unwrap().modified().unwrap();
        let mut file = fs::File::create(&path).unwrap();
        file.write_all(b"b").unwrap();
        file.set_modified(time).unwrap();
        assert_eq!([has_changed(0), has_changed(0)], [true, false]);
        // For a moment the file is missing, and comes back as it was.
        let aside = folder.path().join("aside");
        fs::rename(&path, &aside).unwrap();
        assert!(!has_changed(0));
        fs::rename(&aside, &path).unwrap();
        assert!(!has_changed(0));
        fs::remove_file(&path).unwrap();
        let gone = [1, 1000, 1001, 5000].map(&mut has_changed);
        assert_eq!(gone, [false, false, true, false]);
    }
}
