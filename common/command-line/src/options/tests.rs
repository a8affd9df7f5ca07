use common::Image;

use super::*;

fn scene() -> Scene {
    Scene::sampled("test", "", |settings, _| Image::black(settings.size))
}

#[test]
fn number_and_places_of_the_samples_fit_each_other() {
    let scene = scene().with_defaults(Settings {
        samples: 100,
        sampling: Sampling::Stratified,
        ..Settings::default()
    });
    let (center, random) = (Some(Sampling::Center), Some(Sampling::Random));
    for (samples, sampling, expected) in [
        (None, None, Ok((100, Sampling::Stratified))),
        (None, center, Ok((1, Sampling::Center))),
        (Some(1), None, Ok((1, Sampling::Center))),
        (Some(16), None, Ok((16, Sampling::Stratified))),
        (Some(5), random, Ok((5, Sampling::Random))),
        (Some(4), center, Err("one center")),
        (Some(10), None, Err("9 and 16")),
    ] {
        let options = Options {
            samples,
            sampling,
            ..Options::default()
        };
        let settings = options.settings(&scene);
        match (settings, expected) {
            (Ok(s), expected) => assert_eq!(Ok((s.samples, s.sampling)), expected),
            (Err(error), Err(part)) => assert!(error.to_string().contains(part), "{error}"),
            (Err(error), _) => panic!("{error}"),
        }
    }
}

/// The number of samples need not be a square.
#[test]
fn with_an_error_bound_samples_are_the_most_of_a_pixel() {
    for (samples, most) in [(None, 1024), (Some(5), 5)] {
        let mut options = Options::default();
        (options.max_error, options.samples) = (Some(0.002), samples);
        let settings = options.settings(&scene()).unwrap();
        assert_eq!((settings.max_error, settings.samples), (Some(0.002), most));
    }
}

#[test]
fn an_error_is_read_as_a_number_or_a_fraction() {
    for (text, error) in [("0.25", 0.25), ("1/510", 1.0 / 510.0), ("1", 1.0)] {
        assert_eq!(error_bound(text), Ok(error));
    }
    for text in [
        "", "0", "-1", "2", "1/0", "1/-2", "nan", "inf", "1/inf", "0/0", "1/2/3", "x",
    ] {
        assert!(error_bound(text).is_err(), "{text}");
    }
}

#[test]
fn a_flag_chooses_the_renderer_or_the_scene_decides() {
    let defaults = Settings {
        samples: 9,
        sampling: Sampling::Regular,
        seed: 7,
        renderer: Renderer::Engine,
        ..Settings::default()
    };
    let scene = scene().with_defaults(defaults.clone());
    let mut flags = Options::default();
    assert_eq!(flags.settings(&scene).unwrap(), defaults);
    for (fast, no_omit, renderer) in [
        (true, false, Renderer::Engine),
        (false, true, Renderer::NoOmissions),
    ] {
        (flags.fast, flags.no_omit) = (fast, no_omit);
        assert_eq!(flags.settings(&scene).unwrap().renderer, renderer);
    }
}

#[test]
fn flags_that_change_nothing_are_named() {
    let paint = |settings: &Settings, _: &dyn common::Progress| Image::black(settings.size);
    let all = Options {
        size: Some(Size::COURSE),
        samples: Some(4),
        sampling: Some(Sampling::Random),
        max_error: Some(0.5),
        seed: Some(1),
        depth: Some(2),
        open: Some("a.png".into()),
        fast: true,
        ..Options::default()
    };
    let random = Settings {
        sampling: Sampling::Random,
        ..Settings::default()
    };
    let painted = "--samples --sampling --max-error --seed --fast --depth --open";
    let opened = "--size --samples --sampling --max-error --seed --fast --depth";
    for (scene, settings, expected) in [
        (Scene::painted("", "", paint), &random, painted),
        (Scene::opened("", "", paint), &random, opened),
        (scene(), &random, "--depth --open"),
        (scene().reflecting(), &random, "--open"),
        (scene(), &Settings::default(), "--seed --depth --open"),
    ] {
        assert_eq!(all.unused(scene.uses, settings).join(" "), expected);
        assert!(Options::default().unused(scene.uses, settings).is_empty());
    }
}
