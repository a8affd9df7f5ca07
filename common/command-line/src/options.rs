//! The flags that change how a scene is rendered.

use std::fmt::Display;
use std::ops::RangeInclusive;
use std::path::PathBuf;
use std::str::FromStr;

use common::{Error, Renderer, Sampling, Scene, Settings, Size, Transfer, UsedSettings};

use crate::named::{SAMPLINGS, TRANSFERS, by_name};

/// The flags that replace a scene's defaults.
#[derive(Clone, Debug, Default, clap::Args)]
pub struct Options {
    /// Width and height in pixels [default: the scene's]
    #[arg(long, value_name = "WxH", allow_hyphen_values = true)]
    size: Option<Size>,

    /// Samples per pixel [default: the scene's]
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = whole(1..=1_000_000_u32))]
    samples: Option<u32>,

    /// Where samples lie [default: center for one sample, else stratified]
    #[arg(long, value_name = "HOW", value_parser = by_name(SAMPLINGS))]
    sampling: Option<Sampling>,

    /// Take samples where they are needed, until new samples show with 95 % confidence
    /// that the picture's root mean square error is at most this, such as 1/510; of a
    /// pixel at most the --samples [default: 1024], but at least 4. Not promised: the
    /// error of any single pixel
    #[arg(long, value_name = "E", allow_negative_numbers = true, value_parser = error_bound, conflicts_with = "sampling")]
    max_error: Option<f64>,

    /// Selects the random numbers [default: 0]
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = whole(0..=u64::MAX))]
    seed: Option<u64>,

    /// Surfaces that a ray may hit in turn; 1 shows no reflection [default: the scene's]
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = whole(1..=Settings::MAX_DEPTH))]
    depth: Option<u32>,

    /// Threads to render with [default: one for each core]
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = whole(1..=1024_u16))]
    threads: Option<u16>,

    /// Curve between light and the values in the file
    #[arg(long, value_name = "CURVE", value_parser = by_name(TRANSFERS), default_value = "linear")]
    pub transfer: Transfer,

    /// Render with the fast renderer; the picture is the same
    #[arg(long, conflicts_with = "no_omit")]
    pub fast: bool,

    /// Do also the work that cannot change the picture
    #[arg(long)]
    no_omit: bool,

    /// The picture that show-image opens (PNG, JPEG or BMP)
    #[arg(long, value_name = "FILE")]
    pub open: Option<PathBuf>,
}

/// Most samples of a pixel in adaptive sampling if `--samples` is not given.
const MAX_ADAPTIVE_SAMPLES: u32 = 1024;
/// Most samples whose steps `explain` writes down: each takes about 10 kB.
pub const MAX_EXPLAINED_SAMPLES: u32 = 4096;
/// Most samples that a click follows: of more, one in the middle stands for all.
pub const MAX_CLICKED_SAMPLES: u32 = 16;

/// Reads a whole number of this range.
pub fn whole<T>(
    range: RangeInclusive<T>,
) -> impl Fn(&str) -> Result<T, String> + Clone + Send + Sync
where
    T: FromStr + PartialOrd + Display + Clone + Send + Sync,
{
    move |text| match text.parse() {
        Ok(number) if range.contains(&number) => Ok(number),
        _ => Err(format!(
            "a whole number from {} to {} is needed",
            range.start(),
            range.end()
        )),
    }
}

/// Reads a number or a fraction, above 0 and at most 1.
fn error_bound(text: &str) -> Result<f64, String> {
    let (numerator, denominator) = text.split_once('/').unwrap_or((text, "1"));
    let [numerator, denominator] = [numerator, denominator].map(|n| n.trim().parse::<f64>());
    match (numerator, denominator) {
        (Ok(n), Ok(d)) if n / d > 0.0 && n / d <= 1.0 => Ok(n / d),
        _ => Err("a number above 0 and at most 1 is needed, such as 1/510 or 0.002".to_owned()),
    }
}

/// Checks that this sampling allows this number of samples.
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

impl Options {
    /// The threads to render with.
    pub fn thread_pool(&self) -> Result<rayon::ThreadPool, Error> {
        // 0 stands for one per core.
        let threads = self.threads.unwrap_or(0).into();
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
        Ok(pool.build()?)
    }

    /// The settings for `scene`: the flags that were given, else its defaults.
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
        Ok(Settings {
            size,
            samples: match self.max_error {
                Some(_) => self.samples.unwrap_or(MAX_ADAPTIVE_SAMPLES),
                None => samples,
            },
            sampling,
            max_error,
            seed: self.seed.unwrap_or(defaults.seed),
            depth: self.depth.unwrap_or(defaults.depth),
            renderer: match (self.fast, self.no_omit) {
                (true, _) => Renderer::Engine,
                (false, true) => Renderer::NoOmissions,
                (false, false) => defaults.renderer,
            },
            omissions: None,
            transfer: self.transfer,
            file: self.open.clone().or_else(|| defaults.file.clone()),
            edits: defaults.edits,
        })
    }

    /// The flags that were given although they do not change the picture of a scene
    /// that uses these settings.
    pub fn unused(&self, uses: UsedSettings, settings: &Settings) -> Vec<&'static str> {
        let sampling = !uses.sampling;
        let is_random = settings.sampling.is_random() || settings.max_error.is_some();
        [
            ("--size", self.size.is_some() && !uses.size),
            ("--samples", self.samples.is_some() && sampling),
            ("--sampling", self.sampling.is_some() && sampling),
            ("--max-error", self.max_error.is_some() && sampling),
            ("--seed", self.seed.is_some() && (sampling || !is_random)),
            ("--fast", self.fast && sampling),
            ("--no-omit", self.no_omit && sampling),
            ("--depth", self.depth.is_some() && !uses.depth),
            ("--open", self.open.is_some() && !uses.file),
        ]
        .into_iter()
        .filter_map(|(flag, unused)| unused.then_some(flag))
        .collect()
    }
}

#[cfg(test)]
mod tests;
