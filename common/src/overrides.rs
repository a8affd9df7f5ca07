//! The flags that change how a scene is rendered.

use std::path::PathBuf;

use crate::scene::Heeds;
use crate::{Error, Image, Sampling, Scene, Settings, Size, Transfer};

/// What of a scene's defaults the command line replaces.
#[derive(Clone, Debug, Default, clap::Args)]
pub struct Overrides {
    /// Width and height in pixels [default: the scene's]
    #[arg(long, value_name = "WxH")]
    size: Option<Size>,

    /// Samples per pixel [default: the scene's]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    samples: Option<u32>,

    /// Where samples lie [default: center for one sample, else stratified]
    #[arg(long, value_enum, value_name = "HOW")]
    sampling: Option<Sampling>,

    /// Take samples where they are needed, until the picture's root mean square
    /// error is estimated to be at most this, such as 1/510; of a pixel at most
    /// the --samples [default: 1024]
    #[arg(long, value_name = "E", value_parser = error_bound, conflicts_with = "sampling")]
    max_error: Option<f64>,

    /// Selects the random numbers [default: 0]
    #[arg(long, value_name = "N")]
    seed: Option<u64>,

    /// How many surfaces a ray may meet, 1 showing no reflection [default: the scene's]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    depth: Option<u32>,

    /// Threads to render with [default: one a core]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,

    /// Curve between light and the values in the file
    #[arg(long, value_enum, value_name = "CURVE", default_value_t)]
    pub transfer: Transfer,

    /// Do also the work that cannot change the picture
    #[arg(long)]
    no_omit: bool,

    /// The picture that show-image opens (PNG, JPEG or BMP)
    #[arg(long, value_name = "FILE")]
    pub open: Option<PathBuf>,
}

/// More samples of a pixel are not taken without being asked for.
const ENOUGH: u32 = 1024;

/// Reads a number or a fraction, above 0 and at most 1.
fn error_bound(text: &str) -> Result<f64, String> {
    let (numerator, denominator) = text.split_once('/').unwrap_or((text, "1"));
    let [numerator, denominator] = [numerator, denominator].map(|n| n.trim().parse::<f64>());
    match (numerator, denominator) {
        (Ok(n), Ok(d)) if n / d > 0.0 && n / d <= 1.0 => Ok(n / d),
        _ => Err("a number above 0 and at most 1 is needed, such as 1/510 or 0.002".to_owned()),
    }
}

/// Checks that this sampling has room for that many samples.
fn check_places(samples: u32, sampling: Sampling) -> Result<(), Error> {
    if sampling == Sampling::Center && samples > 1 {
        return Err(Error::Usage(format!(
            "a pixel has one center, not {samples}; \
             --sampling regular, random or stratified takes more samples"
        )));
    }
    let root = samples.isqrt();
    if sampling.is_grid() && root * root != samples {
        let (below, above) = (root * root, (root + 1) * (root + 1));
        return Err(Error::Usage(format!(
            "--samples {samples} makes no square grid, which regular and stratified \
             sampling need; {below} and {above} do, and random sampling takes any number"
        )));
    }
    Ok(())
}

impl Overrides {
    /// The threads to render with.
    pub fn thread_pool(&self) -> Result<rayon::ThreadPool, Error> {
        // 0 lets there be one a core.
        let threads = self.threads.unwrap_or(0).into();
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
        Ok(pool.build()?)
    }

    /// The settings for `scene`: what was asked for, else its defaults.
    pub fn settings(&self, scene: &Scene) -> Result<Settings, Error> {
        let defaults = &scene.defaults;
        let (samples, sampling) = match (self.samples, self.sampling) {
            (None, None) => (defaults.samples, defaults.sampling),
            (None, Some(Sampling::Center)) | (Some(1), None) => (1, Sampling::Center),
            (None, Some(sampling)) => (defaults.samples, sampling),
            (Some(samples), None) => (samples, Sampling::Stratified),
            (Some(samples), Some(sampling)) => (samples, sampling),
        };
        let max_error = self.max_error.or(defaults.max_error);
        if max_error.is_none() {
            check_places(samples, sampling)?;
        }
        let size = self.size.unwrap_or(defaults.size);
        if scene.heeds.size && !scene.heeds.sampling {
            Image::check_size(size)?;
        }
        Ok(Settings {
            size,
            rows: None,
            samples: match self.max_error {
                Some(_) => self.samples.unwrap_or(ENOUGH),
                None => samples,
            },
            sampling,
            max_error,
            seed: self.seed.unwrap_or(defaults.seed),
            depth: self.depth.unwrap_or(defaults.depth),
            omit: defaults.omit && !self.no_omit,
            file: self.open.clone().or_else(|| defaults.file.clone()),
        })
    }

