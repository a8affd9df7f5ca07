//! `render --explain`: the work that the renderer leaves out, why no picture shows it, and the time
//! that all of it takes.

use std::time::{Duration, Instant};

use common::comparison::{Comparison, complete, small};
use common::omitted_work::{OmittedWork, Words};
use common::{Error, Median, Scene, Settings};

use crate::options::Options;
use crate::print::print;
use crate::processor_time::processor_time;

/// The most rounds of renderings, and the time that ends them.
const MAX_ROUNDS: usize = 25;
const MAX_TIME: Duration = Duration::from_secs(2);

/// Prints the work that the renderer leaves out in a scene.
pub fn explain(scene: &Scene, settings: &Settings, options: &Options) -> Result<(), Error> {
    let threads = options.thread_pool()?;
    threads.install(|| {
        let name = scene.name;
        if !scene.uses.sampling {
            return print(&format!(
                "{name}: nothing to leave out, because the picture takes no rays"
            ));
        }
        let settings = Settings {
            size: small(settings.size)?,
            ..settings.clone()
        };
        print(&format!("{name}, in a picture of {}:", settings.size))?;
        let comparison = Comparison::new(scene, &settings)?;
        print(&comparison.to_string())?;
        print_omitted(&OmittedWork::all(scene, &settings)?)?;
        print(&Times::measure(scene, &settings)?.in_words())?;
        print(&format!(
            "  largest difference of a channel {:.1e}",
            comparison.difference
        ))
    })
}

fn print_omitted(rows: &[OmittedWork]) -> Result<(), Error> {
    if rows.is_empty() {
        return print("  left out: nothing, because the scene needs all of it");
    }
    print("  left out:")?;
    for row in rows {
        let Words { work, because } = Words::of(row.omission);
        let counts = row.counts();
        print(&format!("    {work}: {counts}\n      because {because}"))?;
    }
    Ok(())
}

/// Seconds of the processors for renderings that took turns, so that other load on the machine
/// affects them equally.
struct Times {
    /// Of the renderer.
    renderer: Vec<f64>,
    /// Of the one that leaves out nothing.
    all: Vec<f64>,
}

impl Times {
    fn measure(scene: &Scene, settings: &Settings) -> Result<Self, Error> {
        let timed = |settings: &Settings| -> Result<f64, Error> {
            let start = processor_time();
            scene.render(settings, &())?;
            Ok(processor_time() - start)
        };
        let (complete, start) = (complete(settings), Instant::now());
        let mut times = Self {
            renderer: Vec::new(),
            all: Vec::new(),
        };
        while times.all.len() < MAX_ROUNDS && (times.all.is_empty() || start.elapsed() < MAX_TIME) {
            times.renderer.push(timed(settings)?);
            times.all.push(timed(&complete)?);
        }
        Ok(times)
    }

    /// The time of the renderer, and how many times as long the one takes that leaves out
    /// nothing, if that is more than noise.
    fn in_words(&self) -> String {
        let milliseconds = 1e3 * Median::of(self.renderer.clone()).value;
        let ratio = Median::of_quotients(&self.all, &self.renderer);
        let Median { low, value, high } = ratio;
        let everything = match ratio.noise() {
            Some(noise) => format!("everything: no difference beyond the noise of {noise}"),
            None => format!("everything takes {value:.2} times as long ({low:.2} to {high:.2})"),
        };
        format!("  processor time {milliseconds:.1} ms; {everything}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_are_compared_unless_they_differ_by_noise() {
        let of = |all: [f64; 6]| {
            let times = Times {
                renderer: vec![0.25; 6],
                all: all.into(),
            };
            times.in_words()
        };
        let slower = of([1.5, 1.0, 2.0, 1.5, 1.5, 1.5]);
        let expected =
            "  processor time 250.0 ms; everything takes 6.00 times as long (4.00 to 8.00)";
        assert_eq!(slower, expected);
        let equal = of([0.125, 0.25, 0.25, 0.25, 0.25, 0.3125]);
        assert!(equal.contains("a factor of 2.0"), "{equal}");
    }
}
