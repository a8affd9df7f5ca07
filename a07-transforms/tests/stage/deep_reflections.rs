//! The largest depth between two perfect mirrors, where a ray hits as many surfaces as it may.

use common::{Color, Renderer, Settings, Size};

use crate::scene_cases::open;

/// Each surface adds 1/2^20 of ambient light, so that all sums are exact.
const SCENE: &str = "[camera]\neye = [0, 0, 0]\ngaze = [0, 0, -1]\nangle = 40\n\
    [world]\nambient = [1, 1, 1]\n\
    [material.mirror]\ndiffuse = [DIM, DIM, DIM]\nreflection = [1, 1, 1]\n\
    [[plane]]\npoint = [0, 0, -5]\nnormal = [0, 0, 1]\nmaterial = \"mirror\"\n\
    [[plane]]\npoint = [0, 0, 5]\nnormal = [0, 0, -1]\nmaterial = \"mirror\"\n";
const DIM: f64 = 1.0 / (1 << 20) as f64;

#[test]
fn the_largest_depth_ends_and_every_surface_counts() {
    let scene = open(&SCENE.replace("DIM", &format!("{DIM:?}"))).unwrap();
    let expected = Color::gray(f64::from(Settings::MAX_DEPTH) * DIM);
    for renderer in Renderer::ALL {
        let settings = Settings {
            size: Size::new(3, 2).unwrap(),
            depth: Settings::MAX_DEPTH,
            renderer,
            ..scene.defaults.clone()
        };
        let image = scene.render(&settings, &()).unwrap();
        for pixel in image.pixels() {
            assert_eq!(*pixel, expected, "{renderer:?}");
        }
        if renderer != Renderer::Lesson {
            continue;
        }
        let rays = scene.rays().unwrap();
        let trace = rays.trace(&settings, [1, 1]).unwrap();
        assert_eq!(trace.color, expected);
        assert!(rays.drawing(&settings, &trace, scene.name).is_ok());
        assert!(rays.seen_rays(&settings, &trace).is_ok());
    }
}
