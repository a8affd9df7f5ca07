//! Pictures of scenes that the book shows beside those of the stages, such as that of a scene file.

use std::fs;
use std::path::Path;

use common::difference::{compare_with_file, leave_pictures};
use common::{Renderer, Sampling, Scene, Settings, Size, picture_file};

use super::{TestPaths, accepts, put_aside, render};

/// Most pixels of a picture that is drawn where the engine is not fully optimised.
const MAX_PIXELS: usize = 320 * 240;

/// A picture of the book.
pub struct BookPicture {
    /// The name of its file.
    pub name: String,
    /// What it shows.
    pub scene: Scene,
}

/// Draws each scene by the engine, in the size of its picture in the book, and compares all pixels. A failure names all
/// pictures that are stale; `INSTA_UPDATE=always` replaces them, and draws those that are missing, if all renderers
/// draw small pictures of these scenes alike. Large pictures are compared in an optimised build only.
pub fn check_book_pictures(all: &[BookPicture], places: &TestPaths) {
    let mut stale = Vec::new();
    for picture in all {
        let expected = places.expected(&picture.name);
        let small = Size::new(320, 240).expect("a size");
        let size = picture_file::open(&expected).map_or(small, |image| image.size());
        if cfg!(debug_assertions) && !accepts() && size.pixels() > MAX_PIXELS {
            continue;
        }
        let settings = Settings {
            size,
            renderer: Renderer::Engine,
            ..picture.scene.defaults.clone()
        };
        let drawn = render(&picture.scene, &settings);
        let drawn = put_aside(&drawn, settings.transfer, &expected, places);
        let image = picture_file::open(&drawn).expect("the picture");
        if let Err(difference) = compare_with_file(&expected, &image) {
            let difference = format!("{}: {difference}", picture.name);
            let scratch = Path::new(places.scratch);
            let message = leave_pictures(scratch, &expected, &image, &difference);
            stale.push((&picture.scene, message, [drawn, expected]));
        }
    }
    if !accepts() {
        let messages: Vec<_> = stale
            .iter()
            .map(|(_, message, _)| message.as_str())
            .collect();
        assert!(
            messages.is_empty(),
            "stale pictures:\n{}",
            messages.join("\n")
        );
        return;
    }
    for (scene, message, _) in &stale {
        check_renderers(scene, message);
    }
    for (_, _, [drawn, expected]) in stale {
        fs::copy(drawn, expected).expect("the picture of the book is written");
    }
}

/// Checks that all renderers draw the same small picture.
fn check_renderers(scene: &Scene, message: &str) {
    let [lesson, others @ ..] = Renderer::ALL.map(|renderer| {
        let settings = Settings {
            size: Size::new(48, 36).expect("a size"),
            samples: 1,
            sampling: Sampling::Center,
            renderer,
            ..scene.defaults.clone()
        };
        render(scene, &settings)
    });
    let are_same = others.iter().all(|other| *other == lesson);
    assert!(
        are_same,
        "{message}\n  is not replaced: the renderers draw different pictures"
    );
}
