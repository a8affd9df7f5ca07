//! The table of all figures, and the table of the book.

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
    numbers.push(ours.best[MEMORY] / 1024.0);
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
