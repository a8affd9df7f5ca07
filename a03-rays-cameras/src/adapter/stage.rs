//! `stage`: the scenes of this stage for its program.

use common::{Color, Sampling, Settings, Size, Stage};

use crate::instruments::Instruments;
use crate::{Ray, StripeRule, StripedSky, TracedWorld, View, instruments, scenes, traced_scene};

/// The stage for its program.
#[must_use]
pub fn stage() -> Stage {
    let scenes = [
        traced_scene(
            "striped-sky",
            "the text's rule: equal height of the direction; the stripes bend",
            |size| scenes::striped_sky(size, StripeRule::Direction).map(View::boxed),
        ),
        traced_scene(
            "striped-sky-straight",
            "the straight stripes of a picture: equal height on a wall",
            |size| scenes::striped_sky(size, StripeRule::Wall).map(View::boxed),
        ),
    ];
    let defaults = Settings {
        size: Size::SECOND_COURSE,
        samples: 100,
        sampling: Sampling::Stratified,
        ..Settings::default()
    };
    Stage {
        name: "a03-rays-cameras",
        about: "Rays, cameras, sampling and the striped sky",
        scenes: scenes
            .map(|scene| scene.with_defaults(defaults.clone()))
            .into(),
        open: None,
    }
}

/// The engine has no type for the sky, and no work is left out on the way to it.
impl TracedWorld for StripedSky {
    fn radiance(&self, ray: &Ray, _: u32) -> Color {
        self.color_for(ray)
    }

    fn instrumented(self: Box<Self>, _: Instruments) -> Box<dyn TracedWorld> {
        Box::new(move |ray: &Ray| {
            let color = self.color_for(ray);
            instruments::instrumented::push_stripe(self.stripe(ray), color);
            color
        })
    }
}
