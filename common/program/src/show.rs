//! `show`: shows a scene in a window, or writes its PNG where there is none.

use std::{slice, thread};

use common::{Error, Scene, Stage, text};

use crate::grammar::Showing;
use crate::print::{print, warn};
use crate::render::{render, warn_unused};
use crate::target::Target;
use crate::watch::Watch;
use crate::{Gallery, NotShown, Viewer};

/// Shows the scene until its window is closed. Without a window, writes its picture
/// and prints the path.
pub fn show(
    stage: &Stage,
    scene: &Scene,
    viewer: Option<Viewer>,
    showing: &Showing,
) -> Result<(), Error> {
    let options = &showing.options;
    let settings = options.settings(scene)?;
    let watch = showing
        .watch
        .then(|| Watch::new(slice::from_ref(scene)))
        .transpose()?;
    warn_unused(scene, options, &settings);
    if !showing.no_window {
        let shown = thread::scope(|scope| {
            let Some(viewer) = viewer else {
                let reason = "this build has none; the feature `window` brings it";
                return Err(NotShown::NoWindow(reason.to_owned()));
            };
            let mut gallery = Gallery::new(stage, scene.clone(), watch, showing, scope);
            // A viewer may choose another file first.
            if !scene.uses.file {
                gallery.start()?;
            }
            viewer(&mut gallery)
        });
        match shown {
            Ok(()) => return Ok(()),
            Err(NotShown::Failed(error)) => return Err(error),
            Err(NotShown::NoWindow(reason)) => warn(&format!("no window: {reason}")),
        }
    }
    if showing.watch {
        warn("note: without a window --watch shows one picture; render --watch writes each");
    }
    if scene.uses.file && options.open.is_none() {
        warn("note: this is the picture of the program; --open FILE shows one of yours");
    }
    let target = Target::default();
    target.check(stage, scene)?;
    let image = render(scene, &settings, options)?;
    let path = target.write(stage, scene, &image, options.transfer)?;
    print(&format!(
        "{}  {}",
        text::visible(&path.to_string_lossy()),
        image.size()
    ))
}

#[cfg(test)]
mod tests {
    use common::Image;

    use super::*;
    use crate::appearance::Appearance;
    use crate::options::Options;

    #[test]
    fn an_error_of_the_window_is_returned() {
        let scene = Scene::painted("one", "", |settings, _| Image::black(settings.size));
        let stage = Stage {
            name: "a00",
            about: "",
            scenes: vec![scene],
            open: None,
        };
        let options = Showing {
            no_window: false,
            watch: false,
            appearance: Appearance::default(),
            options: Options::default(),
        };
        let failing: Viewer = |_| Err(Error::Stopped.into());
        let shown = show(&stage, &stage.scenes[0], Some(failing), &options);
        assert!(matches!(shown, Err(Error::Stopped)));
    }
}
