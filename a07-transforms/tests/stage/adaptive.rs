//! Adaptive sampling keeps its bound in the scenes of the course, rendered by the lesson
//! and by the engine: edges, highlights, shadows, mirrors and transformed shapes.

use std::sync::Mutex;

use common::{Color, Image, Renderer, Sampling, SamplingReport, Scene, Settings, Size};

/// The channels as a screen shows them.
fn channels(image: &Image) -> Vec<f64> {
    let shown = |color: &Color| color.map(|c| c.clamp(0.0, 1.0)).channels();
    image.pixels().iter().flat_map(shown).collect()
}

fn root_mean_square(a: &[f64], b: &[f64]) -> f64 {
    let squares = a.iter().zip(b).map(|(a, b)| (a - b) * (a - b));
    (squares.sum::<f64>() / a.len() as f64).sqrt()
}

/// Against samples of another seed, whose own error is at most a third of the least bound;
/// the bytes of that picture are the same by both renderers.
fn check(scene: &Scene) {
    let name = scene.name;
    let settings = Settings {
        size: Size::new(128, 96).expect("a size"),
        samples: 1024,
        ..scene.defaults.clone()
    };
    let reference = Settings {
        samples: 16 * 16,
        sampling: Sampling::Stratified,
        seed: 0x5EED,
        renderer: Renderer::Engine,
        ..settings.clone()
    };
    let reference = channels(&scene.render(&reference, &()).expect("a picture"));
    for (renderer, bound) in [
        (Renderer::Lesson, 1.0 / 128.0),
        (Renderer::Engine, 1.0 / 64.0),
        (Renderer::Engine, 1.0 / 510.0),
    ] {
        let settings = Settings {
            max_error: Some(bound),
            renderer,
            ..settings.clone()
        };
        let sampled = Mutex::new(SamplingReport::default());
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

#[test]
fn edges_and_highlights() {
    let stage = a05_lighting::stage();
    for name in ["lambert", "phong", "phong-spot"] {
        check(&stage.scene(name).expect("a scene"));
    }
}

#[test]
fn shadows_mirrors_and_transformed_shapes() {
    for stage in [a06_shadows_reflection::stage(), a07_transforms::stage()] {
        stage.scenes.iter().for_each(check);
    }
}
