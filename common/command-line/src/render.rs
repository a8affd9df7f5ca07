//! `render`: renders scenes into PNG files.

use std::path::PathBuf;
use std::slice;
use std::thread;
use std::time::{Duration, Instant};

use common::{Error, Image, Renderer, Scene, Settings, Stage, text};

use crate::black_picture::warn_if_black;
use crate::interruption::stoppable;
use crate::opened_file::OpenedFile;
use crate::options::Options;
use crate::print::{print, warn};
use crate::target::Target;
use crate::terminal_progress::TerminalProgress;
use crate::watch::{NOT_WATCHED, PERIOD};
use crate::work;

/// A picture that takes longer than this time is worth a remark on a faster renderer.
pub const SLOW: Duration = Duration::from_secs(4);

/// Writes the pictures of these scenes, and prints the path and the time of each; before, if it is
/// asked for, the work that the renderer leaves out. Wrong arguments are refused before the first
/// picture is begun.
pub fn render_to_files(
    stage: &Stage,
    scenes: &[Scene],
    output: Option<PathBuf>,
    explains_work: bool,
    options: &Options,
) -> Result<(), Error> {
    let target = Target::new(output, scenes.len())?;
    let mut jobs = Vec::new();
    for scene in scenes {
        jobs.push((scene, options.settings(scene)?));
        target.check(stage, scene, options)?;
    }
    for (scene, settings) in jobs {
        warn_unused(scene, options, &settings);
        if explains_work {
            work::explain(scene, &settings, options)?;
        }
        let start = Instant::now();
        let keep = |rgb: &_| target.keep_rows(stage, scene, settings.size, rgb);
        let image = render(scene, &settings, options, keep)?;
        let path = target.write(stage, scene, &image, options.transfer)?;
        let (size, time) = (image.size(), start.elapsed().as_secs_f64());
        let path = text::visible(&path.to_string_lossy());
        print(&format!("{path}  {size}  {time:.2} s"))?;
    }
    Ok(())
}

/// Renders a scene file, and renders it anew whenever it is saved. A broken file leaves the picture
/// as it is, and is waited for; wrong arguments are refused at once.
pub fn watch(
    stage: &Stage,
    names: &[String],
    render: impl Fn(&[Scene]) -> Result<(), Error>,
) -> Result<(), Error> {
    let mut file = match names {
        [name] if OpenedFile::is_named(stage, name) => OpenedFile::open(stage, name.as_ref(), true),
        _ => {
            for name in names {
                stage.scene(name)?;
            }
            return Err(Error::Usage(NOT_WATCHED.to_owned()));
        }
    };
    let render_file = |file: &OpenedFile| match (file.error(), file.scene()) {
        (None, Some(scene)) => render(slice::from_ref(scene)),
        (error, _) => {
            error.into_iter().for_each(warn_error);
            Ok(())
        }
    };
    render_file(&file)?;
    warn("note: each save of the file renders it anew; Ctrl+C ends this");
    loop {
        thread::sleep(PERIOD);
        if file.reread(stage) {
            match render_file(&file) {
                Err(Error::Stopped) => return Err(Error::Stopped),
                Err(error) => warn_error(&error),
                Ok(()) => {}
            }
        }
    }
}

fn warn_error(error: &Error) {
    warn(&format!("error: {error}"));
}

/// What the fast renderer does with a picture. Only where an error is allowed it may end reflections that the
/// lesson follows.
pub const fn sooner(settings: &Settings) -> &'static str {
    if settings.max_error.is_some() {
        "keeps the error, too, and is sooner"
    } else {
        "draws the same picture sooner"
    }
}

/// Renders a scene, with a bar on the terminal. Of a rendering that is stopped, the rows that are drawn are kept.
pub fn render(
    scene: &Scene,
    settings: &Settings,
    options: &Options,
    keep: impl FnOnce(&[u8]) -> Result<(), Error>,
) -> Result<Image, Error> {
    let progress = TerminalProgress::new(scene.name, settings);
    if scene.uses.sampling && settings.renderer == Renderer::Lesson && !scene.is_large {
        progress.hint_if_slow(format!("note: --fast {}", sooner(settings)));
    }
    let threads = options.thread_pool()?;
    let rendered = stoppable(|| threads.install(|| scene.render(settings, &progress)));
    let samples = progress.samples();
    let rgb = progress.rgb();
    if matches!(rendered, Err(Error::Stopped)) {
        keep(&rgb)?;
    }
    let image = rendered?;
    let name = scene.name;
    if let Some(samples) = samples {
        warn(&format!("note: {name}: {samples}"));
        if samples.misses(settings.max_error) {
            let part = samples.largest_part();
            warn(&format!(
                "warning: the error may be larger than --max-error: {part}; with more --samples it \
                 may be promised"
            ));
        } else if samples.is_conditional() {
            warn(
                "warning: the error is not promised: a small thing brighter than that may be hidden \
                 between the samples",
            );
        }
    }
    let bad = image.count_non_finite();
    if bad > 0 {
        warn(&format!(
            "warning: {bad} pixels of {name} are no finite numbers"
        ));
    }
    warn_if_black(scene, settings, &image);
    Ok(image)
}

/// Prints a note for each flag that does not change this scene, the notes about its files, and one
/// about a slow renderer.
pub fn warn_unused(scene: &Scene, options: &Options, settings: &Settings) {
    for flag in options.unused(scene.uses, settings) {
        warn(&format!("note: {flag} changes nothing in {}", scene.name));
    }
    print_notes(scene);
    if scene.is_large && settings.renderer != Renderer::Engine {
        let note = "has more than 10000 triangles, and each ray tests all; --fast renders it soon";
        warn(&format!("note: {} {note}", scene.name));
    }
}

/// Prints the notes about the files of a scene.
pub fn print_notes(scene: &Scene) {
    for note in &scene.notes {
        warn(&format!("note: {note}"));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_faster_picture_is_the_same_where_no_error_is_allowed() {
        let exact = Settings::default();
        let settings = Settings {
            max_error: Some(0.125),
            ..exact.clone()
        };
        assert!(sooner(&exact).contains("same picture"));
        assert!(!sooner(&settings).contains("same"));
    }
}
