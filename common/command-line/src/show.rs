//! `show`: shows a scene in a window, or renders it into its PNG where there is none.

use std::slice;

use common::{Error, Stage};

use crate::gallery::Scenes;
use crate::grammar::Showing;
use crate::opened_file::OpenedFile;
use crate::print::warn;
use crate::render::render_to_files;
use crate::watch::NOT_WATCHED;
use crate::{Gallery, NotShown, Viewer};

/// Shows a scene until its window is closed: the one of this name or scene file, or else the first.
/// Without a window, renders its picture. With `--watch` the window waits for the correction of a
/// broken scene file.
pub fn show(
    stage: &Stage,
    name: Option<&str>,
    viewer: Option<Viewer>,
    showing: &Showing,
) -> Result<(), Error> {
    let name = name.unwrap_or_else(|| stage.scenes.first().map_or("", |scene| scene.name));
    if showing.watch && !OpenedFile::is_named(stage, name) {
        stage.scene(name)?;
        return Err(Error::Usage(NOT_WATCHED.to_owned()));
    }
    if !showing.no_window {
        match show_in_window(stage, name, viewer, showing) {
            Ok(()) => return Ok(()),
            Err(NotShown::Failed(error)) => return Err(error),
            Err(NotShown::NoWindow(reason)) => warn(&format!("no window: {reason}")),
        }
    }
    let scene = stage.scene(name)?;
    if showing.watch {
        warn("note: without a window --watch shows one picture; render --watch writes each");
    }
    if scene.uses.file && showing.options.open.is_none() {
        warn("note: this is the picture of the program; --open FILE shows one of yours");
    }
    render_to_files(
        stage,
        slice::from_ref(&scene),
        None,
        false,
        &showing.options,
    )
}

fn show_in_window(
    stage: &Stage,
    name: &str,
    viewer: Option<Viewer>,
    showing: &Showing,
) -> Result<(), NotShown> {
    let mut file = None;
    let mut number = 0;
    if OpenedFile::is_named(stage, name) {
        let opened = OpenedFile::open(stage, name.as_ref(), showing.watch);
        let is_waited_for = showing.watch && viewer.is_some();
        file = Some(if is_waited_for {
            opened
        } else {
            opened.check()?
        });
    } else {
        let scene = stage.scene(name)?;
        let mut scenes = stage.scenes.iter();
        number = scenes
            .position(|other| other.name == scene.name)
            .unwrap_or(0);
    }
    let Some(viewer) = viewer else {
        let reason = "this build has none; the feature `window` brings it";
        return Err(NotShown::NoWindow(reason.to_owned()));
    };
    let scenes = Scenes {
        stage,
        file,
        number,
    };
    viewer(&mut Gallery::new(scenes, &showing.options)?)
}

#[cfg(test)]
mod tests {
    use common::{Image, Scene};

    use super::*;
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
            options: Options::default(),
        };
        let failing: Viewer = |_| Err(Error::Stopped.into());
        let shown = show(&stage, None, Some(failing), &options);
        assert!(matches!(shown, Err(Error::Stopped)));
    }
}
