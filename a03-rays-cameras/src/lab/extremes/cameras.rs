//! Cameras: openings, brackets, axes, and pictures of few pixels. Exact directions are
//! computed from the given doubles with 80 digits.

use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2, FRAC_PI_4, PI};

use a02_math::{Direction, Point3, Vector3};
use common::{ArgumentError, Size};
use measure::extremes::{Absolute, Bound, Case, Equal, Fails, Holds, Id, Outcome, Protocol};
use measure::extremes::{Refused, Ulps, greatest, tried};

use super::{AHEAD, UP};
use crate::lab::protocol;
use crate::{Basis, Camera, OrthographicCamera, PerspectiveCamera, PinholeCamera, Ray};

pub fn cases() -> Vec<Case> {
    [perspective_and_orthographic(), axes(), pinhole()].concat()
}

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
fn perspective_and_orthographic() -> Vec<Case> {
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

/// The axis u of a camera. The protocol does not check gaze and up vector.
fn u(id: Id, what: &str, gaze: Vector3, up: Vector3, exact: impl Into<Outcome>) -> Case {
    let ours = Basis::new(Point3::ORIGIN, gaze, up).map(|basis| basis.u);
    let [theirs, ..] = protocol::axes(gaze, up);
    Case::new(id, what, exact, Equal, ours).protocol(Fails, theirs)
}

/// Greatest deviation of the axes from being perpendicular and of length 1.
fn defect(Basis { u, v, w, .. }: Basis) -> f64 {
    let lengths = [u, v, w].map(|axis| axis.dot(axis) - 1.0);
    greatest([u.dot(v), v.dot(w), w.dot(u)].into_iter().chain(lengths))
}

#[rustfmt::skip]
fn axes() -> Vec<Case> {
    let right = [1.0, 0.0, 0.0];
    let (slanted, near) = (Vector3::new(1.0, 2.0, 3.0), Vector3::new(1.0 + 1e-11, 2.0, 3.0));
    let basis = Basis::new(Point3::ORIGIN, slanted, near);
    vec![
        u("E12", "axes, gaze = up = (0, 1, 0)", UP, UP, Refused),
        u("E13", "axes, gaze = 2 up, up = (1, 2, 3)", slanted * 2.0, slanted, Refused),
        Case::new("E14", "u of gaze (1, 2, 3) and up (1+1e-11, 2, 3)",
            [0.0, 0.832_050_294_337_843_7, -0.554_700_196_225_229_1], Absolute(1e-3),
            basis.clone().map(|basis| basis.u)).protocol(Holds, protocol::axes(slanted, near)[0]),
        Case::new("E31", "axes of E14: how far from a right angle, gaze and up being 2.6e-12 apart",
            0.0, Absolute(4.0 * f64::EPSILON / 2.6e-12), basis.map(defect)),
        u("E15", "axes, gaze = 0", Vector3::default(), UP, Refused),
        u("E16", "u of gaze (0, 0, -1e200)", AHEAD * 1e200, UP, right),
        u("E17", "u of up (0, 1e-170, 0)", AHEAD, UP * 1e-170, right),
    ]
}

#[rustfmt::skip]
fn pinhole() -> Vec<Case> {
    /// 1 / sqrt(3).
    const THIRD: f64 = 0.577_350_269_189_625_8;
    // Through a place of the picture, counted from its upper left corner.
    let ours = |[w, h]: [u32; 2], x, y| tried(|| {
        let camera = PinholeCamera::new(Point3::ORIGIN, FRAC_PI_2)?;
        Ok(camera.generate_ray(Size::new(w, h)?, x, y).direction())
    });
    let theirs = |size: [u32; 2], x, y| protocol::pinhole_direction(size.map(f64::from), x, y, FRAC_PI_2);
    let far = Vector3::new(0.0, 0.0, -2.0);
    let of_pixel = tried(|| {
        let camera = PinholeCamera::new(Point3::ORIGIN, FRAC_PI_2)?;
        Ok(camera.ray_for(Size::new(3, 3)?, 1.0, 1.0).direction())
    });
    let sky = Ray::new(Point3::ORIGIN, far).and_then(|ray| ray.bounded(f64::INFINITY));
    vec![
        Case::new("E26", "pinhole, 3x3, middle of the middle pixel: through its corner",
            AHEAD, Equal, of_pixel).protocol(Fails, theirs([3, 3], 1.0, 1.0)),
        Case::new("E27", "pinhole, 3x601, middle (1.5, 300.5): sizes halved as whole numbers",
            AHEAD, Equal, ours([3, 601], 1.5, 300.5))
            .protocol(Fails, protocol::pinhole_direction_of_whole_sizes([3, 601], 1.5, 300.5, FRAC_PI_2)),
        Case::new("E28", "pinhole, 10x10, corner (10, 10), which the text's loop leaves out",
            [THIRD, -THIRD, -THIRD], Ulps(2.0), ours([10, 10], 10.0, 10.0))
            .protocol(Holds, theirs([10, 10], 10.0, 10.0)),
        Case::new("E29", "the point at t = 50 on a ray to the sky, which the text bounds by 30",
            [0.0, 0.0, -50.0], Equal, sky.map(|ray| ray.at(50.0)).ok().flatten())
            .protocol(Fails, protocol::point_at(Point3::ORIGIN, far, 30.0, 50.0)),
        Case::new("E30", "pinhole, 2x2, upper edge in the middle: 45 degrees up",
            [0.0, FRAC_1_SQRT_2, -FRAC_1_SQRT_2], Ulps(2.0), ours([2, 2], 1.0, 0.0))
            .protocol(Holds, theirs([2, 2], 1.0, 0.0)),
    ]
}
