//! `Watch`: says when the files of a scene have been saved.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant, SystemTime};

/// A file that is missing for this time is gone: an editor deletes one for a moment only, while it
/// saves.
const GONE: Duration = Duration::from_secs(1);

/// Why nothing can be watched.
pub const NOT_WATCHED: &str = "--watch needs one scene file, which ends in .toml";

/// The files of a scene, and what was known of them at the last call.
pub struct Watch(Vec<Watched>);

struct Watched {
    path: PathBuf,
    /// The time when the file was saved, and its size; none for a file that is gone.
    saved: Option<(SystemTime, u64)>,
    /// The time of the first call that did not find it.
    missing_since: Option<Instant>,
}

impl Watch {
    /// Watches a file from now on, whether it is there or not.
    pub fn new(path: &Path) -> Self {
        let mut watch = Self(Vec::new());
        watch.add(path);
        watch
    }

    /// Watches one more file, unless it is watched already.
    pub fn add(&mut self, path: &Path) {
        if self.0.iter().all(|file| file.path != path) {
            self.0.push(Watched {
                path: path.to_owned(),
                saved: saved(path),
                missing_since: None,
            });
        }
    }

    /// Whether one of the files has been saved or deleted since the last call.
    pub fn has_changed(&mut self) -> bool {
        self.has_changed_at(Instant::now())
    }

    fn has_changed_at(&mut self, time: Instant) -> bool {
        let mut has_changed = false;
        for file in &mut self.0 {
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

fn saved(path: &Path) -> Option<(SystemTime, u64)> {
    let metadata = fs::metadata(path).ok()?;
    Some((metadata.modified().ok()?, metadata.len()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_that_are_saved_come_or_go_have_changed() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("w.toml");
        let mut watch = Watch::new(&path);
        assert!(!watch.has_changed());
        fs::write(&path, "a").unwrap();
        assert_eq!([watch.has_changed(), watch.has_changed()], [true, false]);
        fs::write(&path, "ab").unwrap();
        assert_eq!([watch.has_changed(), watch.has_changed()], [true, false]);
        // For a moment the file is missing, and comes back as it was.
        let aside = folder.path().join("aside");
        fs::rename(&path, &aside).unwrap();
        assert!(!watch.has_changed());
        fs::rename(&aside, &path).unwrap();
        assert!(!watch.has_changed());
        fs::remove_file(&path).unwrap();
        let start = Instant::now();
        let changed = [0, 999, 1000, 5000]
            .map(|milliseconds| watch.has_changed_at(start + Duration::from_millis(milliseconds)));
        assert_eq!(changed, [false, false, true, false]);
    }
}
