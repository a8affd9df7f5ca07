//! Adaptive sampling keeps its bound in the scenes of the course, rendered by the lesson
//! and by the engine: edges, highlights, shadows, mirrors and transformed shapes.

use std::sync::Mutex;

use common::{Color, Image, Renderer, Sampled, Sampling, Settings, Size};
use measure::Stage;
use measure::experiment::HALF_GREY_LEVEL;

const BOUNDS: [f64; 4] = [1.0 / 64.0, 1.0 / 128.0, 1.0 / 255.0, HALF_GREY_LEVEL];

/// The channels as a screen shows them.
fn channels(image: &Image) -> Vec<f64> {
    let shown = |color: &Color| color.map(|c| c.clamp(0.0, 1.0)).channels();
    image.pixels().iter().flat_map(shown).collect()
}

fn root_mean_square(a: &[f64], b: &[f64]) -> f64 {
    let squares = a.iter().zip(b).map(|(a, b)| (a - b) * (a - b));
    (squares.sum::<f64>() / a.len() as f64).sqrt()
}

/// Against many samples of another seed, whose own error is far smaller; the bytes of
/// that picture are the same by both renderers.
fn check(stage: &Stage, name: &str) {
    let scene = stage.scene(name).expect("a scene");
    let settings = Settings {
        size: Size::new(128, 96).expect("a size"),
        samples: 1024,
        ..scene.defaults.clone()
    };
    let reference = Settings {
        samples: 32 * 32,
        sampling: Sampling::Stratified,
        seed: 0x5EED,
        renderer: Renderer::Engine,
        ..settings.clone()
    };
    let reference = channels(&scene.render(&reference, &()).expect("a picture"));
    for renderer in [Renderer::Lesson, Renderer::Engine] {
        for bound in BOUNDS {
            let settings = Settings {
                max_error: Some(bound),
                renderer,
                ..settings.clone()
            };
            let sampled = Mutex::new(Sampled::default());
            let image = scene.render(&settings, &sampled).expect("a picture");
            let sampled = sampled.into_inner().expect("a report");
            let error = root_mean_square(&channels(&image), &reference);
            assert!(
                error <= bound,
                "{name} by {renderer:?}: {error} of {bound}; {sampled}"
            );
            assert!(!sampled.misses(Some(bound)), "{name}: {sampled}");
        }
    }
}

#[test]
fn edges_and_highlights() {
    let stage = a05_lighting::stage();
    for name in ["lambert", "phong", "phong-spot"] {
        check(&stage, name);
    }
}

#[test]
fn shadows_and_mirrors() {
    let stage = a06_shadows_reflection::stage();
    for name in ["sphere", "aab"] {
        check(&stage, name);
    }
}

#[test]
fn transformed_shapes() {
    let stage = a07_transforms::stage();
    for scene in &stage.scenes {
        check(&stage, scene.name);
    }
}
