//! Does `--max-error` keep its promise? True errors of pictures of many kinds.
//!
//! ```console
//! $ cargo bench -p engine --bench error_bound                    all kinds, some minutes
//! $ cargo bench -p engine --bench error_bound -- needles --seeds 1  one kind, one seed
//! ```
//!
//! Each kind has three variants, drawn at random, each of which is rendered at two sizes with
//! four bounds and three seeds. The true error is measured against 4,050 stratified samples a
//! pixel, whose noise is taken off. A picture is *silent* if it is above its bound and its
//! report does not say that it may be. Six kinds were kept aside while the sampler was tuned:
//! foliage, crossing wires, gravel, stars at dusk, spheres on a mirror and many far spheres.

#[path = "error_bound/kinds.rs"]
mod kinds;
#[path = "../src/adaptive/random.rs"]
mod random;
#[path = "error_bound/scenes.rs"]
mod scenes;
#[path = "error_bound/stratified.rs"]
mod stratified;
#[path = "error_bound/trial.rs"]
mod trial;
#[path = "error_bound/tuned.rs"]
mod tuned;
#[path = "error_bound/unseen.rs"]
mod unseen;

use clap::Parser;
use common::{Error, Size};

use crate::kinds::Kind;
use crate::trial::{Subject, Trial};

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
    /// The references have 2 x this x this stratified samples a pixel.
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
    println!(
        "| kind | pictures | silent | said | largest error of the bound | median | samples a pixel, median | stratified |"
    );
    println!("|---|---|---|---|---|---|---|---|");
    let mut all = Vec::new();
    let kinds = tuned::TUNED
        .iter()
        .chain(&unseen::UNSEEN)
        .chain(&scenes::SCENES);
    for kind in kinds {
        let is_named = |name: &String| kind.name.contains(name.as_str());
        if options.kinds.is_empty() || options.kinds.iter().any(is_named) {
            let trials = trials(kind, &options)?;
            println!("{}", row(kind.name, &trials));
            all.extend(trials);
        }
    }
    println!("{}", row("all", &all));
    let ratios = all.iter().map(|trial| trial.uniform / trial.samples);
    println!(
        "stratified sampling takes {:.2} times as many samples to the same true error, in the median",
        median(ratios)
    );
    Ok(())
}

fn trials(kind: &Kind, options: &Options) -> Result<Vec<Trial>, Error> {
    let mut trials = Vec::new();
    for size in &options.sizes {
        for variant in 0..3 {
            let subject = Subject::new(kind, variant, *size, options.side);
            let uniform = subject.uniform();
            for bound in BOUNDS {
                for seed in 0..options.seeds {
                    trials.push(subject.trial(bound, seed, &uniform)?);
                }
            }
        }
    }
    Ok(trials)
}

fn median(values: impl Iterator<Item = f64>) -> f64 {
    let mut values: Vec<_> = values.collect();
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}

fn row(name: &str, trials: &[Trial]) -> String {
    let silent = trials.iter().filter(|trial| trial.is_silent()).count();
    let above = trials.iter().filter(|trial| trial.error > 1.0).count();
    let largest = trials.iter().map(|trial| trial.error).fold(0.0, f64::max);
    let [error, samples, uniform] = [
        median(trials.iter().map(|trial| trial.error)),
        median(trials.iter().map(|trial| trial.samples)),
        median(trials.iter().map(|trial| trial.uniform)),
    ];
    format!(
        "| {name} | {} | {silent} | {} | {largest:.2} | {error:.2} | {samples:.1} | {uniform:.1} |",
        trials.len(),
        above - silent
    )
}
