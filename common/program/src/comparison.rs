//! `Comparison`: a picture by the chosen renderer and by the one that skips no
//! work, and the work of both.

use std::fmt::{self, Write};

use common::tally::{Tally, Work, counted};
use common::{Error, Image, Renderer, Scene, Settings};

/// The work that the chosen renderer saves in a scene.
#[derive(Debug)]
pub struct Comparison {
    /// The picture by the chosen renderer.
    pub image: Image,
    /// Its work.
    pub needed: Tally,
    /// The work of the renderer that skips none.
    pub all: Tally,
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
        for (work, ..) in Work::ALL {
            let _ = match (self.needed[work], self.all[work]) {
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
        for (work, name, _) in Work::ALL {
            let (needed, all) = (self.needed[work], self.all[work]);
            if all.max(needed) > 0 {
                let saved = 100.0 * (all as f64 - needed as f64) / all.max(1) as f64;
                write!(f, "\n  {name:20} {all:>14} {needed:>14} {saved:>6.1} %")?;
            }
        }
        for (work, name, reason) in Work::ALL {
            if self.needed[work] < self.all[work] {
                write!(f, "\n  fewer {name}: {reason}")?;
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use common::{Color, Size};

    use super::*;
    use common::tally::{count, count_all};

    /// The renderer that skips no work takes one more ray and three more tests, and its
    /// picture is brighter by 1/8.
    fn scene() -> Scene {
        Scene::sampled("test", "", |settings, _| {
            let is_all = settings.renderer == Renderer::AllWork;
            count(Work::PrimaryRay);
            count_all(Work::IntersectionTest, if is_all { 4 } else { 1 });
            let mut image = Image::black(settings.size)?;
            if is_all {
                count(Work::ShadowRay);
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
