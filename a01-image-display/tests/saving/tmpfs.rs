//! A small disk in memory. Only the superuser of Linux can make one.

use std::path::Path;
use std::process::Command;

/// A mounted disk, until it is dropped.
pub struct Tmpfs<'a>(&'a Path);

impl<'a> Tmpfs<'a> {
    /// Mounts a disk with these options, for example `size=4k`, on a folder.
    pub fn mount(folder: &'a Path, options: &str) -> Result<Self, String> {
        mount(folder, options)?;
        Ok(Self(folder))
    }

    /// Mounts it again with other options.
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
