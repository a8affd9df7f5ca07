//! `TerminalProgress`: the progress bar of a rendering, on the terminal.

use std::fmt::Write;
use std::sync::{Mutex, OnceLock, PoisonError};
use std::thread;
use std::time::Duration;

use common::{Color, Progress, SamplingReport, Settings, Size, Transfer, text};
use indicatif::{FormattedDuration, ProgressBar, ProgressDrawTarget, ProgressState, ProgressStyle};

use crate::interruption;
use crate::print::warn;
use crate::render::SLOW;

/// A bar with elapsed and remaining time on stderr, hidden if stderr is no terminal; and the picture so far.
pub struct TerminalProgress {
    bar: ProgressBar,
    sampled: OnceLock<SamplingReport>,
    transfer: Transfer,
    size: Size,
    /// The bytes of the picture so far; none before the first row.
    rgb: Mutex<Vec<u8>>,
}

impl TerminalProgress {
    /// A bar for a picture with these settings, labelled with the name of its scene.
    pub fn new(scene: &'static str, settings: &Settings) -> Self {
        let bar = terminal_bar(scene, settings.size.height().into());
        bar.enable_steady_tick(Duration::from_millis(200));
        Self {
            bar,
            sampled: OnceLock::new(),
            transfer: settings.transfer,
            size: settings.size,
            rgb: Mutex::default(),
        }
    }

    /// Prints a hint above the bar as soon as the picture takes long.
    pub fn hint_if_slow(&self, hint: String) {
        let bar = self.bar.clone();
        let wait = move || {
            while !bar.is_finished() {
                if Elapsed::of(&bar).is_slow() {
                    return bar.suspend(|| warn(&hint));
                }
                thread::sleep(Duration::from_millis(200));
            }
        };
        // Without a thread there is no hint.
        let _ = thread::Builder::new().spawn(wait);
    }

    /// The bytes of the picture so far, where rows that are not drawn are black; none before the first row.
    pub fn rgb(self) -> Vec<u8> {
        let mut rgb = self.rgb.lock().unwrap_or_else(PoisonError::into_inner);
        std::mem::take(&mut rgb)
    }

    /// The statistics of adaptive sampling, if there was any.
    pub fn samples(&self) -> Option<SamplingReport> {
        self.sampled.get().copied()
    }
}

/// What is known of a rendering while it goes on.
#[derive(Clone, Copy)]
pub struct Elapsed {
    /// The steps that are done, and all of them.
    steps: [u64; 2],
    time: Duration,
}

impl Elapsed {
    /// Of a bar.
    pub fn of(bar: &ProgressBar) -> Self {
        Self {
            steps: [bar.position(), bar.length().unwrap_or(0)],
            time: bar.elapsed(),
        }
    }

    /// The time to go if each step takes as long as the others; none before one is done.
    fn to_go(self) -> Option<Duration> {
        let [done, all] = self.steps;
        let left = all.saturating_sub(done) as f64 / done as f64;
        (done > 0).then(|| self.time.mul_f64(left))
    }

    /// Whether the rendering takes so long that a faster renderer is worth a remark. In the first second the time to go
    /// is a guess.
    pub fn is_slow(self) -> bool {
        match self.to_go() {
            Some(to_go) => self.time > Duration::from_secs(1) && to_go > SLOW,
            None => self.time > SLOW,
        }
    }

    /// The time in words, and the time to go if it is known.
    pub fn words(self) -> String {
        let time = FormattedDuration(self.time);
        match self.to_go().map(FormattedDuration) {
            Some(to_go) => format!("{time} elapsed, {to_go} to go"),
            None => format!("{time} elapsed"),
        }
    }
}

