//! The pictures of this stage: the second course's striped sky, by both rules.

use std::f64::consts::FRAC_PI_2;

use a02_math::Point3;
use common::{Error, Image, Progress, Sampling, Scene, Settings, Size};
use measure::Stage;

use crate::{PinholeCamera, Sampler, StripeRule, StripedSky, render};

/// The stage for its program.
#[must_use]
pub fn stage() -> Stage {
    let about_text = "the text's rule: equal height of the direction; the stripes bend";
    let about_straight = "the straight stripes of a picture: equal height on a wall";
    Stage {
        name: "a03-rays-cameras",
        about: "Rays, cameras, sampling and the striped sky",
        scenes: vec![
            striped_sky("striped-sky", about_text, StripeRule::Direction),
            striped_sky("striped-sky-straight", about_straight, StripeRule::Wall),
        ],
        experiments: crate::lab::experiments::experiments,
        extremes: crate::lab::extremes::cases,
    }
}

fn striped_sky(name: &'static str, about: &'static str, rule: StripeRule) -> Scene {
    let paint = move |settings: &Settings, progress: &dyn Progress| -> Result<Image, Error> {
        let camera = PinholeCamera::new(Point3::ORIGIN, FRAC_PI_2)?;
        let sky = StripedSky::new(&camera, settings.size, STRIPES, rule)?;
        render(&camera, |ray| sky.color_for(ray), settings, progress)
    };
    let plan = |settings: &Settings| {
        let plan = Sampler::plan(settings);
        Ok(plan.without("intersections, lights and mirrors", "there is but a sky"))
    };
    Scene::traced(name, about, paint)
        .planned(plan)
        .with_defaults(Settings {
            size: Size::SECOND_COURSE,
            samples: 100,
            sampling: Sampling::Stratified,
            ..Settings::default()
        })
}

const STRIPES: u32 = 10;
