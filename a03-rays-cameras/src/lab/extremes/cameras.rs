//! Cameras: openings, brackets and pictures of few pixels. Exact directions are
//! computed from the given doubles with 80 digits.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

use a02_math::Point3;
use common::{ArgumentError, Size};
use measure::extremes::{Bound, Case, Outcome, Protocol};

use super::{AHEAD, UP, triple};
use crate::{Camera, OrthographicCamera, PerspectiveCamera, PinholeCamera, protocol};

pub fn cases() -> Vec<Case> {
    let mut cases = openings();
    cases.extend(brackets());
    cases.extend(pictures_of_few_pixels());
    cases
}

/// Direction through the middle of pixel (`px`, `py`), counted from below, of the
/// perspective camera at the origin.
fn direction(size: [u32; 2], px: f64, py: f64, angle: f64) -> Result<[f64; 3], ArgumentError> {
    let camera = PerspectiveCamera::new(Point3::ORIGIN, AHEAD, UP, angle)?;
    let ray = camera.ray_for(Size::new(size[0], size[1])?, px, py);
    Ok(triple(ray.direction()))
}

/// A row whose angle is half of the opening: with it the text's formula is right.
fn opening(
    id: &'static str,
    what: &str,
    exact: Outcome,
    bound: Bound,
    says: Protocol,
    (size, px, py, half): ([u32; 2], f64, f64, f64),
) -> Case {
    let ours = direction(size, px, py, 2.0 * half);
    let theirs = protocol::perspective_direction(size.map(f64::from), px, py, half);
    Case::new(id, what, exact, bound, ours).protocol(says, triple(theirs))
}

fn openings() -> Vec<Case> {
    const COURSE: [u32; 2] = [640, 480];
    let refused = |id, what, size, half| {
        let at = (size, 0.0, 0.0, half);
        opening(
            id,
            what,
            Outcome::Refused,
            Bound::Equal,
            Protocol::Fails,
            at,
        )
    };
    let full_angle = direction([641, 481], 320.0, 480.0, FRAC_PI_4);
    let full_angle_exact = [0.0, 0.382_004_035_507_720_3, -0.924_160_655_327_75];
    let theirs = protocol::perspective_direction([641.0, 481.0], 320.0, 480.0, FRAC_PI_4);
    vec![
        refused("E01", "perspective, half angle 0", COURSE, 0.0),
        refused("E02", "perspective, half angle 1e-200", COURSE, 1e-200),
        refused("E03", "perspective, half angle pi/2", COURSE, FRAC_PI_2),
        refused("E04", "perspective, half angle pi: looks back", COURSE, PI),
        refused("E05", "perspective, half angle -pi/4", COURSE, -FRAC_PI_4),
        opening(
            "E06",
            "perspective, half angle pi/4, picture of 1x1",
            triple(AHEAD).into(),
            Bound::Equal,
            Protocol::Holds,
            ([1, 1], 0.0, 0.0, FRAC_PI_4),
        ),
        opening(
            "E07",
            "perspective, half angle pi/4, 1x100, pixel (0, 99)",
            [0.0, 0.703_544_597_920_105_2, -0.710_651_109_010_207_3].into(),
            Bound::Ulps(2.0),
            Protocol::Holds,
            ([1, 100], 0.0, 99.0, FRAC_PI_4),
        ),
        refused("E08", "perspective, picture of 0x0", [0, 0], FRAC_PI_4),
        refused("E09", "perspective, half angle NaN", COURSE, f64::NAN),
        Case::new(
            "E24",
            "perspective, FULL angle pi/4, 641x481, middle of the top row",
            full_angle_exact,
            Bound::Ulps(2.0),
            full_angle,
        )
        .protocol(Protocol::Fails, triple(theirs)),
    ]
}

/// Offset of the origin of the ray of column `px`, in widths of the picture.
fn bracket(width: u32, px: f64) -> Result<f64, ArgumentError> {
    let camera = OrthographicCamera::new(Point3::ORIGIN, AHEAD, UP, 1.0)?;
    let ray = camera.ray_for(Size::new(width, width)?, px, 0.0);
    Ok(ray.origin().x())
}

fn brackets() -> Vec<Case> {
    let row = |id, what: &str, exact: f64, (p, w): (f64, u32), formula: fn(f64, f64) -> f64| {
        Case::new(id, what, exact, Bound::Equal, bracket(w, p))
            .protocol(Protocol::Fails, formula(p, f64::from(w)))
    };
    vec![
        row(
            "E10",
            "orthographic, column 639 of 640, bracket of the text's code",
            0.5,
            (639.0, 640),
            protocol::bracket_of_the_code,
        ),
        row(
            "E25",
            "orthographic, column 0 of 640, fraction of the text's formula",
            -0.5,
            (0.0, 640),
            protocol::bracket_of_the_formula,
        ),
        row(
            "E11",
            "orthographic, the only column of 1, divided by w - 1",
            0.0,
            (0.0, 1),
            protocol::bracket_of_the_course,
        ),
    ]
}

/// Number of NaN values among the rays' twelve numbers, for pictures of one row, one
/// column or one pixel.
fn pictures_of_few_pixels() -> Vec<Case> {
    let sizes = [(1, 1), (1, 9), (9, 1)];
    let no_numbers = |v: [f64; 3]| v.iter().filter(|x| !x.is_finite()).count();
    let ours = || -> Result<usize, ArgumentError> {
        let cameras: [Box<dyn Camera>; 3] = [
            Box::new(OrthographicCamera::new(Point3::ORIGIN, AHEAD, UP, 1.0)?),
            Box::new(PerspectiveCamera::new(Point3::ORIGIN, AHEAD, UP, 1.0)?),
            Box::new(PinholeCamera::new(Point3::ORIGIN, 1.0)?),
        ];
        let mut count = 0;
        for (w, h) in sizes {
            for camera in &cameras {
                let ray = camera.ray_for(Size::new(w, h)?, 0.0, 0.0);
                count += no_numbers(triple(ray.direction()));
                count += no_numbers(ray.origin().to_glam().to_array());
            }
        }
        Ok(count)
    };
    let bracket = |n| protocol::bracket_of_the_course(0.0, n);
    let theirs: usize = sizes
        .map(|(w, h)| no_numbers([bracket(f64::from(w)), bracket(f64::from(h)), 0.0]))
        .into_iter()
        .sum();
    vec![
        Case::new(
            "Q11",
            "pictures of 1x1, 1x9 and 9x1: coordinates that are no numbers",
            0_usize,
            Bound::Equal,
            ours(),
        )
        .protocol(Protocol::Fails, theirs),
    ]
}
