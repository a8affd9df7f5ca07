//! The table of all figures, the table of the book, and the targets of the engine.

use crate::program::{BUILD, MEMORY, Run, TOTAL, TRACE};
use crate::support::{print_head, print_row};

/// A scene on a number of threads: the runs of all programs, ours first.
pub type Comparison = [Run; 3];

/// How many times our figure that of another program is.
fn ratio(runs: &Comparison, program: usize, figure: usize) -> f64 {
    runs[program].best[figure] / runs[0].best[figure]
}

/// Prints the head of the table of all figures.
pub fn head() {
    println!("Figures of POV-Ray and Tachyon are multiples of ours; pixels differ from ours if");
    println!("a channel does by more than 8 of 255, and the mean is that of all channels.\n");
    let ours = ["threads", "build ms", "trace ms", "MiB"];
    let others = ["trace", "trace", "total", "total", "memory", "memory"];
    let pictures = ["differ %", "mean", "differ %", "mean"];
    print_head("scene", &[&ours[..], &others, &pictures].concat());
}

/// Prints our figures, and how many times as much the two others take.
pub fn row(runs: &Comparison) {
    let ours = &runs[0];
    let mut numbers = vec![ours.threads.into()];
    numbers.extend([1e3 * ours.best[BUILD], 1e3 * ours.best[TRACE]]);
    numbers.push(ours.best[MEMORY] / 1_048_576.0);
    for figure in [TRACE, TOTAL, MEMORY] {
        numbers.extend([1, 2].map(|program| ratio(runs, program, figure)));
    }
    numbers.extend(runs[1..].iter().flat_map(|other| difference(ours, other)));
    print_row(ours.scene.name, numbers);
}

/// The percentage of pixels that differ by more than 8 of 255 in any channel, and the mean
/// difference of the channels: times can be compared only where the pictures are the same.
fn difference(ours: &Run, other: &Run) -> [f64; 2] {
    let (Ok(a), Ok(b), true) = (ours.picture(), other.picture(), other.best[TRACE] > 0.0) else {
        return [f64::NAN; 2];
    };
    let (mut different, mut sum) = (0, 0.0);
    for (a, b) in a.pixels().iter().zip(b.pixels()) {
        let apart = (*a - *b).channels().map(|channel| 255.0 * channel.abs());
        different += usize::from(apart.iter().any(|channel| *channel > 8.0));
        sum += apart.iter().sum::<f64>();
    }
    [100.0 * different as f64, sum / 3.0].map(|sum| sum / a.pixels().len() as f64)
}

/// Prints the table of the book: the ratios of POV-Ray and Tachyon. A cell with two numbers
/// is for one thread and for two, any other for one.
pub fn book(comparisons: &[Comparison]) {
    let heads = "trace: POV-Ray | Tachyon | total: POV-Ray | Tachyon | memory: POV-Ray | Tachyon";
    println!("\n| | scene | {heads} |\n|---|---|---:|---:|---:|---:|---:|---:|");
    for both in comparisons.chunk_by(|a, b| a[0].scene.name == b[0].scene.name) {
        let (name, about) = (both[0][0].scene.name, both[0][0].scene.about);
        print!("| ![{name}](pictures/peers-{name}.png) | {about} |");
        for (comparisons, figure) in [(both, TRACE), (&both[..1], TOTAL), (&both[..1], MEMORY)] {
            for program in [1, 2] {
                let ratios = comparisons.iter().map(|runs| ratio(runs, program, figure));
                let ratios = ratios.filter(|ratio| ratio.is_finite());
                let cells: Vec<_> = ratios.map(|ratio| format!("{ratio:.1}")).collect();
                print!(" {} |", cells.join(" / "));
            }
        }
        println!();
    }
}

/// The least that POV-Ray's and Tachyon's figures should be, as multiples of ours.
const TARGETS: [(&str, usize, [f64; 2]); 4] = [
    ("trace time", TRACE, [5.0, 1.5]),
    ("trace time", TRACE, [10.0, 3.0]),
    ("total time", TOTAL, [1.0, 1.0]),
    ("memory", MEMORY, [1.0, 1.0]),
];
const GAIN_OF_TWO_THREADS: f64 = 1.9;

/// Prints which scenes miss the targets, and on how many threads. Alone there is only the last.
pub fn targets(comparisons: &[Comparison], alone: bool) {
    for (name, figure, least) in TARGETS.into_iter().filter(|_| !alone) {
        let [povray, tachyon] = least;
        print!("\n- {name} of POV-Ray {povray} times ours, of Tachyon {tachyon}; missed by:");
        for runs in comparisons {
            for i in [1, 2] {
                let ratio = ratio(runs, i, figure);
                if ratio < least[i - 1] {
                    let (scene, threads) = (runs[0].scene.name, runs[0].threads);
                    print!(" {scene} ({threads}: {} {ratio:.2})", runs[i].program.name);
                }
            }
        }
    }
    print!("\n- two threads {GAIN_OF_TWO_THREADS} times as fast as one; missed by:");
    for pair in comparisons.windows(2) {
        let [one, two] = [&pair[0][0], &pair[1][0]];
        let is_pair = one.scene.name == two.scene.name && [one.threads, two.threads] == [1, 2];
        let gain = one.best[TRACE] / two.best[TRACE];
        // Shorter times are those of starting threads.
        if is_pair && one.best[TRACE] > 0.05 && gain < GAIN_OF_TWO_THREADS {
            print!(" {} ({gain:.2})", one.scene.name);
        }
    }
    println!();
}
