//! `explain --of LINE`: a heat map of the pixels that depend on the numbers of a line.

use std::path::PathBuf;

use common::pixel_trace::digits;
use common::sensitivity::DependentPixels;
use common::{Error, Renderer, Scene, Settings, Stage, text};

use crate::options::Options;
use crate::print::print;
use crate::render::{render, warn_unused};
use crate::target::Target;
use crate::terminal_progress::TerminalProgress;

/// Writes the heat map of a line of the scene file, and says how many pixels depend on it.
pub fn draw_pixels_of(
    stage: &Stage,
    scene: &Scene,
    line: u32,
    output: Option<PathBuf>,
    settings: &Settings,
    options: &Options,
) -> Result<(), Error> {
    if settings.max_error.is_some() {
        let reason = "--max-error chooses other samples for each picture; --of takes --samples";
        return Err(Error::Usage(reason.to_owned()));
    }
    let settings = &Settings {
        renderer: Renderer::Engine,
        ..settings.clone()
    };
    let (rays, target) = (scene.rays()?, Target::new(output, 1)?);
    let map = Scene {
        name: format!("{}-line-{line}", scene.name).leak(),
        ..scene.clone()
    };
    target.check(stage, &map)?;
    let threads = options.thread_pool()?;
    let progress = TerminalProgress::new(scene.name, settings.size);
    let found = threads.install(|| rays.pixels_of(settings, line as usize, &progress))?;
    drop(progress);
    warn_unused(scene, options, settings);
    let picture = render(scene, settings, options)?;
    let path = target.write(stage, &map, &found.over(&picture)?, options.transfer)?;
    print(&sentence(&found, line))?;
    let path = text::visible(&path.to_string_lossy());
    print(&format!("{path}  {}", settings.size))
}

/// Which numbers were moved, and how many pixels have changed.
fn sentence(found: &DependentPixels, line: u32) -> String {
    let mut moved = Vec::new();
    let mut table = "";
    for (number, step) in &found.numbers {
        let step = digits(&[*step]);
        if number.table == table {
            moved.push(format!("{} by {step}", number.key));
        } else {
            moved.push(format!("{} {} by {step}", number.table, number.key));
        }
        table = &number.table;
    }
    let moved = match moved.split_last() {
        None => return format!("line {line}: none of its numbers can be moved alone"),
        Some((last, [])) => last.clone(),
        Some((last, before)) => format!("{} or {last}", before.join(", ")),
    };
    let (count, all) = (found.count(), found.strengths.len());
    let change = match found.largest() {
        0.0 => "changes no pixel".to_owned(),
        largest => {
            let largest = digits(&[largest]);
            format!("changes {count} of {all} pixels, a channel by at most {largest}")
        }
    };
    format!("line {line}: moving {moved} {change}")
}

#[cfg(test)]
mod tests {
    use common::Size;
    use common::sensitivity::{NumberPlace, Unit};

    use super::*;

    #[test]
    fn the_sentence_names_the_numbers_and_counts_the_pixels() {
        let number = |key: &str| NumberPlace {
            line: 3,
            columns: 1..2,
            bytes: 0..1,
            at: 0,
            table: "[camera]".to_owned(),
            key: key.to_owned(),
            value: 1.0,
            unit: Unit::Length,
        };
        let mut found = DependentPixels {
            size: Size::new(2, 2).unwrap(),
            strengths: vec![0.0, 0.25, 0.5, 0.0],
            numbers: vec![(number("eye x"), 0.01), (number("eye y"), -0.02)],
        };
        assert_eq!(
            sentence(&found, 3),
            "line 3: moving [camera] eye x by 0.01 or eye y by -0.02 changes 2 of 4 pixels, a channel \
             by at most 0.5"
        );
        found.strengths = vec![0.0; 4];
        assert!(sentence(&found, 3).ends_with("changes no pixel"));
        found.numbers.clear();
        assert!(sentence(&found, 3).ends_with("can be moved alone"));
    }
}
