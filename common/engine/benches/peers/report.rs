//! The table of all figures, whose first columns are the table of the book.

use crate::program::{BUILD, Figures, MEMORY, PROGRAMS, Program, TOTAL, TRACE};
use crate::support::scene::Scene;

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

/// Prints the row of a scene: the figures of all programs on each number of threads.
pub fn row(scene: &Scene, figures: &[[Figures; 3]]) {
    let (name, about) = (scene.name, scene.about);
    print!("| ![{name}](pictures/peers-{name}.png) | {about} |");
    let cell = |number: &dyn Fn(&[Figures; 3]) -> f64| {
        let numbers = figures.iter().map(number);
        let numbers = numbers.filter(|number| number.is_finite());
        let numbers: Vec<_> = numbers.map(|number| format!("{number:.1}")).collect();
        print!(" {} |", numbers.join(" / "));
    };
    for figure in [TRACE, TOTAL, MEMORY] {
        for program in [1, 2] {
            cell(&|of| of[program][figure] / of[0][figure]);
        }
    }
    for (figure, unit) in [(BUILD, 1e-3), (TRACE, 1e-3), (MEMORY, 1024.0)] {
        cell(&|of| of[0][figure] / unit);
    }
    for program in [1, 2] {
        match difference(scene, &PROGRAMS[program]) {
            Some([fraction, mean]) if figures[0][program][TRACE] > 0.0 => {
                print!(" {fraction:.1} | {mean:.1} |");
            }
            _ => print!(" | |"),
        }
    }
    println!();
}

/// The percentage of pixels that differ from ours by more than 8 of 255 in any channel, and the
/// mean difference of the channels: times can be compared only where the pictures are the same.
fn difference(scene: &Scene, other: &Program) -> Option<[f64; 2]> {
    let ours = PROGRAMS[0].picture(scene).ok()?;
    let other = other.picture(scene).ok()?;
    let (mut different, mut sum) = (0, 0.0);
    for (a, b) in ours.pixels().iter().zip(other.pixels()) {
        let apart = (*a - *b).channels().map(|channel| 255.0 * channel.abs());
        different += usize::from(apart.iter().any(|channel| *channel > 8.0));
        sum += apart.iter().sum::<f64>();
    }
    Some([100.0 * different as f64, sum / 3.0].map(|sum| sum / ours.pixels().len() as f64))
}
