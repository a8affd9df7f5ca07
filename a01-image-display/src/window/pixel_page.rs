//! The page of the panel with the numbers behind a pixel.

use common::pixel_trace::digits;
use common::sensitivity::NumberPlace;
use common::steps::{Step, StepKind};
use common::{Color, PixelTrace};
use program::{Gallery, PixelPanel, effect_in_words, number_in_words};

use super::appearance::Colors;
use super::area::Area;
use super::screen::Screen;

/// Most steps of a pixel that are listed.
const MOST_STEPS: usize = 300;

/// Most values of the scene file that are listed, each by its strongest number.
const MOST_NUMBERS: usize = 3;

/// The heading above them.
const STRONGEST: &str = "Numbers of the file that change it most";

/// What the symbols of the steps mean.
const SYMBOLS: &str = "o origin, d direction, t distance along the ray, p point, n normal, \
                       c colour. Angles are in degrees, colours linear from 0 to 1.";

impl Screen {
    /// Adds the numbers behind the pixel that is explained.
    pub fn add_pixel(&mut self, gallery: &Gallery) {
        let Colors {
            text, muted, error, ..
        } = self.ui.colors;
        let Some([x, y]) = gallery.pixel else {
            let hint = "A click on the picture explains a pixel.";
            return self.ui.text(0, muted, hint);
        };
        self.ui.heading(&format!("Pixel: column {x}, row {y}"));
        let sample = self.ui.place(19.0);
        let height = self.ui.px(3.0);
        let picture = gallery.picture.as_ref();
        let color = picture.and_then(|picture| picture.pixel(x, y));
        self.ui
            .frame
            .fill(sample.inset(0, height), color.unwrap_or(0));
        if let Some(color) = color {
            let [_, r, g, b] = color.to_be_bytes();
            let bytes = format!("({r}, {g}, {b})");
            self.add_value("bytes", &bytes, &bytes);
        }
        match &gallery.explanation {
            None => {}
            Some(Err(reason)) => self.ui.text(0, error, &reason.to_string()),
            Some(Ok(panel)) => {
                let color = panel.trace.color;
                self.add_value("linear", &digits(&color.channels()), &exact(color));
                self.ui.is_shown = true;
                if self.ui.entry("Copy all numbers", "Ctrl C") {
                    self.copy(&all(panel, gallery));
                }
                self.ui
                    .text(0, muted, "A click on a line copies its values.");
                self.ui.text(0, text, &panel.samples);
                self.ui.text(0, muted, SYMBOLS);
                self.add_influences(gallery);
                self.add_steps(&panel.trace);
            }
        }
    }

    /// Adds the numbers of the scene file that change the pixel most.
    fn add_influences(&mut self, gallery: &Gallery) {
        let Colors {
            text, muted, error, ..
        } = self.ui.colors;
        let influences = match &gallery.influences {
            None if gallery.is_measuring() => {
                self.ui.heading(STRONGEST);
                return self.ui.text(0, muted, "They are being looked for.");
            }
            None => return,
            Some(Err(reason)) => return self.ui.text(0, error, &reason.to_string()),
            Some(Ok(influences)) => influences,
        };
        self.ui.heading(STRONGEST);
        let mut listed = Vec::new();
        for influence in influences {
            let NumberPlace { at, .. } = influence.number;
            // The channels of a colour, or the coordinates of a place, are one entry.
            if !influence.response.is_change() || listed.contains(&at) {
                continue;
            }
            listed.push(at);
            let number = number_in_words(&influence.number);
            let effect = effect_in_words(influence);
            let name = self.ui.text_area(0, text, &number);
            let words = self.ui.text_area(1, muted, &effect);
            let area = Area {
                height: name.height + words.height,
                ..name
            };
            if self.ui.clicked_in_panel(area) {
                self.copy(&format!("{number}\n{effect}"));
            }
            if listed.len() == MOST_NUMBERS {
                break;
            }
        }
        if listed.is_empty() {
            self.ui.text(0, muted, "No number of the file changes it.");
        }
    }

