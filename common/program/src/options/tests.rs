use super::*;

fn scene() -> Scene {
    Scene::traced("test", "", |settings, _| Image::black(settings.size))
}

#[test]
fn without_flags_the_scene_decides() {
    let defaults = Settings {
        samples: 9,
        sampling: Sampling::Regular,
        seed: 7,
        ..Settings::default()
    };
    let scene = scene().with_defaults(defaults.clone());
    assert_eq!(Options::default().settings(&scene).unwrap(), defaults);
}

#[test]
fn the_number_of_samples_chooses_a_sampling_that_allows_it() {
    let samples = |samples| Options {
        samples: Some(samples),
        ..Options::default()
    };
    let sampling = |n| samples(n).settings(&scene()).unwrap().sampling;
    assert_eq!(sampling(1), Sampling::Center);
    assert_eq!(sampling(16), Sampling::Stratified);

    let mut center = samples(4);
    center.sampling = Some(Sampling::Center);
    let error = center.settings(&scene()).unwrap_err().to_string();
    assert!(error.contains("one center"), "{error}");
    let error = samples(10).settings(&scene()).unwrap_err().to_string();
    assert!(error.contains("9 and 16"), "{error}");
}

#[test]
fn center_sampling_means_one_sample() {
    let scene = scene().with_defaults(Settings {
        samples: 100,
        sampling: Sampling::Stratified,
        ..Settings::default()
    });
    let center = Options {
        sampling: Some(Sampling::Center),
        ..Options::default()
    };
    assert_eq!(center.settings(&scene).unwrap().samples, 1);
}

#[test]
fn only_traced_pictures_may_be_larger_than_memory() {
    let large = Options {
        size: Some(Size::new(16_384, 16_384).unwrap()),
        ..Options::default()
    };
    let paint = |settings: &Settings, _: &dyn common::Progress| Image::black(settings.size);
    assert!(large.settings(&scene()).is_ok());
    assert!(large.settings(&Scene::opened("test", "", paint)).is_ok());
    let refused = large.settings(&Scene::painted("test", "", paint));
    assert!(matches!(refused, Err(Error::TooLarge { .. })));
}

#[test]
fn with_a_bound_of_the_error_samples_are_the_most_of_a_pixel() {
    let mut bounded = Options {
        max_error: Some(0.002),
        ..Options::default()
    };
    let settings = bounded.settings(&scene()).unwrap();
    assert_eq!((settings.max_error, settings.samples), (Some(0.002), 1024));
    // The number need not be a square.
    bounded.samples = Some(5);
    assert_eq!(bounded.settings(&scene()).unwrap().samples, 5);
}

#[test]
fn an_error_is_read_as_a_number_or_a_fraction() {
    assert_eq!(error_bound("0.25"), Ok(0.25));
    assert_eq!(error_bound("1/510"), Ok(1.0 / 510.0));
    assert_eq!(error_bound("1"), Ok(1.0));
    for text in [
        "", "0", "-1", "2", "1/0", "1/-2", "nan", "inf", "1/inf", "0/0", "1/2/3", "x",
    ] {
        assert!(error_bound(text).unwrap_err().contains("1/510"), "{text}");
    }
}

#[test]
fn random_samples_may_be_any_number() {
    assert!(check_places(5, Sampling::Random).is_ok());
}

#[test]
fn a_flag_chooses_the_renderer_or_the_scene_does() {
    let chosen = |renderer, fast, no_omit| {
        let scene = scene().with_defaults(Settings {
            renderer,
            ..Settings::default()
        });
        let flags = Options {
            fast,
            no_omit,
            ..Options::default()
        };
        flags.settings(&scene).unwrap().renderer
    };
    for default in Renderer::ALL {
        assert_eq!(chosen(default, false, false), default);
        assert_eq!(chosen(default, true, false), Renderer::Engine);
        assert_eq!(chosen(default, false, true), Renderer::AllWork);
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
    let of_samples = ["--samples", "--sampling", "--max-error", "--seed", "--fast"];
    for (scene, before, after) in [
        (
            Scene::painted("", "", paint),
            &[][..],
            &["--depth", "--open"][..],
        ),
        (Scene::opened("", "", paint), &["--size"], &["--depth"]),
    ] {
        let expected = [before, &of_samples, after].concat();
        assert_eq!(all.unused(scene.uses, &random), expected);
        assert!(Options::default().unused(scene.uses, &random).is_empty());
    }
    assert_eq!(all.unused(scene().uses, &random), ["--depth", "--open"]);
    assert_eq!(all.unused(scene().reflecting().uses, &random), ["--open"]);
    let center = ["--seed", "--depth", "--open"];
    assert_eq!(all.unused(scene().uses, &Settings::default()), center);
}
