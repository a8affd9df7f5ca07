//! How many times as fast a program is with more threads.

use std::fmt::Write;
use std::thread::available_parallelism;

use common::Median;
use judge::pictures::{RequestedPicture, Run};

use super::OwnProgram;
use crate::told;

impl OwnProgram {
    /// Times a picture whose samples are threads, in turns, and returns a table.
    pub fn speed_up(&self, picture: &RequestedPicture) -> Result<String, String> {
        let mut seconds = vec![Vec::new(); picture.samples.len()];
        for _ in 0..Median::ROUNDS {
            for (seconds, threads) in seconds.iter_mut().zip(&picture.samples) {
                let run = Run {
                    scene: picture.scene.clone(),
                    samples: *threads,
                };
                let about = format!(": {} to time it", run.words());
                let drawn = self.draw(picture, &run, &mut told(&about))?;
                seconds.push(drawn.seconds);
            }
        }
        let mut table = format!(
            "{}, the median of {} runs in turns, and its interval of 95 %\n",
            picture.scene,
            Median::ROUNDS
        );
        table += "threads   seconds   times as fast\n";
        for (threads, of_threads) in picture.samples.iter().zip(&seconds) {
            let median = Median::of(of_threads.clone()).value;
            let Median { low, value, high } = Median::of_quotients(&seconds[0], of_threads);
            let _ = writeln!(
                table,
                "{threads:>7}{median:>10.2}   {value:.2} ({low:.2} to {high:.2})"
            );
        }
        let _ = match available_parallelism() {
            Ok(cores) if cores.get() > 1 => writeln!(
                table,
                "This computer has {cores} cores. A program that is more than {cores} times as fast has taken time from others."
            ),
            _ => writeln!(
                table,
                "This computer has one core, on which no thread gains time."
            ),
        };
        Ok(table)
    }
}
