//! Does `--max-error` keep its promise? True errors of pictures of many kinds.
//!
//! ```console
//! $ cargo bench -p engine --bench error_bound                       all kinds, some minutes
//! $ cargo bench -p engine --bench error_bound -- needles --seeds 1  one kind, one seed
//! ```
//!
//! Each kind has three variants, drawn at random, each of which is rendered at two sizes with
//! four bounds and three seeds. The true error is measured against 4,050 stratified samples a
//! pixel, whose noise is taken off, and printed as a multiple of the bound. A picture is
//! *silent* if it is above its bound and its report does not say that it may be; *said* if it
//! does. A promise is *missed* if the error is above the one that the report prints, without a
//! condition; *error / U* is the median of the error relative to that. Samples are those of a pixel, and beside them those that stratified sampling of all
//! pixels takes to the same true error; all in the median.

#[path = "error_bound/kinds.rs"]
mod kinds;
#[path = "error_bound/pictures.rs"]
mod pictures;
#[path = "error_bound/rooms.rs"]
mod rooms;
mod support;
#[path = "error_bound/things.rs"]
mod things;

use std::sync::{Mutex, PoisonError};

use clap::Parser;
use common::{Color, Error, Image, SamplingReport, Settings, Size};
use measure::experiment::{Curve, Errors, Point, Times};

use crate::kinds::{Kind, kinds};
use crate::support::{Grid, print_head, print_row};

/// Compares the true errors of pictures with their bounds.
#[derive(Parser)]
struct Options {
    /// The kinds to render, by parts of their names; all if none is named.
    kinds: Vec<String>,
    /// Widths and heights of the pictures.
    #[arg(long, value_delimiter = ',', default_value = "64x48,160x120")]
    sizes: Vec<Size>,
    /// Pictures with each bound, with different random numbers.
    #[arg(long, default_value_t = 3)]
    seeds: u64,
    /// The references have 2 x this x this stratified samples per pixel.
    #[arg(long, default_value_t = 45)]
    side: u32,
    /// Given by `cargo bench`, but not by `cargo test`, which is to render nothing.
    #[arg(long, hide = true)]
    bench: bool,
}

const BOUNDS: [f64; 4] = [1.0 / 64.0, 1.0 / 128.0, 1.0 / 255.0, 1.0 / 510.0];

fn main() -> Result<(), Error> {
    let options = Options::parse();
    if !options.bench {
        return Ok(());
    }
    print_head("kind", &COLUMNS);
    let mut all = Vec::new();
    for kind in &kinds() {
        if !options.names(kind) {
            continue;
        }
        let first = all.len();
        for size in &options.sizes {
            for variant in 0..3 {
                let subject = Subject::new(kind, variant, *size, options.side)?;
                for bound in BOUNDS {
                    for seed in 0..options.seeds {
                        all.push(subject.trial(bound, seed)?);
                    }
                }
            }
        }
        print_row(kind.name, figures(&all[first..]));
    }
    print_row("all", figures(&all));
    let gain = median(all.iter().map(|trial| trial.stratified / trial.samples));
    println!("stratified sampling takes {gain:.2} times as many samples, in the median");
    Ok(())
}

impl Options {
    /// Whether a kind is to be rendered.
    fn names(&self, kind: &Kind) -> bool {
        let mut names = self.kinds.iter();
        self.kinds.is_empty() || names.any(|name| kind.name.contains(name.as_str()))
    }
}

/// The columns of the table.
const COLUMNS: [&str; 11] = [
    "pictures", "silent", "said", "if dark", "missed", "worst", "error/U", "largest", "median",
    "samples", "strat.",
];

/// The figures of a row.
fn figures(trials: &[Trial]) -> [f64; COLUMNS.len()] {
    let (mut silent, mut said, mut conditional, mut largest) = (0, 0, 0, 0.0);
    let (mut missed, mut worst) = (0, 0.0);
    for trial in trials {
        let is_above = trial.error > 1.0;
        silent += u32::from(is_above && !trial.is_said);
        said += u32::from(is_above && trial.is_said);
        conditional += u32::from(trial.is_conditional);
        largest = f64::max(largest, trial.error);
        if !trial.is_conditional {
            missed += u32::from(trial.of_printed > 1.0);
            worst = f64::max(worst, trial.of_printed);
        }
    }
    [
        trials.len() as f64,
        silent.into(),
        said.into(),
        conditional.into(),
        missed.into(),
        worst,
        median(trials.iter().map(|trial| trial.of_printed)),
        largest,
        median(trials.iter().map(|trial| trial.error)),
        median(trials.iter().map(|trial| trial.samples)),
        median(trials.iter().map(|trial| trial.stratified)),
    ]
}

