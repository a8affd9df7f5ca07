//! The table of all figures.

use crate::program::{Figures, OfPrograms, PROGRAMS, Program};
use crate::support::scene::Scene;

/// Prints the head of the table.
pub fn head() {
    println!("Figures of POV-Ray and Tachyon are multiples of ours. Pixels differ from ours if");
    println!("a channel does by more than 8 of 255. Numbers of a cell are for 1, 2 ... threads.\n");
    let others = "trace: POV-Ray | Tachyon | total: POV-Ray | Tachyon | memory: POV-Ray | Tachyon";
    let ours = "build ms | trace ms | MiB | POV-Ray differs % | mean | Tachyon differs % | mean";
    println!("| | scene | {others} | {ours} |");
    println!("|---|---|{}", "---:|".repeat(13));
}

/// The index of our figures; those of the other programs follow.
const OURS: usize = 0;
const OTHERS: [usize; 2] = [1, 2];

/// Prints the row of a scene: the figures of all programs on each number of threads.
pub fn row(scene: &Scene, figures: &[OfPrograms]) {
    let (name, about) = (scene.name, scene.about);
    print!("| {name} | {about} |");
    print_quotients(figures, |of| of.trace);
    print_quotients(figures, |of| of.total);
    print_quotients(figures, |of| of.memory);
    print_ours(figures, |of| 1e3 * of.build);
    print_ours(figures, |of| 1e3 * of.trace);
    print_ours(figures, |of| of.memory / 1024.0);
    for program in OTHERS {
        match Difference::of(scene, &PROGRAMS[program]) {
            Some(Difference { percent, mean }) if figures[0][program].trace > 0.0 => {
                print!(" {percent:.1} | {mean:.1} |");
            }
            _ => print!(" | |"),
        }
    }
    println!();
}

/// Prints a cell of each other program: its figure in multiples of ours.
fn print_quotients(figures: &[OfPrograms], figure: fn(&Figures) -> f64) {
    for program in OTHERS {
        let quotients = figures
            .iter()
            .map(|of| figure(&of[program]) / figure(&of[OURS]));
        print_cell(quotients);
    }
}

/// Prints a cell of our own figure.
fn print_ours(figures: &[OfPrograms], figure: fn(&Figures) -> f64) {
    print_cell(figures.iter().map(|of| figure(&of[OURS])));
}

fn print_cell(numbers: impl Iterator<Item = f64>) {
    let mut words = Vec::new();
    for number in numbers {
        if number.is_finite() {
            words.push(format!("{number:.1}"));
        }
    }
    print!(" {} |", words.join(" / "));
}

/// How far a picture is from ours: times can be compared only where the pictures are the same.
struct Difference {
    /// The percentage of pixels that differ by more than 8 of 255 in any channel.
    percent: f64,
    /// The mean difference of the channels, of 255.
    mean: f64,
}

impl Difference {
    fn of(scene: &Scene, other: &Program) -> Option<Self> {
        let ours = PROGRAMS[OURS].picture(scene).ok()?;
        let other = other.picture(scene).ok()?;
        let (mut different, mut sum) = (0_u32, 0.0);
        for (a, b) in ours.pixels().iter().zip(other.pixels()) {
            let channels = (*a - *b).channels();
            let apart = channels.map(|channel| 255.0 * channel.abs());
            different += u32::from(apart.iter().any(|channel| *channel > 8.0));
            sum += apart.iter().sum::<f64>();
        }
        let pixels = ours.pixels().len() as f64;
        Some(Self {
            percent: 100.0 * f64::from(different) / pixels,
            mean: sum / 3.0 / pixels,
        })
    }
}
