//! The engine draws all scenes of the course with the instructions that each processor has as with the
//! best of this one: the locked pictures, and small ones of random and of adaptive samples. Only a release
//! build has both.

use common::{Renderer, Sampling, Scene, Settings, Size};

fn check(scene: &Scene, settings: &Settings) {
    let settings = Settings {
        renderer: Renderer::Engine,
        ..settings.clone()
    };
    let render = || scene.render(&settings, &()).unwrap();
    let pictures = engine::at_each_level(render);
    let are_same = pictures.iter().all(|picture| *picture == pictures[0]);
    assert!(are_same, "{} differs", scene.name);
}

fn check_small(scene: &Scene) {
    let random = Settings {
        size: Size::new(96, 72).unwrap(),
        samples: 3,
        sampling: Sampling::Random,
        seed: 5,
        depth: 3,
        ..scene.defaults.clone()
    };
    let adaptive = Settings {
        samples: 64,
        max_error: Some(1.0 / 255.0),
        ..random.clone()
    };
    check(scene, &random);
    check(scene, &adaptive);
}

#[test]
fn all_instruction_sets_draw_the_locked_pictures() {
    if engine::HAS_ONE_LEVEL {
        return;
    }
    let stages = [
        a03_rays_cameras::stage(),
        a04_intersections::stage(),
        a05_lighting::stage(),
        a06_shadows_reflection::stage(),
        a07_transforms::stage(),
    ];
    for stage in &stages {
        for scene in &stage.scenes {
            check(scene, &scene.defaults);
            check_small(scene);
        }
    }
}