    /// The flags that were given although they do not change this scene.
    pub fn unheeded(&self, heeds: Heeds) -> Vec<&'static str> {
        let sampling = !heeds.sampling;
        [
            ("--size", self.size.is_some() && !heeds.size),
            ("--samples", self.samples.is_some() && sampling),
            ("--sampling", self.sampling.is_some() && sampling),
            ("--max-error", self.max_error.is_some() && sampling),
            ("--seed", self.seed.is_some() && sampling),
            ("--depth", self.depth.is_some() && !heeds.depth),
            ("--open", self.open.is_some() && !heeds.file),
        ]
        .into_iter()
        .filter_map(|(flag, unheeded)| unheeded.then_some(flag))
        .collect()
    }
}

#[cfg(test)]
mod tests {
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
        assert_eq!(Overrides::default().settings(&scene).unwrap(), defaults);
    }

    #[test]
    fn the_number_of_samples_chooses_a_sampling_that_can_hold_it() {
        let samples = |samples| Overrides {
            samples: Some(samples),
            ..Overrides::default()
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
        let center = Overrides {
            sampling: Some(Sampling::Center),
            ..Overrides::default()
        };
        assert_eq!(center.settings(&scene).unwrap().samples, 1);
    }

    #[test]
    fn only_what_is_traced_may_be_larger_than_memory() {
        let large = Overrides {
            size: Some(Size::new(16_384, 16_384).unwrap()),
            ..Overrides::default()
        };
        let paint = |settings: &Settings, _: &dyn crate::Progress| Image::black(settings.size);
        assert!(large.settings(&scene()).is_ok());
        assert!(large.settings(&Scene::opened("test", "", paint)).is_ok());
        let refused = large.settings(&Scene::painted("test", "", paint));
        assert!(matches!(refused, Err(Error::TooLarge { .. })));
    }

    #[test]
    fn a_bound_for_the_error_makes_the_samples_the_most_of_a_pixel() {
        let mut bounded = Overrides {
            max_error: Some(0.002),
            ..Overrides::default()
        };
        let settings = bounded.settings(&scene()).unwrap();
        assert_eq!((settings.max_error, settings.samples), (Some(0.002), 1024));
        // No grid is asked for.
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
    fn work_is_left_out_only_where_scene_and_flag_let_it() {
        let omits = |omit, no_omit| {
            let scene = scene().with_defaults(Settings {
                omit,
                ..Settings::default()
            });
            let flags = Overrides {
                no_omit,
                ..Overrides::default()
            };
            flags.settings(&scene).unwrap().omit
        };
        assert!(omits(true, false) && !omits(true, true));
        assert!(!omits(false, false) && !omits(false, true));
    }

    #[test]
    fn flags_that_change_nothing_are_named() {
        let paint = |settings: &Settings, _: &dyn crate::Progress| Image::black(settings.size);
        let all = Overrides {
            size: Some(Size::COURSE),
            samples: Some(4),
            sampling: Some(Sampling::Random),
            max_error: Some(0.5),
            seed: Some(1),
            depth: Some(2),
            open: Some("a.png".into()),
            ..Overrides::default()
        };
        let of_samples = ["--samples", "--sampling", "--max-error", "--seed"];
        for (scene, before, after) in [
            (
                Scene::painted("", "", paint),
                &[][..],
                &["--depth", "--open"][..],
            ),
            (Scene::opened("", "", paint), &["--size"], &["--depth"]),
        ] {
            let expected = [before, &of_samples, after].concat();
            assert_eq!(all.unheeded(scene.heeds), expected);
            assert!(Overrides::default().unheeded(scene.heeds).is_empty());
        }
        assert_eq!(all.unheeded(scene().heeds), ["--depth", "--open"]);
        assert_eq!(all.unheeded(scene().reflecting().heeds), ["--open"]);
    }
}
