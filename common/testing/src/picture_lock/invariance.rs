//! Checks of all scenes of a stage: their pictures depend neither on the number of threads nor on
//! the renderer, and those of one column or one row have their size.

use std::sync::Mutex;

use common::{Renderer, Sampling, SamplingReport, Scene, Settings, Size, Stage};

use super::render;
use crate::FORMULAS;

/// Few pixels, so that a scene can be rendered several times.
pub(super) fn small(scene: &Scene) -> Settings {
    Settings {
        size: Size::new(96, 72).expect("a size"),
        ..scene.defaults.clone()
    }
}

/// Random samples, and several reflections.
fn scattered(scene: &Scene) -> Settings {
    Settings {
        samples: 3,
        sampling: Sampling::Random,
        seed: 5,
        depth: 3,
        ..small(scene)
    }
}

/// Checks that the number of threads changes no bit: with one sample, with random
/// samples, and with adaptive sampling. The error of the latter is a sum
/// over pixels, and another order would change its last bits.
pub fn check_threads(stage: &Stage) {
    for scene in &stage.scenes {
        let adaptive = Settings {
            samples: 64,
            max_error: Some(1.0 / 255.0),
            ..small(scene)
        };
        for settings in [small(scene), scattered(scene), adaptive] {
            let with = |threads| {
                let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
                let pool = pool.build().expect("threads");
                let sampled = Mutex::new(SamplingReport::default());
                let image = pool.install(|| scene.render(&settings, &sampled));
                let sampled = sampled.into_inner().expect("the error estimate");
                (image.expect("the scene renders"), sampled)
            };
            let one = with(1);
            for threads in [2, 3, 8] {
                let is_same = one == with(threads);
                assert!(is_same, "{} differs with {threads} threads", scene.name);
            }
        }
    }
}

/// Checks that all renderers give the same picture with random samples and several
/// reflections, too.
pub fn check_omissions(stage: &Stage) {
    for scene in &stage.scenes {
        let picture = |renderer| {
            let settings = Settings {
                renderer,
                ..scattered(scene)
            };
            render(scene, &settings)
        };
        let lesson = picture(Renderer::Lesson);
        for renderer in Renderer::ALL {
            let is_same = picture(renderer) == lesson;
            let name = scene.name;
            assert!(
                is_same,
                "{renderer:?} draws another picture of {name} than the lesson\n{FORMULAS}"
            );
        }
    }
}

/// Renders every scene at sizes that may lead to a division by zero.
pub fn check_narrow_sizes(stage: &Stage) {
    for scene in stage.scenes.iter().filter(|scene| scene.uses.size) {
        for (width, height) in [(1, 1), (1, 50), (50, 1)] {
            let size = Size::new(width, height).expect("a size");
            let settings = Settings {
                size,
                ..scene.defaults.clone()
            };
            assert_eq!(render(scene, &settings).size(), size, "{}", scene.name);
        }
    }
}
