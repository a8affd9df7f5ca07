//! Compares the pictures of the three renderers, and of the engine's instruction sets, in random scenes.

use std::collections::HashSet;
use std::env;
use std::ops::Range;

use a03_rays_cameras::View;
use common::{ArgumentError, Color, Image, Renderer, Settings, Size};

use crate::random_scene::Place;

/// Width and height of the pictures.
const SIDE: u32 = 32;

/// Renders a random scene with all renderers, and returns the lesson's picture; none if a number is
/// beyond the limits of the lesson.
fn compare(seed: u64, view: impl Fn(Place) -> Result<View, ArgumentError>) -> Option<Image> {
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

/// Compares the renderers in scenes with these seeds, or in as many scenes as the environment variable
/// `RANDOM_SCENES` says. Most of them have to have a picture, and many of these more than ten colours.
///
/// # Panics
///
/// If two renderers differ in a pixel, or if too few scenes have a picture.
pub fn compare_scenes(seeds: Range<u64>, view: impl Fn(u64, Place) -> Result<View, ArgumentError>) {
    let asked = env::var("RANDOM_SCENES");
    let asked = asked.ok().and_then(|count| count.parse().ok());
    let count = asked.unwrap_or(seeds.end - seeds.start);
    let (mut pictures, mut colorful) = (0, 0);
    for seed in (seeds.start..).take(count as usize) {
        if let Some(image) = compare(seed, |place| view(seed, place)) {
            let mut colors = HashSet::new();
            for color in image.pixels() {
                colors.insert(color.channels().map(f64::to_bits));
            }
            pictures += 1;
            colorful += u64::from(colors.len() > 10);
        }
    }
    let are_enough = 3 * pictures > 2 * count && 6 * colorful > count;
    assert!(are_enough, "{pictures} and {colorful} of {count}");
}

/// Whether colours are equal, or both no numbers.
fn is_same(a: Color, b: Color) -> bool {
    let mut channels = a.channels().into_iter().zip(b.channels());
    channels.all(|(a, b)| a == b || a.is_nan() && b.is_nan())
}
