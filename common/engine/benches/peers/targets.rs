//! The targets of the engine, and the scenes that miss them.

use std::fmt::Write;

use crate::measurement::{Comparison, Figure};
use crate::table::{PEAK, TOTAL, TRACE};

/// How many times our figure POV-Ray's and Tachyon's should be, at least.
struct Target {
    name: &'static str,
    figure: Figure,
    ratios: [f64; 2],
    /// Of scenes whose rays are incoherent.
    of_incoherent: [f64; 2],
}

impl Target {
    const fn same(name: &'static str, figure: Figure, ratio: f64) -> Self {
        Self {
            name,
            figure,
            ratios: [ratio; 2],
            of_incoherent: [ratio; 2],
        }
    }
}

const TARGETS: [Target; 5] = [
    Target {
        name: "trace time of POV-Ray 5 times ours (incoherent: 4), of Tachyon 1.5 (1.2)",
        figure: TRACE,
        ratios: [5.0, 1.5],
        of_incoherent: [4.0, 1.2],
    },
    Target {
        name: "trace time of POV-Ray 10 times ours, of Tachyon 3",
        figure: TRACE,
        ratios: [10.0, 3.0],
        of_incoherent: [10.0, 3.0],
    },
    Target::same("total time of both at least ours", TOTAL, 1.0),
    Target::same("memory of both at least ours", PEAK, 1.0),
    Target::same("memory of both at least ours / 1.3", PEAK, 1.0 / 1.3),
];

/// Only where rendering takes longer is the gain of two threads judged, in seconds.
const LONG: f64 = 0.05;
const GAIN_OF_TWO_THREADS: f64 = 1.9;

/// A line for each target and number of threads.
pub fn summary(comparisons: &[Comparison]) -> String {
    let mut text = String::new();
    let mut threads: Vec<_> = comparisons.iter().map(|c| c.threads).collect();
    threads.sort_unstable();
    threads.dedup();
    for target in &TARGETS {
        for threads in &threads {
            let of_threads = comparisons.iter().filter(|c| c.threads == *threads);
            let compared = of_threads.filter(|c| (1..3).any(|i| c.ratio(i, TRACE).is_some()));
            let judged = compared.map(|c| (c, misses(target, c)));
            let name = format!("{}, threads: {threads}", target.name);
            line(&mut text, &name, judged);
        }
    }
    let pairs = comparisons.windows(2).filter_map(gain);
    let judged = pairs.map(|(c, gain)| {
        let misses = gain < GAIN_OF_TWO_THREADS;
        (c, misses.then(|| format!("{gain:.2}")))
    });
    let name = format!("two threads at least {GAIN_OF_TWO_THREADS} times as fast as one");
    line(&mut text, &name, judged);
    text
}

/// A line that counts the scenes without a miss, and lists the others; none without scenes.
fn line<'a>(
    text: &mut String,
    name: &str,
    judged: impl Iterator<Item = (&'a Comparison<'a>, Option<String>)>,
) {
    let (mut reached, mut all, mut missed) = (0, 0, Vec::new());
    for (comparison, miss) in judged {
        all += 1;
        match miss {
            Some(miss) => missed.push(format!("{} ({miss})", comparison.description.name)),
            None => reached += 1,
        }
    }
    if all == 0 {
        return;
    }
    let _ = write!(text, "- {name}: {reached} of {all}");
    if !missed.is_empty() {
        let _ = write!(text, "; not {}", missed.join(", "));
    }
    text.push('\n');
}

/// The ratios below the target, if there are any.
fn misses(target: &Target, comparison: &Comparison) -> Option<String> {
    let needed = if comparison.description.is_incoherent {
        target.of_incoherent
    } else {
        target.ratios
    };
    let ratios = [1, 2].map(|i| comparison.ratio(i, target.figure));
    let names = ["POV-Ray", "Tachyon"];
    let missed = names.iter().zip(ratios).zip(needed);
    let missed = missed.filter_map(|((name, ratio), needed)| {
        let ratio = ratio.filter(|ratio| *ratio < needed)?;
        Some(format!("{name} {ratio:.2}"))
    });
    let missed: Vec<_> = missed.collect();
    (!missed.is_empty()).then(|| missed.join(", "))
}

/// How many times as fast a scene is on two threads, from its rows for one and for two.
fn gain<'a>(pair: &'a [Comparison<'a>]) -> Option<(&'a Comparison<'a>, f64)> {
    let [one, two] = pair else { return None };
    let same = one.description.name == two.description.name;
    let [long, short] = [one, two].map(|c| c.figure(0, TRACE));
    let is_pair = same && (one.threads, two.threads) == (1, 2) && long? > LONG;
    is_pair.then_some((one, long? / short?))
}
