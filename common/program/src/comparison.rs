//! `Comparison`: a picture by the chosen renderer and by the one that skips no
//! work, and the work of both.

use std::fmt::{self, Write};

use common::steps::{Counts, StepKind, counted};
use common::{Error, Image, Renderer, Scene, Settings};

/// A kind of work that a renderer may leave out.
struct Work {
    kind: StepKind,
    /// Its name for a reader, in the plural.
    name: &'static str,
    /// The reason why a renderer may do less of it without a change of the picture.
    reason: &'static str,
}

/// All kinds, in the order of the table.
const ALL_WORK: [Work; 7] = [
    Work {
        kind: StepKind::CameraRay,
        name: "primary rays",
        reason: "where samples agree, more of them change no more than the allowed error",
    },
    Work {
        kind: StepKind::ShadowRay,
        name: "shadow rays",
        reason: "light from behind a surface, light on a single colour and light without shadows \
                 need none",
    },
    Work {
        kind: StepKind::ReflectedRay,
        name: "reflected rays",
        reason: "a surface that does not mirror multiplies their colour by 0",
    },
    Work {
        kind: StepKind::Test,
        name: "intersection tests",
        reason: "a ray that is not sent needs none, one occluder casts a shadow as well as two, \
                 and a tree of bounding boxes (--fast) shows which objects a ray cannot hit",
    },
    Work {
        kind: StepKind::ObjectRay,
        name: "moved rays",
        reason: "a ray that is not sent, or misses the bounds of an object (--fast), is not \
                 transformed",
    },
    Work {
        kind: StepKind::Power,
        name: "powers",
        reason: "a black highlight and light mirrored away from the eye are not seen",
    },
    Work {
        kind: StepKind::RandomNumber,
        name: "random numbers",
        reason: "a sample with a fixed place needs none",
    },
];

/// The work that the chosen renderer saves in a scene.
#[derive(Debug)]
pub struct Comparison {
    /// The picture by the chosen renderer.
    pub image: Image,
    /// Its work.
    pub needed: Counts,
    /// The work of the renderer that skips none.
    pub all: Counts,
    /// The largest difference of a channel between both pictures.
    pub difference: f64,
}

impl Comparison {
    /// Renders a scene by the chosen renderer and by the one that skips no work, on
    /// the threads of the current pool.
    pub fn new(scene: &Scene, settings: &Settings) -> Result<Self, Error> {
        let (image, needed) = counted(|| scene.render(settings, &()))?;
        let (complete, all) = counted(|| scene.render(&complete(settings), &()))?;
        let image = image?;
        Ok(Self {
            difference: difference(&image, &complete?),
            image,
            needed,
            all,
        })
    }

    /// A row of a Markdown table: for each kind of work the count of the chosen
    /// renderer, and the full count if that is another.
    #[must_use]
    pub fn row(&self, name: &str) -> String {
        let mut row = format!("| {name} |");
        for Work { kind, .. } in ALL_WORK {
            let _ = match (self.needed[kind], self.all[kind]) {
                (0, 0) => write!(row, " |"),
                (needed, all) if needed == all => write!(row, " {all} |"),
                (needed, all) => write!(row, " **{needed}** of {all} |"),
            };
        }
        row
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

/// A table of the kinds of work that were done, and the reasons why less of some is enough,
/// without a newline at its end.
impl fmt::Display for Comparison {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(
            f,
            "  {:20} {:>14} {:>14} {:>8}",
            "work", "everything", "needed", "saved"
        )?;
        for Work { kind, name, .. } in ALL_WORK {
            let (needed, all) = (self.needed[kind], self.all[kind]);
            if all.max(needed) > 0 {
                let saved = 100.0 * (all as f64 - needed as f64) / all.max(1) as f64;
                write!(f, "\n  {name:20} {all:>14} {needed:>14} {saved:>6.1} %")?;
            }
        }
        for Work { kind, name, reason } in ALL_WORK {
            if self.needed[kind] < self.all[kind] {
                write!(f, "\n  fewer {name}: {reason}")?;
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use common::steps::count;
    use common::{Color, Size};

    use super::*;

    /// The renderer that skips no work takes one more ray and three more tests, and its
    /// picture is brighter by 1/8.
    fn scene() -> Scene {
        Scene::sampled("test", "", |settings, _| {
            let is_all = settings.renderer == Renderer::AllWork;
            count(StepKind::CameraRay, 1);
            count(StepKind::Test, if is_all { 4 } else { 1 });
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
        let row = "| name | 1 | **0** of 1 | | **1** of 4 | | | |";
        assert_eq!(comparison.row("name"), row);
        let table = "  work                     everything         needed    saved
  primary rays                      1              1    0.0 %
  shadow rays                       1              0  100.0 %
  intersection tests                4              1   75.0 %
  fewer shadow rays: ";
        let printed = comparison.to_string();
        assert!(printed.starts_with(table), "{printed}");
        assert_eq!(printed.lines().count(), 6);
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
