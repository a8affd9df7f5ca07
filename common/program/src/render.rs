//! `render`: renders scenes into PNG files.

use std::ops::Range;
use std::path::PathBuf;
use std::time::Instant;

use common::{Error, Scene, Settings, Size};
use measure::Stage;

use crate::explain::explain;
use crate::options::Options;
use crate::print::{print, warn};
use crate::target::Target;
use crate::terminal_progress::TerminalProgress;

/// Writes the pictures of these scenes, and prints the path and the time of each.
/// Wrong arguments are refused before the first picture is begun.
pub fn render_to_files(
    stage: &Stage,
    scenes: &[&Scene],
    output: Option<PathBuf>,
    explained: bool,
    options: &Options,
) -> Result<(), Error> {
    let target = Target::new(output, scenes.len())?;
    for scene in scenes {
        options.settings(scene)?;
        target.check(stage, scene)?;
    }
    for scene in scenes {
        warn_unused(scene, options, &options.settings(scene)?);
        let start = Instant::now();
        let (path, size) = if explained {
            let image = explain(scene, options)?;
            let rgb = image.to_rgb8(options.transfer);
            let path = target.write(stage, scene, image.size(), [Ok(rgb)])?;
            (path, image.size())
        } else {
            render_to_file(stage, scene, &target, options)?
        };
        let time = start.elapsed().as_secs_f64();
        print(&format!("{}  {size}  {time:.2} s", path.display()));
    }
    Ok(())
}

/// Pixels of a band, which is rendered before it is written: 27 bytes each.
const BAND: u32 = 1 << 22;

/// Renders a scene into a PNG file, with a bar on the terminal, and returns its path
/// and size. A traced picture may be larger than memory.
pub fn render_to_file(
    stage: &Stage,
    scene: &Scene,
    target: &Target,
    options: &Options,
) -> Result<(PathBuf, Size), Error> {
    let (path, size, bad) = render_in_bands(stage, scene, target, options, BAND)?;
    if bad > 0 {
        let name = scene.name;
        warn(&format!(
            "warning: {bad} pixels of {name} are no finite numbers"
        ));
    }
    Ok((path, size))
}

/// Renders a traced scene in bands of at most this many pixels, or of one row, and
/// any other scene as a whole. The last number counts the pixels that hold NaN or
/// infinity.
fn render_in_bands(
    stage: &Stage,
    scene: &Scene,
    target: &Target,
    options: &Options,
    most_pixels: u32,
) -> Result<(PathBuf, Size, usize), Error> {
    let settings = options.settings(scene)?;
    let progress = TerminalProgress::new(scene.name, settings.size);
    let threads = options.thread_pool()?;
    let mut bad = 0;
    let mut render = |rows| -> Result<(Size, Vec<u8>), Error> {
        let settings = Settings {
            rows,
            ..settings.clone()
        };
        threads.install(|| {
            let image = scene.render(&settings, &progress)?;
            bad += image.count_non_finite();
            Ok((image.size(), image.to_rgb8(options.transfer)))
        })
    };
    let (path, size) = if scene.uses.sampling {
        let bands = bands(settings.size, most_pixels);
        let bands = bands.map(|rows| render(Some(rows)).map(|(_, rgb)| rgb));
        let path = target.write(stage, scene, settings.size, bands)?;
        (path, settings.size)
    } else {
        // A picture that is opened has its own size.
        let (size, rgb) = render(None)?;
        (target.write(stage, scene, size, [Ok(rgb)])?, size)
    };
    let samples = progress.samples();
    drop(progress);
    if let Some(samples) = samples {
        warn(&format!("note: {}: {samples}", scene.name));
        if samples.misses(settings.max_error) {
            warn(
                "warning: the error may be larger than --max-error; with more --samples it may \
                 be promised",
            );
        }
    }
    Ok((path, size, bad))
}

/// The bands of a picture: as many rows as have at most this many pixels, but at
/// least one.
fn bands(size: Size, most_pixels: u32) -> impl Iterator<Item = Range<u32>> {
    let rows = (most_pixels / size.width()).max(1);
    let starts = (0..size.height()).step_by(rows as usize);
    starts.map(move |start| start..size.height().min(start + rows))
}

/// Prints a note for each flag that does not change this scene.
pub fn warn_unused(scene: &Scene, options: &Options, settings: &Settings) {
    for flag in options.unused(scene.uses, settings) {
        warn(&format!("note: {flag} changes nothing in {}", scene.name));
    }
}

#[cfg(test)]
mod tests {
    use common::{Color, Image, picture_file};

    use super::*;

    fn size(width: u32, height: u32) -> Size {
        Size::new(width, height).unwrap()
    }

    /// A picture of 20 x 23 pixels, all different, two of which are no finite numbers.
    fn stage() -> Stage {
        let scene = Scene::traced("numbers", "", |settings, progress| {
            let rows = settings.rows();
            let band = size(settings.size.width(), rows.len() as u32);
            let mut image = Image::black(band)?;
            for (y, row) in rows.zip(image.rows_mut()) {
                for (x, pixel) in (0..).zip(&mut *row) {
                    let bad = [(0, 1), (19, 22)].contains(&(x, y));
                    let blue = if bad { f64::NAN } else { 0.0 };
                    *pixel = Color::from_bytes([x as u8, y as u8, 0]) + Color::new(0.0, 0.0, blue);
                }
                progress.row(y, &mut row.iter().copied());
            }
            Ok(image)
        });
        crate::stage_of(vec![scene.with_defaults(Settings {
            size: size(20, 23),
            ..Settings::default()
        })])
    }

    #[test]
    fn a_picture_in_bands_is_the_same_file() {
        let folder = tempfile::tempdir().unwrap();
        let (stage, options) = (stage(), Options::default());
        // Bands of one row, of one row, of seven rows with two left over, and of all rows.
        let files = [1, 39, 7 * 20 + 13, u32::MAX].map(|most| {
            let target = Target::Folder(folder.path().to_owned());
            let scene = &stage.scenes[0];
            let written = render_in_bands(&stage, scene, &target, &options, most).unwrap();
            let path = folder.path().join("a00-numbers.png");
            assert_eq!(written, (path.clone(), size(20, 23), 2), "{most}");
            let image = picture_file::open(&path).unwrap();
            for (y, row) in image.rows().enumerate() {
                for (x, pixel) in row.iter().enumerate() {
                    assert_eq!(pixel.to_bytes(), [x as u8, y as u8, 0], "{most}");
                }
            }
            std::fs::read(path).unwrap()
        });
        assert!(files.iter().all(|file| *file == files[0]));
        assert_eq!(folder.path().read_dir().unwrap().count(), 1);
    }

    #[test]
    fn bands_hold_no_more_pixels_than_allowed() {
        assert!(bands(size(7, 5), 20).eq([0..2, 2..4, 4..5]));
    }
}
