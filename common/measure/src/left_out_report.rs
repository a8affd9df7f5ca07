//! What each kind of work costs that a renderer leaves out in a scene, as an experiment: its curves are
//! the renderer, and the same with one kind after the other put back.

use common::{Error, Image, Omissions, Renderer, Scene, Settings};
use program::{LeftOut, Words};

use crate::experiment::{Axis, Curve, Curves, Errors, Experiment, Point, Times};

/// The renderer with all that it leaves out.
const LEAVES_OUT: &str = "all of it left out";

/// The experiment of this name with a scene and a renderer. Work is counted and pictures are compared
/// before the first time is taken.
pub fn experiment<'a>(
    name: &'a str,
    scene: &'a Scene,
    renderer: Renderer,
) -> Result<Experiment<'a>, Error> {
    let settings = Settings {
        renderer,
        ..scene.defaults.clone()
    };
    let leaves_out = Settings {
        omissions: Some(Omissions::ALL),
        ..settings.clone()
    };
    let rows = LeftOut::all(scene, &settings)?;
    let expected = scene.render(&leaves_out, &())?;
    let mut methods = vec![Method {
        name: LEAVES_OUT,
        errors: vec![0.0],
        settings: leaves_out,
    }];
    for row in rows {
        methods.push(Method {
            name: Words::of(row.omission).work,
            errors: differences(&scene.render(&row.with, &())?, &expected),
            settings: row.with,
        });
    }
    Ok(Experiment {
        question: "What does each kind of work cost that the scene does not need?",
        parameter: "pixels",
        work: "pixels",
        against: Axis::Parameter,
        error: "rms difference of a channel",
        exact: "against the picture with all of it left out",
        curves_are: Curves::Problems,
        curves: Box::new(move |_| {
            let curves = methods.iter().map(|method| method.curve(scene));
            curves.collect()
        }),
        ..Experiment::new(name)
    })
}

/// A renderer that has put back some work.
struct Method {
    /// The kind that was put back last.
    name: &'static str,
    /// The differences of the channels from the picture without this work.
    errors: Vec<f64>,
    settings: Settings,
}

impl Method {
    fn curve<'a>(&self, scene: &'a Scene) -> Curve<'a> {
        let settings = self.settings.clone();
        let pixels = settings.size.pixels() as f64;
        let point = Point {
            parameter: pixels,
            work: pixels,
            errors: Errors::of(self.errors.iter().copied()),
            times: Times::of(move || scene.render(&settings, &())),
        };
        Curve::new(self.name, [point])
    }
}

fn differences(image: &Image, expected: &Image) -> Vec<f64> {
    let pairs = image.pixels().iter().zip(expected.pixels());
    let mut differences = Vec::new();
    for (pixel, expected) in pairs {
        for (channel, expected) in pixel.channels().into_iter().zip(expected.channels()) {
            differences.push(channel - expected);
        }
    }
    differences
}

#[cfg(test)]
mod tests {
    use common::steps::{StepKind, count};
    use common::{Color, Omission, Size};

    use super::*;
    use crate::Effort;

    /// A renderer that takes a power more for each kind of power that is not left out.
    #[test]
    fn each_kind_of_work_is_a_curve_without_error() {
        let scene = Scene::sampled("powers", "", |settings, _| {
            let omissions = settings.omissions.unwrap_or(Omissions::ALL);
            for omission in [Omission::BlackHighlights, Omission::HighlightsAway] {
                count(StepKind::Power, u64::from(!omissions.contains(omission)));
            }
            Image::from_fn(settings.size, |_, _| Color::WHITE)
        });
        let scene = scene.with_defaults(Settings {
            size: Size::new(2, 2).unwrap(),
            ..Settings::default()
        });
        let experiment = experiment("left-out-powers", &scene, Renderer::Lesson).unwrap();
        let curves = (experiment.curves)(Effort::Quick);
        let names: Vec<_> = curves.iter().map(|curve| curve.method).collect();
        let expected = [
            LEAVES_OUT,
            "powers of a black highlight",
            "powers where the light is mirrored away from the eye",
        ];
        assert_eq!(names, expected);
        for curve in curves {
            assert_eq!(curve.points[0].errors.rms, 0.0);
        }
    }
}
