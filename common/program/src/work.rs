//! `render --explain`: the work that the renderer leaves out for a picture and what each part of it
//! would cost, and the work that it does although no picture shows it.

use std::time::{Duration, Instant};

use common::steps::StepKind;
use common::{Error, Image, Median, Omissions, Scene, Settings, Size};

use crate::comparison::{Comparison, WORK, complete};
use crate::left_out::{LeftOut, STILL_DONE, Words, measured};
use crate::options::Options;
use crate::print::{print, warn};
use crate::processor_time::processor_time;

/// All measurements of a scene take about so long at most. Where those of the whole picture would
/// take longer, a smaller picture of the scene is measured.
const LONGEST: Duration = Duration::from_secs(40);

/// The number of renderings, in times of the one that leaves out nothing, that the
/// measurements of a scene take: it is rendered for each row, twice to count and six times for
/// the time, and counting is slower.
const RENDERINGS: f64 = 100.0;

/// Renderings of a small picture are repeated more often than the others, for so long.
const SOON: Duration = Duration::from_secs(15);

/// The most rounds of renderings.
const MOST_ROUNDS: usize = 25;

/// The width of the first small picture, in pixels.
const FIRST_WIDTH: u32 = 16;

/// Prints the work that the renderer leaves out, and returns the picture; none if only a smaller
/// one was measured.
pub fn render_and_report(
    scene: &Scene,
    settings: &Settings,
    options: &Options,
) -> Result<Option<Image>, Error> {
    let threads = options.thread_pool()?;
    threads.install(|| {
        print(&format!("{}  {}", scene.name, settings.size))?;
        if !scene.uses.sampling {
            print("  nothing to leave out: the picture takes no rays")?;
            return scene.render(settings, &()).map(Some);
        }
        let start = Instant::now();
        let size = measured_size(scene, settings)?;
        let is_whole = size == settings.size;
        let factor = settings.size.pixels() as f64 / size.pixels() as f64;
        let settings = &Settings {
            size,
            ..settings.clone()
        };
        if !is_whole {
            print(&format!(
                "  estimated: {factor:.0} times the work of a picture of {size}, because the whole would \
                 take too long"
            ))?;
        }
        let comparison = Comparison::new(scene, settings)?.scaled(factor);
        print(&comparison.to_string())?;
        let rows = LeftOut::all(scene, settings)?;
        let times = Times::measure(scene, settings, &rows, start)?.scaled(factor);
        print_left_out(&rows, &times, factor)?;
        print_still_done(&comparison)?;
        print(&times.comparison())?;
        let difference = comparison.difference;
        print(&format!(
            "  largest difference of a channel {difference:.1e}"
        ))?;
        if !is_whole {
            warn("note: the picture itself is rendered without --explain");
        }
        Ok(Some(comparison.image).filter(|_| is_whole))
    })
}

/// The size of the picture that is measured: that of the settings, or one of the same shape whose
/// measurements take [`LONGEST`].
fn measured_size(scene: &Scene, settings: &Settings) -> Result<Size, Error> {
    let whole = settings.size;
    let mut width = FIRST_WIDTH.min(whole.width());
    loop {
        let size = with_width(whole, width)?;
        let start = Instant::now();
        let small = Settings {
            size,
            ..complete(settings)
        };
        scene.render(&small, &())?;
        let seconds = RENDERINGS * start.elapsed().as_secs_f64();
        let most = LONGEST.as_secs_f64();
        // The time grows as the square of the width, and not faster.
        let largest = (f64::from(width) * (most / seconds).sqrt()) as u32;
        if largest >= whole.width() {
            return Ok(whole);
        }
        // A picture of few pixels takes mostly the time that the scene takes to be prepared.
        if largest < 4 * width {
            return with_width(whole, largest.max(1));
        }
        width = largest / 2;
    }
}

/// A size of the same shape, up to the rounding to whole pixels.
fn with_width(whole: Size, width: u32) -> Result<Size, Error> {
    let height = f64::from(whole.height()) * f64::from(width) / f64::from(whole.width());
    Ok(Size::new(width, (height.round() as u32).max(1))?)
}

/// Seconds of the processors for renderings that took turns, so that other load on the machine
/// affects them equally.
struct Times {
    /// Of the renderer.
    renderer: Vec<f64>,
    /// Of the one that leaves out nothing.
    all: Vec<f64>,
    /// Of the renderer with instruments that leave out everything, and of that with each row put
    /// back, in addition to those before.
    rows: Vec<Vec<f64>>,
    /// Of the renderer with instruments that leave out everything, once more: how far it differs from
    /// the first time is noise.
    again: Vec<f64>,
}

