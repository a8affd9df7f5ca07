//! `show`: shows a scene in a window, or writes its PNG where there is none.

use std::thread;

use common::{Error, Stage, text};

use crate::grammar::Showing;
use crate::opened_file::OpenedFile;
use crate::print::{print, warn};
use crate::render::{render, warn_unused};
use crate::target::Target;
use crate::watch::NOT_WATCHED;
use crate::{Gallery, NotShown, Viewer};

/// Shows a scene until its window is closed: the one of this name or scene file, or else the first.
/// Without a window, writes its picture and prints the path. With `--watch` the window waits for the
/// correction of a broken scene file.
pub fn show(
    stage: &Stage,
    name: Option<&str>,
    viewer: Option<Viewer>,
    showing: &Showing,
) -> Result<(), Error> {
    let options = &showing.options;
    let name = name.unwrap_or_else(|| stage.scenes.first().map_or("", |scene| scene.name));
    let is_file = OpenedFile::is_named(stage, name);
    if showing.watch && !is_file {
        stage.scene(name)?;
        return Err(Error::Usage(NOT_WATCHED.to_owned()));
    }
    let mut files = Vec::new();
    let mut number = 0;
    if is_file {
        let file = OpenedFile::open(stage, name.as_ref(), showing.watch);
        let is_waited_for = showing.watch && !showing.no_window && viewer.is_some();
        if file.error().is_some() && !is_waited_for {
            return file.into_scene().map(|_| ());
        }
        if let Some(error) = file.error() {
            warn(&format!("error: {error}"));
            warn("note: --watch waits until the file is corrected");
        } else if let Some(scene) = file.scene() {
            warn_unused(scene, options, &options.settings(scene)?);
        }
        files.push(file);
    } else {
        let scene = stage.scene(name)?;
        warn_unused(&scene, options, &options.settings(&scene)?);
        let mut scenes = stage.scenes.iter();
        number = scenes.position(|scene| scene.name == name).unwrap_or(0);
    }
    if !showing.no_window {
        let shown = thread::scope(|scope| {
            let Some(viewer) = viewer else {
                let reason = "this build has none; the feature `window` brings it";
                return Err(NotShown::NoWindow(reason.to_owned()));
            };
            let mut gallery = Gallery::new(stage, files, number, showing, scope);
            // A viewer may choose another file first.
            if !gallery.uses().file {
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
    let scene = stage.scene(name)?;
    let settings = options.settings(&scene)?;
    if showing.watch {
        warn("note: without a window --watch shows one picture; render --watch writes each");
    }
    if scene.uses.file && options.open.is_none() {
        warn("note: this is the picture of the program; --open FILE shows one of yours");
    }
    let target = Target::default();
    target.check(stage, &scene)?;
    let image = render(&scene, &settings, options)?;
    let path = target.write(stage, &scene, &image, options.transfer)?;
    print(&format!(
        "{}  {}",
        text::visible(&path.to_string_lossy()),
        image.size()
    ))
}

#[cfg(test)]
mod tests {
    use common::{Image, Scene};

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
        let shown = show(&stage, None, Some(failing), &options);
        assert!(matches!(shown, Err(Error::Stopped)));
    }
}
