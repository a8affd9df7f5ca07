//! The table of all figures, whose first columns are the table of the book.

use crate::program::{BUILD, MEMORY, Run, TOTAL, TRACE};

/// A scene on a number of threads: the runs of all programs, ours first.
pub type Comparison = [Run; 3];

/// Prints the head of the table.
pub fn head() {
    println!("Figures of POV-Ray and Tachyon are multiples of ours. Pixels differ from ours if");
    println!("a channel does by more than 8 of 255. Numbers of a cell are for 1, 2 ... threads.\n");
    let others = "trace: POV-Ray | Tachyon | total: POV-Ray | Tachyon | memory: POV-Ray | Tachyon";
    let ours = "build ms | trace ms | MiB | POV-Ray differs % | mean | Tachyon differs % | mean";
    println!(
        "| | scene | {others} | {ours} |\n|---|---|{}",
        "---:|".repeat(13)
    );
}

/// Prints the row of a scene on all numbers of threads.
pub fn row(comparisons: &[Comparison]) {
    let (name, about) = (comparisons[0][0].scene.name, comparisons[0][0].scene.about);
    print!("| ![{name}](pictures/peers-{name}.png) | {about} |");
    let cell = |number: &dyn Fn(&Comparison) -> f64| {
        let numbers = comparisons
            .iter()
            .map(number)
            .filter(|number| number.is_finite());
        let numbers: Vec<_> = numbers.map(|number| format!("{number:.1}")).collect();
        print!(" {} |", numbers.join(" / "));
    };
    for figure in [TRACE, TOTAL, MEMORY] {
        for program in [1, 2] {
            cell(&|runs| runs[program].best[figure] / runs[0].best[figure]);
        }
    }
    for (figure, unit) in [(BUILD, 1e-3), (TRACE, 1e-3), (MEMORY, 1024.0)] {
        cell(&|runs| runs[0].best[figure] / unit);
    }
    for program in [1, 2] {
        cell(&|runs| difference(&runs[0], &runs[program])[0]);
        cell(&|runs| difference(&runs[0], &runs[program])[1]);
    }
    println!();
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