impl Times {
    fn measure(
        scene: &Scene,
        settings: &Settings,
        rows: &[LeftOut],
        start: Instant,
    ) -> Result<Self, Error> {
        let mut all_settings = vec![
            settings.clone(),
            complete(settings),
            measured(settings, Omissions::ALL),
        ];
        all_settings.extend(rows.iter().map(|row| row.with.clone()));
        all_settings.push(measured(settings, Omissions::ALL));
        let mut seconds = vec![Vec::new(); all_settings.len()];
        for round in 0..MOST_ROUNDS {
            // Two rounds show at least whether the times differ by noise.
            let longest = if round < Median::ROUNDS {
                LONGEST
            } else {
                SOON
            };
            if round >= 2 && start.elapsed() > longest {
                break;
            }
            for (settings, seconds) in all_settings.iter().zip(&mut seconds) {
                let start = processor_time();
                scene.render(settings, &())?;
                seconds.push(processor_time() - start);
            }
        }
        let again = seconds.pop().unwrap_or_default();
        let mut seconds = seconds.into_iter();
        let mut next = || seconds.next().unwrap_or_default();
        Ok(Self {
            renderer: next(),
            all: next(),
            rows: seconds.collect(),
            again,
        })
    }

    /// The times of this many times as many pixels.
    fn scaled(mut self, factor: f64) -> Self {
        let rows = self.rows.iter_mut();
        let others = [&mut self.renderer, &mut self.all, &mut self.again];
        for seconds in rows.chain(others) {
            for seconds in seconds {
                *seconds *= factor;
            }
        }
        self
    }

    /// The milliseconds that row `i` takes, in words; beside them the noise, which is at least how
    /// far the same work differs from itself.
    fn of_row(&self, i: usize) -> String {
        let row = milliseconds(&self.rows[i], &self.rows[i + 1]);
        let same = milliseconds(&self.rows[0], &self.again);
        let noise = same.high.max(-same.low);
        let Median { low, value, high } = row;
        if value.abs() <= noise || low <= 0.0 && high >= 0.0 {
            let noise = noise.max(high).max(-low);
            return format!("no time beyond the noise of {noise:.2} ms");
        }
        let interval = format!("{value:.2} ms ({low:.2} to {high:.2})");
        if value < 0.0 {
            return format!("{interval}: to leave it out takes longer here");
        }
        interval
    }

    /// The time of the renderer, and how many times as long the one takes that leaves out
    /// nothing, if that is more than noise.
    fn comparison(&self) -> String {
        let time = Median::of(self.renderer.clone()).value;
        let ratio = Median::of_quotients(&self.all, &self.renderer);
        let Median { low, value, high } = ratio;
        match ratio.noise() {
            Some(noise) => {
                format!(
                    "  processor time {time:.3} s; everything: no difference beyond the noise of {noise}"
                )
            }
            None => format!(
                "  processor time {time:.3} s; everything takes {value:.2} times as long ({low:.2} to {high:.2})"
            ),
        }
    }
}

/// The milliseconds that renderings with more work take more than those without it.
fn milliseconds(without: &[f64], with: &[f64]) -> Median {
    let pairs = with.iter().zip(without);
    let differences = pairs.map(|(with, without)| 1e3 * (with - without));
    Median::of(differences.collect())
}

fn print_left_out(rows: &[LeftOut], times: &Times, factor: f64) -> Result<(), Error> {
    if rows.is_empty() {
        return print("  left out: nothing, because the scene needs all of it");
    }
    print("  left out, with its time on the processors, by turns with and without:")?;
    for (i, row) in rows.iter().enumerate() {
        let words = Words::of(row.omission);
        let (counts, time) = (row.counts(factor), times.of_row(i));
        print(&format!(
            "    {}: {counts}; {time}\n      because {}",
            words.work, words.because
        ))?;
    }
    Ok(())
}

/// Prints the work that the renderer does although no picture shows it.
fn print_still_done(comparison: &Comparison) -> Result<(), Error> {
    let Some(needed) = comparison.needed else {
        return Ok(());
    };
    let done = &comparison.done;
    let mut lines = Vec::new();
    for work in WORK {
        let more = done[work.kind].saturating_sub(needed[work.kind]);
        if more > 0 {
            lines.push(format!("{more} {}", work.name));
        }
        if work.kind == StepKind::Test {
            let parts = STILL_DONE.iter().filter(|(kind, _)| done[*kind] > 0);
            lines.extend(parts.map(|(kind, name)| format!("  {} {name}", done[*kind])));
        }
    }
    if lines.is_empty() {
        return Ok(());
    }
    print("  done, and not needed:")?;
    lines
        .iter()
        .try_for_each(|line| print(&format!("    {line}")))
}

