//! `Comparison`: a picture by the chosen renderer and by the one that skips no
//! work, the work of both, and the work that no renderer can leave out.

use std::fmt::{self, Write};

use common::steps::{Counts, StepKind, counted, counted_needed};
use common::{Error, Image, Renderer, Scene, Settings};

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
pub const WORK: [Work; 7] = [
    work(StepKind::CameraRay, "primary rays"),
    work(StepKind::ShadowRay, "shadow rays"),
    work(StepKind::ReflectedRay, "reflected rays"),
    work(StepKind::Test, "intersection tests"),
    work(StepKind::ObjectRay, "transformed rays"),
    work(StepKind::Power, "powers"),
    work(StepKind::RandomNumber, "random numbers"),
];

/// The work that the chosen renderer saves in a scene.
#[derive(Debug)]
pub struct Comparison {
    /// The picture by the chosen renderer.
    pub image: Image,
    /// Its work.
    pub done: Counts,
    /// The work of the renderer that skips none.
    pub all: Counts,
    /// The work that no renderer can leave out; none if the picture may have an error, because
    /// nobody knows how few samples are enough.
    pub needed: Option<Counts>,
    /// The largest difference of a channel between both pictures.
    pub difference: f64,
}

impl Comparison {
    /// Renders a scene by the chosen renderer and by the one that skips no work, on
    /// the threads of the current pool.
    pub fn new(scene: &Scene, settings: &Settings) -> Result<Self, Error> {
        let (image, done) = counted(|| scene.render(settings, &()))?;
        let (complete, all) = counted(|| scene.render(&complete(settings), &()))?;
        let needed = match settings.max_error {
            Some(_) => None,
            None => Some(counted_needed(|| scene.render(settings, &()))?.1),
        };
        let image = image?;
        Ok(Self {
            difference: difference(&image, &complete?),
            image,
            done,
            all,
            needed,
        })
    }

    /// A row of a Markdown table: for each kind of work the count of the chosen renderer, the full
    /// count if that is another, and the count that no renderer can leave out if it is a third one.
    #[must_use]
    pub fn row(&self, name: &str) -> String {
        let mut row = format!("| {name} |");
        for Work { kind, .. } in WORK {
            let (done, all) = (self.done[kind], self.all[kind]);
            let _ = match (done, all) {
                (0, 0) => write!(row, " |"),
                (done, all) if done == all => write!(row, " {all}"),
                (done, all) => write!(row, " **{done}** of {all}"),
            };
            if all == 0 && done == 0 {
                continue;
            }
            let needed = self.needed.map(|needed| needed[kind]);
            let _ = match needed.filter(|needed| *needed != done) {
                Some(needed) => write!(row, ", needed {needed} |"),
                None => write!(row, " |"),
            };
        }
        row
    }

    /// The same comparison of a picture with this many times as many pixels, as an estimate.
    #[must_use]
    pub fn scaled(self, factor: f64) -> Self {
        Self {
            done: self.done.scaled(factor),
            all: self.all.scaled(factor),
            needed: self.needed.map(|needed| needed.scaled(factor)),
            ..self
        }
    }
}

/// The settings with the renderer that skips no work.
pub fn complete(settings: &Settings) -> Settings {
    Settings {
        renderer: Renderer::AllWork,
        ..settings.clone()
    }
}

/// The largest difference of a channel; infinite where one is NaN.
fn difference(a: &Image, b: &Image) -> f64 {
    let pairs = a.pixels().iter().zip(b.pixels());
    let channels = pairs.flat_map(|(a, b)| a.channels().into_iter().zip(b.channels()));
    let differences = channels.map(|(a, b)| match (a - b).abs() {
        _ if a.to_bits() == b.to_bits() => 0.0,
        nan if nan.is_nan() => f64::INFINITY,
        difference => difference,
    });
    differences.fold(0.0, f64::max)
}

/// A table of the kinds of work that were done, without a newline at its end.
impl fmt::Display for Comparison {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(
            f,
            "  {:20} {:>14} {:>14} {:>14}",
            "work", "everything", "done", "needed"
        )?;
        for Work { kind, name } in WORK {
            let (done, all) = (self.done[kind], self.all[kind]);
            if all.max(done) > 0 {
                write!(f, "\n  {name:20} {all:>14} {done:>14}")?;
                match self.needed {
                    Some(needed) => write!(f, " {:>14}", needed[kind])?,
                    None => write!(f, " {:>14}", "unknown")?,
                }
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use common::steps::{self, count};
    use common::{Color, Size};

    use super::*;

    /// The renderer that skips no work takes one more ray and two more tests, and its
    /// picture is brighter by 1/8.
    fn scene() -> Scene {
        Scene::sampled("test", "", |settings, _| {
            let is_all = settings.renderer == Renderer::AllWork;
            count(StepKind::CameraRay, 1);
            let tests = match settings.renderer {
                Renderer::AllWork => 4,
                _ if steps::is_counting_needed() => 1,
                _ => 2,
            };
            count(StepKind::Test, tests);
            let mut image = Image::black(settings.size)?;
            if is_all {
                count(StepKind::ShadowRay, 1);
                image.pixels_mut()[0] = Color::gray(0.125);
            }
            Ok(image)
        })
    }

    #[test]
    fn skipped_work_and_differences_of_the_pictures_are_found() {
        let settings = Settings {
            size: Size::new(2, 1).unwrap(),
            ..Settings::default()
        };
        let comparison = Comparison::new(&scene(), &settings).unwrap();
        assert_eq!(comparison.difference, 0.125);
        let row = "| name | 1 | **0** of 1 | | **2** of 4, needed 1 | | | |";
        assert_eq!(comparison.row("name"), row);
        let table = "  work                     everything           done         needed
  primary rays                      1              1              1
  shadow rays                       1              0              0
  intersection tests                4              2              1";
        assert_eq!(comparison.to_string(), table);
        assert_eq!(comparison.scaled(2.5).done[StepKind::Test], 5);
    }

    #[test]
    fn nan_differs_from_all_but_itself() {
        let dot = |gray| {
            let size = Size::new(1, 1).unwrap();
            Image::from_fn(size, |_, _| Color::gray(gray)).unwrap()
        };
        let apart = |a, b| difference(&dot(a), &dot(b));
        assert_eq!(apart(f64::NAN, f64::NAN), 0.0);
        assert_eq!(apart(f64::INFINITY, f64::INFINITY), 0.0);
        assert_eq!(apart(f64::NAN, 1.0), f64::INFINITY);
        assert_eq!(apart(1.0, 0.25), 0.75);
    }
}
