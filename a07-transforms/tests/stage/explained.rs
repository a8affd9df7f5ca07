//! The steps behind a pixel add up to the pixel of the picture, in all traced scenes.

use std::collections::BTreeSet;

use common::steps::{Step, StepKind};
use common::{Color, PixelTrace, Renderer, Scene, Settings, Size};

use crate::rows::assert_in_the_book;

fn scenes() -> Vec<Scene> {
    let stages = [
        a03_rays_cameras::stage(),
        a04_intersections::stage(),
        a05_lighting::stage(),
        a06_shadows_reflection::stage(),
        a07_transforms::stage(),
    ];
    stages.into_iter().flat_map(|stage| stage.scenes).collect()
}

fn color(step: &Step, symbol: &str) -> Color {
    let [r, g, b] = step.value(symbol).expect(symbol);
    Color::new(r, g, b)
}

/// Adds up what the steps of a pixel say: the terms of each surface, and the surfaces times the
/// mirrors before them.
fn explained_sum(trace: &PixelTrace) -> Color {
    let (mut sum, mut samples) = (Color::BLACK, 0.0);
    let [mut mirrored, mut terms] = [Color::WHITE, Color::BLACK];
    for step in &trace.steps {
        match step.kind {
            StepKind::Sample => (mirrored, samples) = (Color::WHITE, samples + 1.0),
            StepKind::Ambient | StepKind::ReflectedLight => terms += color(step, "c"),
            StepKind::Color | StepKind::Background => {
                assert!([Color::BLACK, color(step, "c")].contains(&terms), "{trace}");
                sum += mirrored * color(step, "c");
                terms = Color::BLACK;
            }
            StepKind::Mirror => mirrored = mirrored * color(step, "cr"),
            _ => (),
        }
    }
    sum / samples
}

#[test]
fn the_steps_of_a_pixel_add_up_to_its_colour() {
    let mut sections = BTreeSet::new();
    for scene in scenes() {
        for renderer in Renderer::ALL {
            let settings = Settings {
                size: Size::new(10, 8).unwrap(),
                samples: scene.defaults.samples.min(4),
                renderer,
                ..scene.defaults.clone()
            };
            let image = scene.render(&settings, &()).unwrap();
            let explained = scene.rays().unwrap();
            for (i, pixel) in (0..).zip(image.pixels()) {
                let trace = explained.trace(&settings, [i % 10, i / 10]).unwrap();
                assert_eq!(
                    trace.color, *pixel,
                    "{} by {renderer:?}:\n{trace}",
                    scene.name
                );
                if renderer != Renderer::Engine {
                    let sum = explained_sum(&trace).to_bytes();
                    assert_eq!(sum, pixel.to_bytes(), "{}:\n{trace}", scene.name);
                }
                sections.extend(trace.steps.iter().map(|step| step.section));
            }
        }
    }
    assert!(sections.len() > 15, "{sections:?}");
    for section in sections {
        assert_in_the_book(section);
    }
}

/// The rays of the first sample and all objects of the scene are in both views.
#[test]
fn a_drawing_shows_objects_and_rays() {
    let scene = &a06_shadows_reflection::stage().scenes[0];
    let rays = scene.rays().unwrap();
    let trace = rays.trace(&scene.defaults, [250, 250]).unwrap();
    let drawing = rays.drawing(&scene.defaults, &trace, scene.name).unwrap();
    for (part, times) in [
        ("1: Plane", 2),
        ("4: Sphere", 2),
        ("light 1", 2),
        (r#"class="curve ray"#, 10),
    ] {
        assert_eq!(drawing.matches(part).count(), times, "{part}");
    }
}
