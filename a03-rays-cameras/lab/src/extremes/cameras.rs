//! Cameras: openings, brackets, axes, and pictures of few pixels. Exact directions are
//! computed from the given doubles with 80 digits.

use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2, FRAC_PI_4, PI};

use a02_math::arrays::array;
use a02_math::{Direction, Point3, Vector3};
use common::{ArgumentError, Size};
use measure::extremes::{Absolute, Case, Equal, Fails, Holds, Outcome, Refused, Ulps};
use measure::extremes::{case, greatest, tried};

use super::{AHEAD, UP};
use crate::protocol;
use a03_rays_cameras::{
    Basis, Camera, OrthographicCamera, PerspectiveCamera, PinholeCamera, PixelRandom, Ray,
};

pub fn cases() -> Vec<Case> {
    [perspective_and_orthographic(), axes(), pinhole()].concat()
}

/// A size, and a pixel of it, counted from below.
type Pixel = ([u32; 2], f64, f64);

/// Direction through the middle of a pixel of the perspective camera at the origin.
fn direction(([w, h], x, y): Pixel, angle: f64) -> Result<[f64; 3], ArgumentError> {
    let camera = PerspectiveCamera::new(Point3::ORIGIN, AHEAD, UP, angle)?;
    Ok(array(camera.ray_for(Size::new(w, h)?, x, y).direction()))
}

/// The direction for half of an opening: with it the text's formula is right.
fn half(pixel: Pixel, angle: f64) -> [Outcome; 2] {
    let theirs = protocol::perspective_direction(pixel.0.map(f64::from), pixel.1, pixel.2, angle);
    [direction(pixel, 2.0 * angle).into(), array(theirs).into()]
}

/// The offset of the origin of a column's ray in the orthographic camera, in widths of
/// the picture.
fn bracket(column: f64, width: u32, formula: fn(f64, f64) -> f64) -> [Outcome; 2] {
    let ours = tried(|| {
        let camera = OrthographicCamera::new(Point3::ORIGIN, AHEAD, UP, 1.0)?;
        let ray = camera.ray_for(Size::new(width, width)?, column, 0.0);
        Ok(ray.origin().x())
    });
    [ours, formula(column, width.into()).into()]
}

#[rustfmt::skip]
fn perspective_and_orthographic() -> Vec<Case> {
    const CORNER: Pixel = ([640, 480], 0.0, 0.0);
    let top = ([641, 481], 320.0, 480.0);
    let tall = ([1, 100], 0.0, 99.0);
    vec![
        case("E01", "perspective, half angle 0", half(CORNER, 0.0), Refused, Equal, Fails),
        case("E02", "perspective, half angle 1e-200", half(CORNER, 1e-200), Refused, Equal, Fails),
        case("E03", "perspective, half angle pi/2", half(CORNER, FRAC_PI_2), Refused, Equal, Fails),
        case("E04", "perspective, half angle pi: looks back", half(CORNER, PI), Refused, Equal, Fails),
        case("E05", "perspective, half angle -pi/4", half(CORNER, -FRAC_PI_4), Refused, Equal, Fails),
        case("E06", "perspective, half angle pi/4, picture of 1x1",
            half(([1, 1], 0.0, 0.0), FRAC_PI_4), array(AHEAD), Equal, Holds),
        case("E07", "perspective, half angle pi/4, 1x100, pixel (0, 99)", half(tall, FRAC_PI_4),
            [0.0, 0.703_544_597_920_105_2, -0.710_651_109_010_207_3], Ulps(2.0), Holds),
        case("E08", "perspective, picture of 0x0", half(([0, 0], 0.0, 0.0), FRAC_PI_4), Refused, Equal, Fails),
        case("E09", "perspective, half angle NaN", half(CORNER, f64::NAN), Refused, Equal, Fails),
        Case::new("E24", "perspective, FULL angle pi/4, 641x481, middle of the top row",
            [0.0, 0.382_004_035_507_720_3, -0.924_160_655_327_75], Ulps(2.0), direction(top, FRAC_PI_4))
            .protocol(Fails, array(protocol::perspective_direction([641.0, 481.0], 320.0, 480.0, FRAC_PI_4))),
        case("E10", "orthographic, column 639 of 640, bracket of the text's code",
            bracket(639.0, 640, protocol::bracket_of_the_code), 0.5, Equal, Fails),
        case("E25", "orthographic, column 0 of 640, fraction of the text's formula",
            bracket(0.0, 640, protocol::bracket_of_the_formula), -0.5, Equal, Fails),
        case("E11", "orthographic, the only column of 1, divided by w - 1",
            bracket(0.0, 1, protocol::bracket_of_the_course), 0.0, Equal, Fails),
        case("Q11", "pictures of 1x1, 1x9 and 9x1: coordinates that are no numbers",
            pictures_of_few_pixels(), 0.0, Equal, Fails),
    ]
}

