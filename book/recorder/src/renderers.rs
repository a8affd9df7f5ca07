//! The three renderers beside each other: the same picture, in other times.

use common::{Error, Image, Renderer, Scene, difference};
use measure::experiment::{Curve, Errors, Experiment, Point, Times};

/// The scenes that are rendered by all three, each with the name of its experiment.
const SCENES: [(&str, &str); 7] = [
    ("striped-sky", "render-striped-sky"),
    ("scene-5", "render-scene-5"),
    ("phong", "render-phong"),
    ("sphere", "render-sphere"),
    ("aab", "render-aab"),
    ("box-transformations", "render-box-transformations"),
    ("disc", "render-disc"),
];

/// The renderers for a scene as it is, with the differences of their pictures as errors; none for a
/// scene that is not compared.
pub fn experiment(scene: &Scene) -> Option<Experiment<'_>> {
    let (_, name) = SCENES.iter().find(|(of, _)| *of == scene.name)?;
    Some(Experiment {
        question: "How long do the three renderers take for one picture?",
        parameter: "samples per pixel",
        work: "pixels",
        error: "rms difference of a channel",
        exact: "against the picture of the lesson",
        curves: Box::new(move || curves(scene).unwrap_or_default()),
        ..Experiment::new(name)
    })
}

fn curves(scene: &Scene) -> Result<Vec<Curve<'_>>, Error> {
    let picture = rendered(scene, Renderer::Lesson)?;
    let mut curves = Vec::new();
    for (name, renderer) in [
        ("lesson", Renderer::Lesson),
        ("engine", Renderer::Engine),
        ("all work", Renderer::NoOmissions),
    ] {
        let own = rendered(scene, renderer)?;
        let differences = difference::of_channels(&own, &picture);
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
