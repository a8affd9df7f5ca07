//! The decimals to which each pixel of the scene `sphere` can be trusted, as a picture. Takes the
//! arguments of the stages' programs.

use std::process::ExitCode;

use a04_lab::line::Line;
use a06_lab::digits::{NO_OFFSET, OFFSET, error, lines, spread};
use common::{Color, Error, Image, Progress, Scene, Settings, Stage};

fn main() -> ExitCode {
    program::run(&stage(), None)
}

fn stage() -> Stage {
    let about = "random rounding at depths 1 and 6; the rounding error; and that of the offset";
    let panels: [Panel; 4] = [
        |settings, _| panel(settings, |line, n| spread(line, 1, n)),
        |settings, _| panel(settings, |line, n| spread(line, 6, n)),
        |settings, _| panel(settings, |line, _| error(line, 6, OFFSET)),
        |settings, _| panel(settings, |line, _| error(line, 6, NO_OFFSET)),
    ];
    Stage {
        name: "digits",
        about: "The decimals to which each pixel of the scene sphere can be trusted",
        scenes: vec![Scene::side_by_side("digits", about, panels, (240, 180))],
        open: None,
    }
}

type Panel = fn(&Settings, &dyn Progress) -> Result<Image, Error>;

/// The decimals of the errors of pixels, which have a number each.
fn panel(settings: &Settings, error_of: fn(&Line, u64) -> f64) -> Result<Image, Error> {
    let mut image = Image::black(settings.size)?;
    let lines = lines(settings.size)?;
    for (n, (pixel, line)) in (0..).zip(image.pixels_mut().iter_mut().zip(&lines)) {
        *pixel = gray(error_of(line, n));
    }
    Ok(image)
}

/// Black for 12 decimals or fewer, white for 17 or more, and four steps between them.
fn gray(error: f64) -> Color {
    let decimals = (-libm::log10(error)).floor().clamp(12.0, 17.0);
    Color::gray((decimals - 12.0) / 5.0)
}