/// Number of NaN values in the rays of pictures of one row, one column or one pixel.
fn pictures_of_few_pixels() -> [Outcome; 2] {
    let not_numbers = |v: [f64; 3]| v.iter().filter(|x| !x.is_finite()).count();
    let ours = tried(|| {
        let cameras: [Box<dyn Camera>; 3] = [
            Box::new(OrthographicCamera::new(Point3::ORIGIN, AHEAD, UP, 1.0)?),
            Box::new(PerspectiveCamera::new(Point3::ORIGIN, AHEAD, UP, 1.0)?),
            Box::new(PinholeCamera::new(Point3::ORIGIN, 1.0)?),
        ];
        let sizes = [Size::new(1, 1)?, Size::new(1, 9)?, Size::new(9, 1)?];
        let rays = |camera: Box<dyn Camera>| sizes.map(|size| camera.ray_for(size, 0.0, 0.0));
        let triples = |ray: Ray| [ray.direction().to_glam(), ray.origin().to_glam()];
        let triples = cameras.into_iter().flat_map(rays).flat_map(triples);
        Ok(triples.map(|v| not_numbers(v.into())).sum::<usize>())
    });
    let [one, nine] = [1.0, 9.0].map(|n| protocol::bracket_of_the_course(0.0, n));
    let theirs = [[one, one, 0.0], [one, nine, 0.0], [nine, one, 0.0]].map(not_numbers);
    [ours, theirs.iter().sum::<usize>().into()]
}

/// The axis u of a camera. The protocol does not check gaze and up vector.
fn u(gaze: Vector3, up: Vector3) -> [Outcome; 2] {
    let ours = Basis::new(Point3::ORIGIN, gaze, up).map(|basis| array(basis.u));
    [ours.into(), array(protocol::axes(gaze, up)[0]).into()]
}

/// Greatest deviation of the axes from being perpendicular and of length 1.
fn defect(Basis { u, v, w, .. }: Basis) -> f64 {
    let lengths = [u, v, w].map(|axis| axis.dot(axis) - 1.0);
    greatest([u.dot(v), v.dot(w), w.dot(u)].into_iter().chain(lengths))
}

/// The defect of the axes for a random gaze and an up vector 2.6e-12 beside it.
fn almost_parallel(n: u32) -> Option<f64> {
    let random = PixelRandom::new(31, n, 0);
    let [gaze, other] = [0, 3].map(|first| {
        let [x, y, z] = [0, 1, 2].map(|i| random.uniform(first + i) - 0.5);
        Vector3::new(x, y, z)
    });
    let gaze = gaze.normalized()?;
    let up = gaze + gaze.cross(other).normalized()? * 2.6e-12;
    Basis::new(Point3::ORIGIN, gaze, up).ok().map(defect)
}

