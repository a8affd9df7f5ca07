//! `side_by_side`: pictures of the same in several ways, for comparison.

use common::{Color, Error, Image, Progress, Scene, Settings, Size};

/// The gap between two pictures, in pixels.
const GAP: u32 = 8;

/// Pictures side by side: each has an equal fraction of the width, with a gap of 8 pixels between
/// them, and by default this width and height.
pub fn side_by_side<P, const N: usize>(
    name: &'static str,
    about: &'static str,
    panels: [P; N],
    (width, height): (u32, u32),
) -> Scene
where
    P: Fn(&Settings, &dyn Progress) -> Result<Image, Error> + Send + Sync + 'static,
{
    let count = N.max(1) as u32;
    let gaps = GAP * (count - 1);
    let defaults = Settings {
        size: Size::new(count * width + gaps, height).unwrap_or(Size::COURSE),
        ..Settings::default()
    };
    let paint = move |settings: &Settings, progress: &dyn Progress| {
        let size = settings.size;
        let width = size.width().saturating_sub(gaps) / count;
        let panel = Settings {
            size: Size::new(width, size.height())?,
            ..settings.clone()
        };
        let mut image = Image::black(size)?.map(|_| Color::WHITE);
        for (left, paint) in (0..).step_by((width + GAP) as usize).zip(&panels) {
            if progress.stopped() {
                return Err(Error::Stopped);
            }
            image.paste(left, 0, &paint(&panel, &())?);
        }
        for (y, row) in (0..).zip(image.rows()) {
            progress.row(y, &mut row.iter().copied());
        }
        Ok(image)
    };
    Scene::sampled(name, about, paint).with_defaults(defaults)
}
