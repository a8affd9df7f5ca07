//! `TerminalProgress`: the progress bar of a rendering, on the terminal.

use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use common::{Color, Progress, SamplingReport, Size, text};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use crate::print::warn;
use crate::render::SLOW;

/// A bar with elapsed and remaining time on stderr; hidden if stderr is no terminal.
pub struct TerminalProgress {
    bar: ProgressBar,
    sampled: OnceLock<SamplingReport>,
    /// Printed once, when the picture takes long.
    hint: Option<String>,
    has_hinted: AtomicBool,
}

impl TerminalProgress {
    /// A bar for a picture of this size, labelled with the name of its scene.
    pub fn new(scene: &'static str, size: Size) -> Self {
        let bar = terminal_bar(scene, size.height().into());
        bar.enable_steady_tick(Duration::from_millis(200));
        Self {
            bar,
            sampled: OnceLock::new(),
            hint: None,
            has_hinted: AtomicBool::new(false),
        }
    }

    /// The same bar, which prints a hint above it if the picture takes long.
    pub fn with_hint(mut self, hint: Option<String>) -> Self {
        self.hint = hint;
        self
    }

    fn print_hint(&self) {
        let elapsed = self.bar.elapsed();
        let to_go = self.bar.eta();
        if let Some(hint) = &self.hint
            && is_worth_a_hint(elapsed, to_go)
            && !self.has_hinted.swap(true, Ordering::Relaxed)
        {
            self.bar.suspend(|| warn(hint));
        }
    }

    /// The statistics of adaptive sampling, if there was any.
    pub fn samples(&self) -> Option<SamplingReport> {
        self.sampled.get().copied()
    }
}

/// Whether a picture that is rendered for this time, and takes this time yet, is worth a remark on a faster
/// renderer. Before, the time to go is a guess.
pub fn is_worth_a_hint(elapsed: Duration, to_go: Duration) -> bool {
    elapsed > Duration::from_secs(1) && to_go > SLOW
}

/// A bar on stderr that moves only when it is set, so that no other thread runs
/// while times are measured.
#[must_use]
pub fn terminal_bar(name: &str, steps: u64) -> ProgressBar {
    // indicatif hides a bar whose target is no terminal.
    let target = ProgressDrawTarget::stderr_with_hz(10);
    let bar = ProgressBar::with_draw_target(Some(steps), target);
    let template = "{msg} [{bar:30}] {percent}%  {elapsed_precise} elapsed, {eta_precise} to go";
    if let Ok(style) = ProgressStyle::with_template(template) {
        bar.set_style(style.progress_chars("=> "));
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
    fn row(&self, _: u32, _: &mut dyn Iterator<Item = Color>) {
        self.bar.inc(1);
        self.print_hint();
    }

    fn done(&self, fraction: f64) {
        set_fraction(&self.bar, fraction);
    }

    fn sampled(&self, sampled: &SamplingReport) {
        let _ = self.sampled.set(*sampled);
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
    fn a_hint_comes_only_while_there_is_time_to_gain() {
        let seconds = Duration::from_secs;
        assert!(!is_worth_a_hint(seconds(1), seconds(60)));
        assert!(is_worth_a_hint(seconds(2), seconds(60)));
        assert!(!is_worth_a_hint(seconds(60), seconds(1)));
    }

    #[test]
    fn the_bar_counts_rows_and_ends_with_the_rendering() {
        let progress = TerminalProgress::new("scene", Size::new(3, 4).unwrap());
        let bar = progress.bar.clone();
        progress.row(2, &mut std::iter::empty());
        assert_eq!((bar.position(), bar.length()), (1, Some(4)));
        progress.done(0.25);
        progress.row(3, &mut std::iter::empty());
        let shown = bar.position() as f64 / bar.length().unwrap() as f64;
        assert!((shown - 0.25).abs() < 1e-9, "{shown}");
        assert_eq!(progress.samples(), None);
        progress.sampled(&SamplingReport::default());
        assert_eq!(progress.samples(), Some(SamplingReport::default()));
        assert!(!bar.is_finished());
        drop(progress);
        assert!(bar.is_finished());
    }
}