#[rustfmt::skip]
fn axes() -> Vec<Case> {
    let right = [1.0, 0.0, 0.0];
    let (slanted, near) = (Vector3::new(1.0, 2.0, 3.0), Vector3::new(1.0 + 1e-11, 2.0, 3.0));
    vec![
        case("E12", "axes, gaze = up = (0, 1, 0)", u(UP, UP), Refused, Equal, Fails),
        case("E13", "axes, gaze = 2 up, up = (1, 2, 3)", u(slanted * 2.0, slanted), Refused, Equal, Fails),
        case("E14", "u of gaze (1, 2, 3) and up (1+1e-11, 2, 3)",
            u(slanted, near), [0.0, 0.832_050_294_337_843_7, -0.554_700_196_225_229_1], Absolute(1e-3), Holds),
        Case::new("E31", "gaze and up 2.6e-12 apart: how far axes are from right angles, greatest of 10,000",
            0.0, Absolute(4.0 * f64::EPSILON / 2.6e-12), greatest((0..10_000).filter_map(almost_parallel))),
        case("E15", "axes, gaze = 0", u(Vector3::default(), UP), Refused, Equal, Fails),
        case("E16", "u of gaze (0, 0, -1e200)", u(AHEAD * 1e200, UP), right, Equal, Fails),
        case("E17", "u of up (0, 1e-170, 0)", u(AHEAD, UP * 1e-170), right, Equal, Fails),
    ]
}

#[rustfmt::skip]
fn pinhole() -> Vec<Case> {
    /// 1 / sqrt(3).
    const THIRD: f64 = 0.577_350_269_189_625_8;
    // Through a place of the picture, counted from its upper left corner.
    let ours = |[w, h]: [u32; 2], x, y| tried(|| {
        let camera = PinholeCamera::new(Point3::ORIGIN, FRAC_PI_2)?;
        Ok(array(camera.generate_ray(Size::new(w, h)?, x, y).direction()))
    });
    let theirs = |size: [u32; 2], x, y| array(protocol::pinhole_direction(size.map(f64::from), x, y, FRAC_PI_2));
    let both = |size, x, y| [ours(size, x, y), theirs(size, x, y).into()];
    let far = Vector3::new(0.0, 0.0, -2.0);
    let of_pixel = tried(|| {
        let camera = PinholeCamera::new(Point3::ORIGIN, FRAC_PI_2)?;
        Ok(array(camera.ray_for(Size::new(3, 3)?, 1.0, 1.0).direction()))
    });
    let sky = Ray::new(Point3::ORIGIN, far).and_then(|ray| ray.bounded(f64::INFINITY));
    vec![
        Case::new("E26", "pinhole, 3x3, middle of the middle pixel: through its corner",
            array(AHEAD), Equal, of_pixel).protocol(Fails, theirs([3, 3], 1.0, 1.0)),
        Case::new("E27", "pinhole, 3x601, middle (1.5, 300.5): sizes halved as whole numbers",
            array(AHEAD), Equal, ours([3, 601], 1.5, 300.5))
            .protocol(Fails, array(protocol::pinhole_direction_of_whole_sizes([3, 601], 1.5, 300.5, FRAC_PI_2))),
        case("E28", "pinhole, 10x10, corner (10, 10), which the text's loop leaves out",
            both([10, 10], 10.0, 10.0), [THIRD, -THIRD, -THIRD], Ulps(2.0), Holds),
        Case::new("E29", "the point at t = 50 on a ray to the sky, which the text bounds by 30",
            [0.0, 0.0, -50.0], Equal, sky.map(|ray| ray.at(50.0)).ok().flatten().map(array))
            .protocol(Fails, protocol::point_at(Point3::ORIGIN, far, 30.0, 50.0).map(array)),
        case("E30", "pinhole, 2x2, upper edge in the middle: 45 degrees up",
            both([2, 2], 1.0, 0.0), [0.0, FRAC_1_SQRT_2, -FRAC_1_SQRT_2], Ulps(2.0), Holds),
    ]
}
