//! The lesson and the engine beside each other: the same picture, in other times.

use common::{Error, Image, Renderer, Scene};
use measure::experiment::{Curve, Errors, Experiment, Point, Times};

/// The scenes that are rendered by both.
pub const SCENES: [&str; 7] = [
    "striped-sky",
    "scene-5",
    "phong",
    "sphere",
    "aab",
    "box-transformations",
    "disc",
];

/// Both renderers for a scene as it is, with the differences of their pictures as errors.
pub fn experiment<'a>(name: &'a str, scene: &'a Scene) -> Experiment<'a> {
    Experiment {
        question: "How long do the lesson and the engine take for one picture?",
        parameter: "samples per pixel",
        work: "pixels",
        error: "rms difference of a channel",
        exact: "against the picture of the lesson",
        curves: Box::new(move |_| curves(scene).unwrap_or_default()),
        ..Experiment::new(name)
    }
}

fn curves(scene: &Scene) -> Result<Vec<Curve<'_>>, Error> {
    let picture = rendered(scene, Renderer::Lesson)?;
    let mut curves = Vec::new();
    for (name, renderer) in [("lesson", Renderer::Lesson), ("engine", Renderer::Engine)] {
        let own = rendered(scene, renderer)?;
        let mut differences = Vec::new();
        for (color, of_lesson) in own.pixels().iter().zip(picture.pixels()) {
            let pairs = color.channels().into_iter().zip(of_lesson.channels());
            differences.extend(pairs.map(|(channel, exact)| channel - exact));
        }
        curves.push(Curve::new(
            name,
            [Point {
                parameter: scene.defaults.samples.into(),
                work: scene.defaults.size.pixels() as f64,
                errors: Errors::of_inputs(3, differences),
                times: Times::of(move || rendered(scene, renderer)),
            }],
        ));
    }
    Ok(curves)
}

fn rendered(scene: &Scene, renderer: Renderer) -> Result<Image, Error> {
    let mut settings = scene.defaults.clone();
    settings.renderer = renderer;
    scene.render(&settings, &())
}