/// A bar on stderr that moves only when it is set, so that no other thread runs
/// while times are measured.
#[must_use]
pub fn terminal_bar(name: &str, steps: u64) -> ProgressBar {
    // indicatif hides a bar whose target is no terminal.
    let target = ProgressDrawTarget::stderr_with_hz(10);
    let bar = ProgressBar::with_draw_target(Some(steps), target);
    let in_words = |state: &ProgressState, words: &mut dyn Write| {
        let elapsed = Elapsed {
            steps: [state.pos(), state.len().unwrap_or(0)],
            time: state.elapsed(),
        };
        let _ = words.write_str(&elapsed.words());
    };
    if let Ok(style) = ProgressStyle::with_template("{msg} [{bar:30}] {percent}%  {times}") {
        bar.set_style(style.with_key("times", in_words).progress_chars("=> "));
    }
    bar.set_message(text::name(name));
    bar
}

/// Steps of a bar that shows a fraction: so many that rows change nothing beside it.
const FINE: u64 = 1 << 40;

/// Shows that a fraction of the work is done.
pub fn set_fraction(bar: &ProgressBar, fraction: f64) {
    bar.set_length(FINE);
    bar.set_position((fraction * FINE as f64) as u64);
}

impl Progress for TerminalProgress {
    fn row(&self, y: u32, pixels: &mut dyn Iterator<Item = Color>) {
        let row = self.transfer.rgb8(pixels);
        let start = y as usize * 3 * self.size.width() as usize;
        let mut rgb = self.rgb.lock().unwrap_or_else(PoisonError::into_inner);
        if rgb.is_empty() {
            *rgb = vec![0; 3 * self.size.pixels()];
        }
        if let Some(place) = rgb.get_mut(start..start + row.len()) {
            place.copy_from_slice(&row);
        }
        self.bar.inc(1);
    }

    fn done(&self, fraction: f64) {
        set_fraction(&self.bar, fraction);
    }

    fn sampled(&self, sampled: &SamplingReport) {
        let _ = self.sampled.set(*sampled);
    }

    fn stopped(&self) -> bool {
        interruption::has_stopped()
    }
}

impl Drop for TerminalProgress {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_time_to_go_and_a_hint_need_a_row_or_a_long_time() {
        for (seconds, rows, is_slow, words) in [
            (1, 0, false, "00:00:01 elapsed"),
            (22, 0, true, "00:00:22 elapsed"),
            (1, 1, false, "00:00:01 elapsed, 00:06:39 to go"),
            (2, 1, true, "00:00:02 elapsed, 00:13:18 to go"),
            (60, 300, true, "00:01:00 elapsed, 00:00:20 to go"),
            (60, 380, false, "00:01:00 elapsed, 00:00:03 to go"),
            (60, 400, false, "00:01:00 elapsed, 00:00:00 to go"),
        ] {
            let elapsed = Elapsed {
                steps: [rows, 400],
                time: Duration::from_secs(seconds),
            };
            assert_eq!((elapsed.is_slow(), &*elapsed.words()), (is_slow, words));
        }
    }

    #[test]
    fn the_bar_counts_rows_and_ends_with_the_rendering() {
        let settings = Settings {
            size: Size::new(3, 4).unwrap(),
            ..Settings::default()
        };
        let progress = TerminalProgress::new("scene", &settings);
        let bar = progress.bar.clone();
        progress.row(2, &mut [Color::RED; 3].into_iter());
        assert_eq!((bar.position(), bar.length()), (1, Some(4)));
        progress.done(0.25);
        progress.row(3, &mut std::iter::empty());
        let shown = bar.position() as f64 / bar.length().unwrap() as f64;
        assert!((shown - 0.25).abs() < 1e-9, "{shown}");
        assert_eq!(progress.samples(), None);
        progress.sampled(&SamplingReport::default());
        assert_eq!(progress.samples(), Some(SamplingReport::default()));
        assert!(!bar.is_finished());
        let with_row = [[0; 18].as_slice(), &[255, 0, 0].repeat(3), &[0; 9]].concat();
        assert_eq!(progress.rgb(), with_row);
        assert!(bar.is_finished());
    }
}
