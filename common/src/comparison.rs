//! `Comparison`: the work of the chosen renderer for a picture, and that of the renderer that leaves
//! out nothing.

use std::fmt::{self, Write};

use crate::steps::{Counts, StepKind, counted};
use crate::{Error, Renderer, Scene, Settings, Size, difference};

/// A kind of work that a renderer may leave out.
pub struct Work {
    /// The kind.
    pub kind: StepKind,
    /// Its name for a reader, in the plural.
    pub name: &'static str,
}

const fn work(kind: StepKind, name: &'static str) -> Work {
    Work { kind, name }
}

/// All kinds, in the order of the table.
pub const WORK: [Work; 6] = [
    work(StepKind::CameraRay, "primary rays"),
    work(StepKind::ShadowRay, "shadow rays"),
    work(StepKind::ReflectedRay, "reflected rays"),
    work(StepKind::Test, "intersection tests"),
    work(StepKind::ObjectRay, "transformed rays"),
    work(StepKind::Power, "powers"),
];

/// The work that the chosen renderer leaves out in a scene.
#[derive(Debug)]
pub struct Comparison {
    /// The work of the chosen renderer.
    pub done: Counts,
    /// The work of the renderer that leaves out nothing.
    pub all: Counts,
    /// The largest difference of a channel between both pictures.
    pub difference: f64,
}

impl Comparison {
    /// Renders a scene by the chosen renderer and by the one that leaves out nothing, on
    /// the threads of the current pool.
    pub fn new(scene: &Scene, settings: &Settings) -> Result<Self, Error> {
        let (image, done) = counted(|| scene.render(settings, &()))?;
        let (complete, all) = counted(|| scene.render(&complete(settings), &()))?;
        let differences = difference::of_channels(&image?, &complete?);
        Ok(Self {
            done,
            all,
            difference: differences.into_iter().map(f64::abs).fold(0.0, f64::max),
        })
    }

    /// A row of a Markdown table: for each kind of work the count of the chosen renderer, and the full
    /// count if that is another.
    #[must_use]
    pub fn row(&self, name: &str) -> String {
        let mut row = format!("| {name} |");
        for Work { kind, .. } in WORK {
            let (done, all) = (self.done[kind], self.all[kind]);
            let _ = match (done, all) {
                (0, 0) => write!(row, " |"),
                (done, all) if done == all => write!(row, " {all} |"),
                (done, all) => write!(row, " **{done}** of {all} |"),
            };
        }
        row
    }
}

/// The settings with the renderer that leaves out nothing.
#[must_use]
pub fn complete(settings: &Settings) -> Settings {
    Settings {
        renderer: Renderer::NoOmissions,
        ..settings.clone()
    }
}

/// A table of the kinds of work that were done, without a newline at its end.
impl fmt::Display for Comparison {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "  {:20} {:>14} {:>14}", "work", "everything", "done")?;
        for Work { kind, name } in WORK {
            let (done, all) = (self.done[kind], self.all[kind]);
            if all.max(done) > 0 {
                write!(f, "\n  {name:20} {all:>14} {done:>14}")?;
            }
        }
        Ok(())
    }
}

/// Work is counted in a picture of at most this width: each count needs another rendering, and the
/// renderer that leaves out nothing may take long.
const WIDTH: u32 = 96;

/// The size of a picture in which work is counted, of the same shape up to the rounding to whole pixels.
pub fn small(whole: Size) -> Result<Size, Error> {
    let width = whole.width().min(WIDTH);
    let height = f64::from(whole.height()) * f64::from(width) / f64::from(whole.width());
    Ok(Size::new(width, (height.round() as u32).max(1))?)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn work_is_counted_in_a_small_picture_of_the_same_shape() {
        let small = |width, height| small(Size::new(width, height).unwrap()).unwrap();
        assert_eq!(small(640, 480).to_string(), "96x72");
        assert_eq!(small(8, 6).to_string(), "8x6");
        assert_eq!(small(1000, 1).to_string(), "96x1");
    }
}
