//! The manifest of the student's program: the workbook's stages, and a profile with which pictures take
//! seconds.

use std::fs;
use std::path::Path;

use common::text;

use super::write;
use crate::files::{self, with_path};

pub const MANIFEST: &str = "Cargo.toml";
pub const DEPENDENCIES: &str = "[dependencies]\n";

/// Added to a manifest without a profile: what draws is optimised; other libraries stay as they are
/// built.
const PROFILE: &str = "
[profile.dev]
opt-level = 3

[profile.dev.package.\"*\"]
opt-level = 0

[profile.dev.package.common]
opt-level = 3

[profile.dev.package.libm]
opt-level = 3
";

/// Adds to the manifest what it lacks: the build profile, `libm`, and these stages, which are optimised, too.
/// Returns whether it lacked something.
pub fn complete(folder: &Path, stages: &[&str]) -> Result<bool, String> {
    let path = folder.join(MANIFEST);
    let before = fs::read_to_string(&path).map_err(with_path(&path))?;
    if !before.contains(DEPENDENCIES) {
        return Err(format!("{} lacks a line [dependencies]", text::path(&path)));
    }
    let workspace = files::workspace();
    let Some(workbook) = workspace.to_str().filter(|path| !path.contains('"')) else {
        let workbook = text::path(&workspace);
        return Err(format!("{workbook} cannot be written into a manifest"));
    };
    // Windows takes this, too.
    let workbook = workbook.replace('\\', "/");
    let of_workbook = files::read(MANIFEST)?;
    let libm = of_workbook.lines().find(|line| line.starts_with("libm = "));
    let mut dependencies: Vec<_> = libm.map(str::to_owned).into_iter().collect();
    let mut manifest = before.clone();
    if !before.contains("[profile.") {
        manifest += PROFILE;
    }
    for stage in stages {
        let path = format!("{workbook}/{stage}");
        dependencies.push(format!(
            "{stage} = {{ path = \"{path}\", default-features = false }}"
        ));
        if !before.contains(stage) {
            let optimised = format!("\n[profile.dev.package.{stage}]\nopt-level = 3\n");
            manifest += &optimised;
        }
    }
    for line in dependencies {
        let (name, _) = line.split_once('=').unwrap_or_default();
        if !before.contains(&format!("\n{name}=")) {
            let with_line = format!("{DEPENDENCIES}{line}\n");
            manifest = manifest.replacen(DEPENDENCIES, &with_line, 1);
        }
    }
    if manifest == before {
        return Ok(false);
    }
    write(&path, &manifest)?;
    // The versions of libraries that the workbook is tested with, and has fetched.
    write(&folder.join("Cargo.lock"), &files::read("Cargo.lock")?)?;
    Ok(true)
}
