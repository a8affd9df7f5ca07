//! A small disk in memory. Only the superuser of Linux can make one.

use std::path::Path;
use std::process::Command;

/// A disk that is there as long as this.
pub struct Tmpfs<'a>(&'a Path);

impl<'a> Tmpfs<'a> {
    /// Puts a disk with these options, such as `size=4k`, over a folder.
    pub fn mount(folder: &'a Path, options: &str) -> Result<Self, String> {
        mount(folder, options)?;
        Ok(Self(folder))
    }

    /// Gives it other options.
    pub fn change(&self, options: &str) {
        mount(self.0, &format!("remount,{options}")).expect("other options");
    }
}

impl Drop for Tmpfs<'_> {
    fn drop(&mut self) {
        let _ = Command::new("umount").arg("-l").arg(self.0).output();
    }
}

fn mount(folder: &Path, options: &str) -> Result<(), String> {
    let output = Command::new("mount")
        .args(["-t", "tmpfs", "-o", options, "tmpfs"])
        .arg(folder)
        .output()
        .map_err(|error| error.to_string())?;
    if output.status.success() {
        Ok(())
    } else {
        Err(String::from_utf8_lossy(&output.stderr).into_owned())
    }
}
