//! `render`: scenes into PNG files.

use std::path::PathBuf;
use std::time::Instant;

use super::explain::explain;
use super::target::Target;
use super::{complain, say};
use crate::overrides::Overrides;
use crate::{Error, Image, Scene, Stage, TerminalProgress};

/// Writes the pictures of these scenes, and says where and how long each took.
/// Whatever can be refused is, before the first picture is begun.
pub fn render_to_files(
    stage: &Stage,
    scenes: &[&Scene],
    output: Option<PathBuf>,
    explained: bool,
    overrides: &Overrides,
) -> Result<(), Error> {
    let target = Target::new(output, scenes.len())?;
    for scene in scenes {
        overrides.settings(scene)?;
        target.check(stage, scene)?;
    }
    for scene in scenes {
        note_unheeded(scene, overrides);
        let start = Instant::now();
        let image = if explained {
            explain(scene, overrides)?
        } else {
            render(scene, overrides)?
        };
        let path = target.write(stage, scene, &image, overrides.transfer)?;
        let (size, time) = (image.size(), start.elapsed().as_secs_f64());
        say(&format!("{}  {size}  {time:.2} s", path.display()));
    }
    Ok(())
}

/// Renders a scene with a bar on the terminal.
pub fn render(scene: &Scene, overrides: &Overrides) -> Result<Image, Error> {
    let settings = overrides.settings(scene)?;
    let progress = TerminalProgress::new(scene.name, settings.size);
    let threads = overrides.thread_pool()?;
    let image = threads.install(|| scene.render(&settings, &progress))?;
    drop(progress);
    let bad = image.count_non_finite();
    if bad > 0 {
        let name = scene.name;
        complain(&format!(
            "warning: {bad} pixels of {name} are no finite numbers"
        ));
    }
    Ok(image)
}

/// Tells of the flags that do not change this scene.
pub fn note_unheeded(scene: &Scene, overrides: &Overrides) {
    for flag in overrides.unheeded(scene.heeds) {
        complain(&format!("note: {flag} changes nothing in {}", scene.name));
    }
}
