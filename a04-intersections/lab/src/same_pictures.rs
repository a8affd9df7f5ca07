//! Compares the pictures of the three renderers, and of the engine's instruction sets, in random scenes.

use std::collections::HashSet;
use std::ops::Range;

use a03_rays_cameras::View;
use common::{ArgumentError, Color, Image, Renderer, Settings, Size};

use crate::random_scene::Place;

/// Width and height of the pictures.
const SIDE: u32 = 32;

/// Renders a random scene with all renderers, and returns the lesson's picture; none if a number is
/// beyond the limits of the lesson.
pub fn compare(seed: u64, view: impl Fn(Place) -> Result<View, ArgumentError>) -> Option<Image> {
    let render = |renderer| {
        let settings = Settings {
            size: Size::new(SIDE, SIDE).ok()?,
            depth: 4,
            renderer,
            ..Settings::default()
        };
        let view = view(Place::new(seed)).ok()?;
        view.render(&settings, &()).ok()
    };
    let [lesson, engine, all_work] = Renderer::ALL.map(render);
    let baseline = engine::at_baseline(|| render(Renderer::Engine));
    let lesson = lesson?;
    let others = [
        ("the engine", engine),
        ("the engine at the baseline", baseline),
        ("all work", all_work),
    ];
    for (name, other) in others {
        let other = other?;
        let mut different = 0;
        for (a, b) in lesson.pixels().iter().zip(other.pixels()) {
            different += usize::from(!is_same(*a, *b));
        }
        assert!(
            different == 0,
            "{name} differs in {different} pixels, seed {seed}"
        );
    }
    Some(lesson)
}

/// Compares the renderers in scenes with these seeds, and returns how many have a picture and how
/// many of these have more than ten colours.
pub fn compare_all(
    seeds: Range<u64>,
    view: impl Fn(u64, Place) -> Result<View, ArgumentError>,
) -> (usize, usize) {
    let (mut pictures, mut colorful) = (0, 0);
    for seed in seeds {
        if let Some(image) = compare(seed, |place| view(seed, place)) {
            let mut colors = HashSet::new();
            for color in image.pixels() {
                colors.insert(color.channels().map(f64::to_bits));
            }
            pictures += 1;
            colorful += usize::from(colors.len() > 10);
        }
    }
    (pictures, colorful)
}

/// Compares the renderers in forty scenes with seeds from `first` on, most of which have to be
/// pictures of many colours.
///
/// # Panics
///
/// If two renderers differ in a pixel, or if too few scenes have a picture.
pub fn compare_forty(first: u64, view: impl Fn(u64, Place) -> Result<View, ArgumentError>) {
    let (pictures, colorful) = compare_all(first..first + 40, view);
    assert!(pictures > 30 && colorful > 20, "{pictures}, {colorful}");
}

/// Compares the renderers in scenes with these seeds, of which five thousand have to have a
/// picture. It takes minutes.
///
/// # Panics
///
/// If two renderers differ in a pixel, or if too few scenes have a picture.
pub fn compare_thousands(
    seeds: Range<u64>,
    view: impl Fn(u64, Place) -> Result<View, ArgumentError>,
) {
    let (pictures, colorful) = compare_all(seeds, view);
    assert!(pictures > 5_000, "{pictures}, {colorful}");
}

/// Whether colours are equal, or both no numbers.
fn is_same(a: Color, b: Color) -> bool {
    let mut channels = a.channels().into_iter().zip(b.channels());
    channels.all(|(a, b)| a == b || a.is_nan() && b.is_nan())
}
