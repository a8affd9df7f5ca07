//! Cameras: openings, brackets and pictures of few pixels. Exact directions are
//! computed from the given doubles with 80 digits.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

use a02_math::{Point3, Vector3};
use common::{ArgumentError, Size};
use measure::extremes::{
    Bound, Case, Equal, Fails, Holds, Id, Outcome, Protocol, Refused, Ulps, tried,
};

use super::{AHEAD, UP};
use crate::{Camera, OrthographicCamera, PerspectiveCamera, PinholeCamera, protocol};

/// A size, and a pixel of it, counted from below.
type Pixel = ([u32; 2], f64, f64);

/// Direction through the middle of a pixel of the perspective camera at the origin.
fn direction(([w, h], x, y): Pixel, angle: f64) -> Result<Vector3, ArgumentError> {
    let camera = PerspectiveCamera::new(Point3::ORIGIN, AHEAD, UP, angle)?;
    Ok(camera.ray_for(Size::new(w, h)?, x, y).direction())
}

/// A row whose angle is half of the opening: with it the text's formula is right.
fn half(
    id: Id,
    what: &str,
    pixel: Pixel,
    angle: f64,
    exact: impl Into<Outcome>,
    bound: Bound,
    says: Protocol,
) -> Case {
    let what = format!("perspective, {what}");
    let theirs = protocol::perspective_direction(pixel.0.map(f64::from), pixel.1, pixel.2, angle);
    Case::new(id, what, exact, bound, direction(pixel, 2.0 * angle)).protocol(says, theirs)
}

/// The offset of the origin of a column's ray in the orthographic camera, in widths of
/// the picture.
fn bracket(
    id: Id,
    what: &str,
    (column, width): (f64, u32),
    exact: f64,
    formula: fn(f64, f64) -> f64,
) -> Case {
    let ours = tried(|| {
        let camera = OrthographicCamera::new(Point3::ORIGIN, AHEAD, UP, 1.0)?;
        let ray = camera.ray_for(Size::new(width, width)?, column, 0.0);
        Ok(ray.origin().x())
    });
    Case::new(id, format!("orthographic, {what}"), exact, Equal, ours)
        .protocol(Fails, formula(column, f64::from(width)))
}

#[rustfmt::skip]
pub fn cases() -> Vec<Case> {
    const CORNER: Pixel = ([640, 480], 0.0, 0.0);
    let top = ([641, 481], 320.0, 480.0);
    let tall = ([1, 100], 0.0, 99.0);
    vec![
        half("E01", "half angle 0", CORNER, 0.0, Refused, Equal, Fails),
        half("E02", "half angle 1e-200", CORNER, 1e-200, Refused, Equal, Fails),
        half("E03", "half angle pi/2", CORNER, FRAC_PI_2, Refused, Equal, Fails),
        half("E04", "half angle pi: looks back", CORNER, PI, Refused, Equal, Fails),
        half("E05", "half angle -pi/4", CORNER, -FRAC_PI_4, Refused, Equal, Fails),
        half("E06", "half angle pi/4, picture of 1x1", ([1, 1], 0.0, 0.0), FRAC_PI_4, AHEAD, Equal, Holds),
        half("E07", "half angle pi/4, 1x100, pixel (0, 99)", tall, FRAC_PI_4,
            [0.0, 0.703_544_597_920_105_2, -0.710_651_109_010_207_3], Ulps(2.0), Holds),
        half("E08", "picture of 0x0", ([0, 0], 0.0, 0.0), FRAC_PI_4, Refused, Equal, Fails),
        half("E09", "half angle NaN", CORNER, f64::NAN, Refused, Equal, Fails),
        Case::new("E24", "perspective, FULL angle pi/4, 641x481, middle of the top row",
            [0.0, 0.382_004_035_507_720_3, -0.924_160_655_327_75], Ulps(2.0), direction(top, FRAC_PI_4))
            .protocol(Fails, protocol::perspective_direction([641.0, 481.0], 320.0, 480.0, FRAC_PI_4)),
        bracket("E10", "column 639 of 640, bracket of the text's code",
            (639.0, 640), 0.5, protocol::bracket_of_the_code),
        bracket("E25", "column 0 of 640, fraction of the text's formula",
            (0.0, 640), -0.5, protocol::bracket_of_the_formula),
        bracket("E11", "the only column of 1, divided by w - 1",
            (0.0, 1), 0.0, protocol::bracket_of_the_course),
        pictures_of_few_pixels(),
    ]
}

/// Number of NaN values in the rays of pictures of one row, one column or one pixel.
fn pictures_of_few_pixels() -> Case {
    let sizes = [(1, 1), (1, 9), (9, 1)];
    let not_numbers = |v: [f64; 3]| v.iter().filter(|x| !x.is_finite()).count();
    let ours = tried(|| {
        let cameras: [Box<dyn Camera>; 3] = [
            Box::new(OrthographicCamera::new(Point3::ORIGIN, AHEAD, UP, 1.0)?),
            Box::new(PerspectiveCamera::new(Point3::ORIGIN, AHEAD, UP, 1.0)?),
            Box::new(PinholeCamera::new(Point3::ORIGIN, 1.0)?),
        ];
        let mut count = 0;
        for (w, h) in sizes {
            for camera in &cameras {
                let ray = camera.ray_for(Size::new(w, h)?, 0.0, 0.0);
                count += not_numbers(ray.direction().to_glam().to_array());
                count += not_numbers(ray.origin().to_glam().to_array());
            }
        }
        Ok(count)
    });
    let bracket = |n: u32| protocol::bracket_of_the_course(0.0, f64::from(n));
    let theirs = sizes.map(|(w, h)| not_numbers([bracket(w), bracket(h), 0.0]));
    let what = "pictures of 1x1, 1x9 and 9x1: coordinates that are no numbers";
    Case::new("Q11", what, 0.0, Equal, ours).protocol(Fails, theirs.iter().sum::<usize>())
}