#[cfg(test)]
mod tests {
    use std::thread::sleep;

    use common::steps::count;
    use common::{Color, Omission, Renderer};

    use super::*;

    /// A renderer that takes three milliseconds and two powers more if black highlights are not left
    /// out, and one that paints the picture white.
    fn scene(pause: Duration) -> Scene {
        let scene = Scene::sampled("slow", "", move |settings, _| {
            let omissions = match settings.renderer {
                Renderer::AllWork => Omissions::NONE,
                _ => settings.omissions.unwrap_or(Omissions::ALL),
            };
            if omissions.contains(Omission::BlackHighlights) {
                return Image::black(settings.size);
            }
            count(StepKind::Power, 2);
            sleep(pause * settings.size.pixels() as u32);
            Image::from_fn(settings.size, |_, _| Color::WHITE)
        });
        scene.with_defaults(Settings {
            size: Size::new(1, 1).unwrap(),
            ..Settings::default()
        })
    }

    #[test]
    fn each_row_has_its_own_times_and_the_chosen_renderer_paints_the_picture() {
        let scene = scene(Duration::from_millis(3));
        let settings = &scene.defaults;
        let image = render_and_report(&scene, settings, &Options::default()).unwrap();
        assert_eq!(image.unwrap().pixels(), [Color::BLACK]);
        let rows = LeftOut::all(&scene, settings).unwrap();
        let [row] = &rows[..] else { panic!("{rows:?}") };
        assert_eq!(row.omission, Omission::BlackHighlights);
        assert_eq!(row.counts(1.0), "2 powers");
        let times = Times::measure(&scene, settings, &rows, Instant::now()).unwrap();
        assert!(times.all.len() >= Median::ROUNDS);
        assert_eq!(times.rows.len(), 2);
    }

    /// 3, 4 and 5 ms more than without; and 4 ms less, while the same work differs by 1 ms.
    #[test]
    fn the_time_of_a_row_is_the_difference_to_the_row_before() {
        let of_rows = |rows: [[f64; 3]; 2], again: [f64; 3]| {
            let times = Times {
                renderer: Vec::new(),
                all: Vec::new(),
                rows: rows.map(Vec::from).into(),
                again: again.into(),
            };
            times.scaled(2.0).of_row(0)
        };
        let without = [0.25, 0.5, 0.125];
        let with = [0.253, 0.505, 0.129];
        let longer = of_rows([without, with], without);
        assert_eq!(longer, "8.00 ms (6.00 to 10.00)");
        let noise = of_rows([without, with], [0.25, 0.506, 0.125]);
        assert_eq!(noise, "no time beyond the noise of 12.00 ms");
        let shorter = of_rows([with, without], with);
        let ending = ": to leave it out takes longer here";
        assert_eq!(shorter, format!("-8.00 ms (-10.00 to -6.00){ending}"));
    }

    /// A millisecond for a pixel, times 100 renderings, is 40 s for 400 pixels.
    #[test]
    fn a_large_picture_is_estimated_from_a_smaller_one() {
        let scene = scene(Duration::from_millis(1));
        let settings = Settings {
            size: Size::new(640, 480).unwrap(),
            ..Settings::default()
        };
        let size = measured_size(&scene, &settings).unwrap();
        assert!((10..=24).contains(&size.width()), "{size}");
        assert!(size.height().abs_diff(size.width() * 3 / 4) <= 1, "{size}");
        let small = Settings {
            size: Size::new(4, 3).unwrap(),
            ..settings
        };
        assert_eq!(measured_size(&scene, &small).unwrap(), small.size);
    }

    #[test]
    fn times_are_compared_unless_they_differ_by_noise() {
        let of = |all: [f64; 6]| {
            let times = Times {
                renderer: vec![0.25; 6],
                all: all.into(),
                rows: Vec::new(),
                again: Vec::new(),
            };
            times.comparison()
        };
        let slower = of([1.5, 1.0, 2.0, 1.5, 1.5, 1.5]);
        let numbers = ["time 0.250 s", "6.00 times", "(4.00 to 8.00)"];
        assert!(numbers.iter().all(|part| slower.contains(part)), "{slower}");
        let equal = of([0.125, 0.25, 0.25, 0.25, 0.25, 0.3125]);
        assert!(equal.contains("a factor of 2.0"), "{equal}");
    }
}
