//! `show`: a scene in a window, or its PNG where there is none.

use super::grammar::Showing;
use super::render::{note_unheeded, render_to_file};
use super::target::Target;
use super::{complain, say};
use crate::{Error, Gallery, Image, NotShown, Scene, Stage, Viewer};

/// Shows the scene until its window is closed; without one, writes its picture
/// and says where.
pub fn show(
    stage: &Stage,
    scene: &Scene,
    viewer: Option<&dyn Viewer>,
    options: &Showing,
) -> Result<(), Error> {
    let overrides = &options.overrides;
    let settings = overrides.settings(scene)?;
    if !options.no_window {
        Image::check_size(settings.size)?;
    }
    note_unheeded(scene, overrides);
    if !options.no_window {
        let mut gallery = Gallery::new(stage, scene, overrides.clone());
        let shown = match viewer {
            Some(viewer) => viewer.show(&mut gallery),
            None => Err(NotShown::NoWindow(
                "this build has none; the feature `window` brings it".to_owned(),
            )),
        };
        match shown {
            Ok(()) => return Ok(()),
            Err(NotShown::Failed(error)) => return Err(error),
            Err(NotShown::NoWindow(reason)) => complain(&format!("no window: {reason}")),
        }
    }
    if scene.heeds.file && overrides.open.is_none() {
        complain("note: this is the picture of the program; --open FILE shows one of yours");
    }
    Target::Default.check(stage, scene)?;
    let (path, size) = render_to_file(stage, scene, &Target::Default, overrides)?;
    say(&format!("{}  {size}", path.display()));
    Ok(())
}