    fn add_steps(&mut self, trace: &PixelTrace) {
        for step in trace.steps.iter().take(MOST_STEPS) {
            let width = self.ui.width_at(step.level.saturating_sub(1));
            let words = step.words().map(|word| {
                // A line breaks between values only, or else before the numbers of a long one.
                let whole = word.replace(' ', "\u{a0}");
                if self.ui.letters.width(&whole) < width {
                    whole
                } else {
                    word.replace(", ", ",\u{a0}")
                }
            });
            let words = words.collect::<Vec<_>>().join("   ");
            let area = self.add_step(step, &words);
            if self.ui.clicked_in_panel(area) {
                self.copy(&values(step));
            }
        }
        if let more @ 1.. = trace.steps.len().saturating_sub(MOST_STEPS) {
            let hint = format!("{more} more steps are in the copy of all numbers.");
            self.ui.text(0, self.ui.colors.text, &hint);
        }
    }

    /// Adds a step, on one line if its name and its values have room there.
    fn add_step(&mut self, step: &Step, words: &str) -> Area {
        let Colors { text, muted, .. } = self.ui.colors;
        if is_heading(step.kind) {
            self.ui.heading(&step.name);
            return self.ui.text_area(0, muted, words);
        }
        let level = step.level.saturating_sub(1);
        let width = self.ui.letters.width(&step.name) + self.ui.letters.width(words);
        if width < self.ui.width_at(level) - self.ui.px(12.0) {
            return self.ui.line(level, text, &step.name, words);
        }
        let name = self.ui.text_area(level, text, &step.name);
        let values = self.ui.text_area(level, muted, words);
        Area {
            height: name.height + values.height,
            ..name
        }
    }

    /// Adds a name and a value, of which a click copies all digits.
    fn add_value(&mut self, name: &str, value: &str, all_digits: &str) {
        let Colors { text, muted, .. } = self.ui.colors;
        let area: Area = self.ui.place(19.0);
        self.ui.write(area, muted, name, "");
        let right = Area {
            x: area.x + self.ui.px(56.0),
            width: area.width - self.ui.px(56.0),
            ..area
        };
        self.ui.write(right, text, value, "");
        if self.ui.clicked_in_panel(area) {
            self.copy(all_digits);
        }
    }

    /// Copies a text; where there is no clipboard, prints it in the terminal.
    pub fn copy(&mut self, text: &str) {
        match self.clipboard.copy(text) {
            Ok(()) => {
                let start: String = text.lines().next().unwrap_or_default().into();
                self.notify(format!("copied {start}"));
            }
            Err(reason) => {
                // A closed terminal shows nothing.
                let _ = program::print(text);
                self.notify_error(&format!("{reason}; the terminal shows the text"));
            }
        }
    }
}

/// Whether the steps after one of this kind belong to it.
const fn is_heading(kind: StepKind) -> bool {
    matches!(
        kind,
        StepKind::Sample | StepKind::CameraRay | StepKind::ReflectedRay | StepKind::Mean
    )
}

/// The channels of a colour, with all digits.
fn exact(color: Color) -> String {
    let [r, g, b] = color.channels();
    format!("({r}, {g}, {b})")
}

/// The values of a step with all digits, one on a line.
fn values(step: &Step) -> String {
    let mut lines = vec![step.name.clone()];
    for (symbol, numbers) in &step.values {
        let numbers: Vec<_> = numbers.iter().map(f64::to_string).collect();
        lines.push(format!("{symbol} {}", numbers.join(", ")));
    }
    lines.join("\n")
}

/// All numbers behind a pixel, as `explain` prints them.
fn all(panel: &PixelPanel, gallery: &Gallery) -> String {
    let [x, y] = panel.trace.pixel;
    let (name, color) = (gallery.name(), exact(panel.trace.color));
    format!("{name}, pixel {x},{y}\n{}\nlinear {color}", panel.trace)
}
