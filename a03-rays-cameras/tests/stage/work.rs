//! The work of the scenes of this stage, in the lesson and with nothing left out.

use a03_rays_cameras::stage;
use common::tally::{Work, counted};
use common::{Renderer, Sampling, Settings, Size};

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