fn median(values: impl Iterator<Item = f64>) -> f64 {
    let mut values: Vec<_> = values.collect();
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}

/// The true root mean square error of a picture as a fraction of the bound, whether its report
/// says that it may be above, and samples of a pixel: its own and those of stratified sampling.
struct Trial {
    error: f64,
    /// The error as a fraction of the one that the report prints.
    of_printed: f64,
    is_said: bool,
    /// Whether the report holds only for light up to the brightest seen.
    is_conditional: bool,
    samples: f64,
    stratified: f64,
}

/// A variant of a kind at a size, two independent pictures of many samples, and the errors of
/// stratified sampling against the samples of a pixel.
struct Subject<'a> {
    kind: &'a Kind,
    variant: u32,
    settings: Settings,
    references: [Image; 2],
    stratified: Curve<'static>,
}

impl<'a> Subject<'a> {
    fn new(kind: &'a Kind, variant: u32, size: Size, side: u32) -> Result<Self, Error> {
        let settings = Settings {
            size,
            samples: 1024,
            ..Settings::default()
        };
        let renderer = kind.prepare(variant, &settings);
        let picture = |side, seed: u64| {
            let seed = Some(0x5EED + seed);
            renderer.render(&Grid { side, seed }, &settings, &())
        };
        let references = [picture(side, 1)?, picture(side, 2)?];
        let mut points = Vec::new();
        for side in [1, 2, 3, 4, 6, 9, 13, 19] {
            let mut errors = Vec::new();
            // Where few samples leave much to chance, it is the mean of several pictures.
            for seed in 3..3 + u64::from(16 / side).clamp(1, 4) {
                errors.push(error(&references, &picture(side, seed)?));
            }
            let samples = f64::from(side * side);
            points.push(Point {
                parameter: samples,
                work: samples,
                errors: Errors::of(errors),
                times: Times::of(|| ()),
            });
        }
        Ok(Self {
            kind,
            variant,
            settings,
            references,
            stratified: Curve::new("stratified", points),
        })
    }

    /// Renders the picture with this bound.
    fn trial(&self, bound: f64, seed: u64) -> Result<Trial, Error> {
        let settings = Settings {
            max_error: Some(bound),
            seed,
            ..self.settings.clone()
        };
        let renderer = self.kind.prepare(self.variant, &settings);
        let sampled = Mutex::new(SamplingReport::default());
        let image = renderer.render(&Grid::ONE, &settings, &sampled)?;
        let sampled = sampled.into_inner().unwrap_or_else(PoisonError::into_inner);
        let error = error(&self.references, &image);
        let stratified = self.stratified.work_to_reach(error);
        let is_conditional = sampled.brightest < sampled.max_radiance.min(self.kind.brightest);
        Ok(Trial {
            error: error / bound,
            of_printed: error / sampled.max_error(),
            is_said: sampled.misses(Some(bound)) || is_conditional,
            is_conditional,
            samples: sampled.samples as f64 / sampled.pixels as f64,
            stratified: stratified.map_or(f64::INFINITY, |reached| reached.work),
        })
    }
}

/// The root mean square error of a picture. The product of the differences from two
/// independent references contains none of their noise, on average.
fn error(references: &[Image; 2], image: &Image) -> f64 {
    let [a, b] = references.each_ref().map(Image::pixels);
    let mut sum = 0.0;
    for ((pixel, a), b) in image.pixels().iter().zip(a).zip(b) {
        let [pixel, a, b] = [pixel, a, b].map(shown);
        for product in ((a - pixel) * (b - pixel)).channels() {
            sum += product;
        }
    }
    (sum.max(0.0) / (3 * a.len()) as f64).sqrt()
}

/// A colour as a screen shows it.
fn shown(color: &Color) -> Color {
    color.map(|channel| channel.clamp(0.0, 1.0))
}
