//! Compares the pictures of the three renderers, and of the engine's instruction sets.

use std::collections::HashSet;
use std::env;
use std::ops::Range;
use std::path::Path;

use a03_rays_cameras::View;
use a03_rays_cameras::registry::Format;
use common::{Color, Image, Renderer, Sampling, Settings};
use scene_file::SceneFile;
use testing::FORMULAS;

use crate::scenes::{file, style, text};

/// Renders a view with all renderers, and returns the lesson's picture. The world is that of a seed.
pub fn compare(seed: u64, view: impl Fn() -> View, settings: &Settings) -> Image {
    let render = |renderer| {
        let settings = Settings {
            renderer,
            ..settings.clone()
        };
        view().render(&settings, &()).unwrap()
    };
    let lesson = render(Renderer::Lesson);
    let mut others = vec![("all work", render(Renderer::NoOmissions))];
    for engine in engine::at_each_level(|| render(Renderer::Engine)) {
        others.push(("the engine", engine));
    }
    for (name, other) in others {
        let mut different = 0;
        for (a, b) in lesson.pixels().iter().zip(other.pixels()) {
            different += usize::from(!is_same(*a, *b));
        }
        assert!(
            different == 0,
            "{name} differs in {different} pixels, seed {seed}\n{FORMULAS}"
        );
    }
    lesson
}

/// Whether colours are equal, or both no numbers.
fn is_same(a: Color, b: Color) -> bool {
    let mut channels = a.channels().into_iter().zip(b.channels());
    channels.all(|(a, b)| a == b || a.is_nan() && b.is_nan())
}

/// A debug build compares this part of the scenes, of all kinds: it is several times slower, and `.ci/run` compares
/// them all in a release build.
const PART: u64 = if cfg!(debug_assertions) { 4 } else { 1 };

/// These seeds or the first part of them, or as many as the environment variable `RANDOM_SCENES` says.
pub fn or_asked(seeds: Range<u64>) -> Range<u64> {
    let asked = env::var("RANDOM_SCENES").ok();
    let asked: Option<u64> = asked.and_then(|count| count.parse().ok());
    let count = asked.unwrap_or((seeds.end - seeds.start) / PART);
    seeds.start..seeds.start + count
}

/// Compares the renderers in the scenes of these seeds, or in more of them, with the settings of each. A scene
/// without a view has numbers beyond the limits of the lesson. Most of them have to have a picture, and some of these
/// more than ten colours.
pub fn compare_scenes(
    format: Format,
    seeds: Range<u64>,
    view: impl Fn(u64, &SceneFile) -> Option<View>,
) {
    let seeds = or_asked(seeds);
    let count = seeds.end - seeds.start;
    let (mut pictures, mut colorful) = (0, 0);
    for seed in seeds {
        let Ok(file) = file(format, &text(seed, style(seed), format)) else {
            continue;
        };
        if view(seed, &file).is_none() {
            continue;
        }
        let Ok((mut settings, _)) = format.scene(&file) else {
            continue;
        };
        if settings.samples > 1 {
            settings.sampling = Sampling::ALL[1 + seed as usize % 3];
        }
        // Where an error is allowed the engine may end reflections, so these scenes have none.
        if (format.stage < 6 || settings.depth == 1) && seed % 4 == 0 {
            settings.samples = settings.samples.max(16);
            settings.max_error = Some(1.0 / 64.0);
        }
        let image = compare(seed, || view(seed, &file).unwrap(), &settings);
        let mut colors = HashSet::new();
        for color in image.pixels() {
            colors.insert(color.channels().map(f64::to_bits));
        }
        pictures += 1;
        colorful += u64::from(colors.len() > 10);
    }
    assert!(
        3 * pictures > 2 * count,
        "only {pictures} of {count} scenes have a picture"
    );
    let is_colorful = 8 * colorful > count;
    assert!(
        is_colorful,
        "only {colorful} of {count} pictures have more than ten colours; a new row of keys.md draws other scenes, and of few \
        this may be chance: ask for more by RANDOM_SCENES=40"
    );
}

#[test]
fn the_files_of_all_formulas_exist() {
    let workbook = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    for file in FORMULAS.lines().skip(1).flat_map(|line| line.split(", ")) {
        assert!(workbook.join(file).is_file(), "{file}");
    }
}
