//! `stage`: joins the scenes, renderers, experiments and extreme cases of this
//! stage for its program.

use common::tally;
use common::{Color, Error, Image, Progress, Renderer, Sampling, Scene, Settings, Size};
use measure::Stage;

use crate::fast::render_by_lesson;
use crate::lab::{all_work, counted, experiments, explain, extremes};
use crate::scenes::striped_sky;
use crate::{Camera, Ray, StripeRule};

/// The stage for its program.
#[must_use]
pub fn stage() -> Stage {
    let about_text = "the text's rule: equal height of the direction; the stripes bend";
    let about_straight = "the straight stripes of a picture: equal height on a wall";
    Stage {
        name: "a03-rays-cameras",
        about: "Rays, cameras, sampling and the striped sky",
        scenes: vec![
            scene("striped-sky", about_text, StripeRule::Direction),
            scene("striped-sky-straight", about_straight, StripeRule::Wall),
        ],
        experiments: experiments::experiments,
        extremes: extremes::cases,
    }
}

fn scene(name: &'static str, about: &'static str, rule: StripeRule) -> Scene {
    let paint = move |settings: &Settings, progress: &dyn Progress| {
        let (camera, sky) = striped_sky(settings.size, rule)?;
        // The engine has no type for the sky.
        render_view(
            Box::new(camera),
            |ray| sky.color_for(ray),
            settings,
            progress,
        )
    };
    Scene::traced(name, about, paint)
        .planned(|settings, _| Ok(explain::sky(settings)))
        .with_defaults(Settings {
            size: Size::SECOND_COURSE,
            samples: 100,
            sampling: Sampling::Stratified,
            ..Settings::default()
        })
}

/// Renders a picture by the lesson, or with all work if the settings select that; and
/// counts the rays of the camera if work is counted.
pub fn render_view(
    mut camera: Box<dyn Camera>,
    radiance: impl Fn(&Ray) -> Color + Sync,
    settings: &Settings,
    progress: &dyn Progress,
) -> Result<Image, Error> {
    if tally::is_on() {
        camera = counted::camera(camera, settings);
    }
    if settings.renderer == Renderer::AllWork {
        all_work::render(&camera, radiance, settings, progress)
    } else {
        render_by_lesson(&camera, radiance, settings, progress)
    }
}
