//! Which work the scenes of this stage take, in the lesson and with nothing left
//! out.

use a03_rays_cameras::stage;
use common::{Renderer, Sampling, Settings, Size};
use measure::tally::{Work, counted};

fn settings(sampling: Sampling, renderer: Renderer) -> Settings {
    Settings {
        size: Size::new(3, 2).unwrap(),
        samples: 5,
        sampling,
        renderer,
        ..Settings::default()
    }
}

#[test]
fn samples_with_a_fixed_place_take_no_random_numbers() {
    let scene = &stage().scenes[0];
    for (sampling, samples, needed) in [
        (Sampling::Center, 1, 0),
        (Sampling::Regular, 4, 0),
        (Sampling::Random, 5, 10),
        (Sampling::Stratified, 4, 8),
    ] {
        let rendered = |renderer| {
            let settings = settings(sampling, renderer);
            let (image, tally) = counted(|| scene.render(&settings, &())).unwrap();
            assert_eq!(tally[Work::PrimaryRay], 6 * samples, "{sampling:?}");
            (image.unwrap(), tally[Work::RandomNumber])
        };
        let (lesson, all) = (rendered(Renderer::Lesson), rendered(Renderer::AllWork));
        assert_eq!(
            (lesson.1, all.1),
            (6 * needed, 12 * samples),
            "{sampling:?}"
        );
        assert_eq!(lesson.0, all.0, "{sampling:?}");
    }
}

#[test]
fn the_plan_counts_rays_and_names_needless_random_numbers() {
    let scene = &stage().scenes[0];
    for (sampling, rays, each, is_random) in [
        (Sampling::Center, 6, 1, false),
        (Sampling::Regular, 24, 4, false),
        (Sampling::Random, 30, 5, true),
        (Sampling::Stratified, 24, 4, true),
    ] {
        let plan = scene.plan(&settings(sampling, Renderer::Lesson)).unwrap();
        assert_eq!(
            plan.needs,
            [format!("primary rays: {rays}, {each} per pixel")]
        );
        let omitted = plan.omissions.iter();
        let names_numbers = omitted.filter(|o| o.what == "random numbers").count() == 1;
        assert_eq!(names_numbers, !is_random, "{sampling:?}");
    }
}
