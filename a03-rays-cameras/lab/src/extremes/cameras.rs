//! Cameras: fields of view, brackets, axes, and pictures of few pixels. Exact directions are
//! computed from the given doubles with 80 digits.

use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2, FRAC_PI_4, FRAC_PI_8, PI};

use a02_lab::condition::{condition, cross, three, unit};
use a02_math::arrays::array;
use a02_math::{Direction, Point3, Vector3};
use common::{ArgumentError, Size};
use measure::extremes::{
    Absolute, Case, Fails, Holds, Known, Number, Outcome, Refused, Triple, Ulps, greatest, tried,
};

use super::{AHEAD, UP};
use crate::protocol;
use a03_rays_cameras::{
    Basis, Camera, OrthographicCamera, PerspectiveCamera, PinholeCamera, PixelRandom, Ray,
};

pub fn cases() -> Vec<Case> {
    [perspective(), orthographic(), axes(), pinhole()].concat()
}

/// The middle of a pixel of a picture, counted from below.
#[derive(Clone, Copy)]
struct Pixel {
    width: u32,
    height: u32,
    x: f64,
    y: f64,
}

impl Pixel {
    /// The first pixel of a picture of 640x480.
    const CORNER: Self = Self::first(640, 480);

    /// The first pixel of a picture.
    const fn first(width: u32, height: u32) -> Self {
        Self {
            width,
            height,
            x: 0.0,
            y: 0.0,
        }
    }

    /// The direction through it of the perspective camera at the origin with this full angle.
    fn direction(self, angle: f64) -> Result<[f64; 3], ArgumentError> {
        let camera = PerspectiveCamera::new(Point3::ORIGIN, AHEAD, UP, angle)?;
        let size = Size::new(self.width, self.height)?;
        Ok(array(camera.ray_for(size, self.x, self.y).direction()))
    }

    /// The same by the protocol's formula, with an angle that it takes for the full one.
    fn protocols_direction(self, angle: f64) -> [f64; 3] {
        let size = [self.width, self.height].map(f64::from);
        array(protocol::perspective_direction(size, self.x, self.y, angle))
    }

    /// The direction for half of an angle: with it the text's formula is right.
    fn half_angle(self, half_angle: f64) -> Case {
        let ours = self.direction(2.0 * half_angle);
        Case::of(ours, self.protocols_direction(half_angle))
    }
}

/// The offset of the origin of a column's ray in the orthographic camera, in widths of
/// the picture.
fn bracket(column: f64, width: u32, formula: fn(f64, f64) -> f64) -> Case {
    let ours = tried(|| {
        let camera = OrthographicCamera::new(Point3::ORIGIN, AHEAD, UP, 1.0)?;
        let ray = camera.ray_for(Size::new(width, width)?, column, 0.0);
        Ok(ray.origin().x())
    });
    Case::of(ours, formula(column, width.into()))
}

fn perspective() -> Vec<Case> {
    let middle_of_the_top = Pixel {
        width: 641,
        height: 481,
        x: 320.0,
        y: 480.0,
    };
    let top_of_a_column = Pixel {
        width: 1,
        height: 100,
        x: 0.0,
        y: 99.0,
    };
    vec![
        Case {
            id: "E01",
            what: "perspective, half angle 0".into(),
            exact: Refused,
            protocol: Fails,
            ..Pixel::CORNER.half_angle(0.0)
        },
        Case {
            id: "E02",
            what: "perspective, half angle 1e-200".into(),
            exact: Refused,
            protocol: Fails,
            ..Pixel::CORNER.half_angle(1e-200)
        },
        Case {
            id: "E03",
            what: "perspective, half angle pi/2".into(),
            exact: Refused,
            protocol: Fails,
            ..Pixel::CORNER.half_angle(FRAC_PI_2)
        },
        Case {
            id: "E04",
            what: "perspective, half angle pi: looks back".into(),
            exact: Refused,
            protocol: Fails,
            ..Pixel::CORNER.half_angle(PI)
        },
        Case {
            id: "E05",
            what: "perspective, half angle -pi/4".into(),
            exact: Refused,
            protocol: Fails,
            ..Pixel::CORNER.half_angle(-FRAC_PI_4)
        },
        Case {
            id: "E06",
            what: "perspective, half angle pi/4, picture of 1x1".into(),
            exact: Triple(array(AHEAD)),
            condition: Known(0.0),
            protocol: Holds,
            ..Pixel::first(1, 1).half_angle(FRAC_PI_4)
        },
        Case {
            id: "E07",
            what: "perspective, half angle pi/4, 1x100, pixel (0, 99)".into(),
            exact: Triple([0.0, 0.703_544_597_920_105_2, -0.710_651_109_010_207_3]),
            condition: Known(of_direction(FRAC_PI_4, [0.0, 0.99])),
            bound: Ulps(2.0),
            protocol: Holds,
            ..top_of_a_column.half_angle(FRAC_PI_4)
        },
        Case {
            id: "E08",
            what: "perspective, picture of 0x0".into(),
            exact: Refused,
            protocol: Fails,
            ..Pixel::first(0, 0).half_angle(FRAC_PI_4)
        },
        Case {
            id: "E09",
            what: "perspective, half angle NaN".into(),
            exact: Refused,
            protocol: Fails,
            ..Pixel::CORNER.half_angle(f64::NAN)
        },
        Case {
            id: "E24",
            what: "perspective, FULL angle pi/4, 641x481, middle of the top row".into(),
            exact: Triple([0.0, 0.382_004_035_507_720_3, -0.924_160_655_327_75]),
            condition: Known(of_direction(FRAC_PI_8, [0.0, 480.0 / 481.0])),
            bound: Ulps(2.0),
            protocol: Fails,
            ..Case::of(
                middle_of_the_top.direction(FRAC_PI_4),
                middle_of_the_top.protocols_direction(FRAC_PI_4),
            )
        },
    ]
}

/// The condition of a direction through a position in the picture, from -1 to 1, in numbers of the half angle
/// alone: `T' α / T = α (1 + T²) / T` is that of its tangent T.
fn of_direction(half_angle: f64, position: [f64; 2]) -> f64 {
    let tangent = libm::tan(half_angle);
    let of_tangent = half_angle * (1.0 + tangent * tangent) / tangent;
    let of_direction = condition(&[tangent], |tangent| {
        let [x, y] = position.map(|x| tangent[0] * x.into());
        unit([x, y, (-1.0).into()])
    });
    of_tangent * of_direction
}

/// The condition of the axis u, which lies across gaze and up vector.
fn condition_of_u(gaze: Vector3, up: Vector3) -> f64 {
    let numbers = [array(gaze), array(up)].concat();
    condition(&numbers, |x| unit(cross(three(x, 0), three(x, 3))))
}

fn orthographic() -> Vec<Case> {
    vec![
        Case {
            id: "E10",
            what: "orthographic, column 639 of 640, bracket of the text's code".into(),
            exact: Number(0.5),
            condition: Known(1.0),
            protocol: Fails,
            ..bracket(639.0, 640, protocol::bracket_of_the_code)
        },
        Case {
            id: "E25",
            what: "orthographic, column 0 of 640, fraction of the text's formula".into(),
            exact: Number(-0.5),
            condition: Known(1.0),
            protocol: Fails,
            ..bracket(0.0, 640, protocol::bracket_of_the_formula)
        },
        Case {
            id: "E11",
            what: "orthographic, the only column of 1, divided by w - 1".into(),
            exact: Number(0.0),
            protocol: Fails,
            ..bracket(0.0, 1, protocol::bracket_of_the_course)
        },
        Case {
            id: "Q11",
            what: "pictures of 1x1, 1x9 and 9x1: coordinates that are no numbers".into(),
            exact: Number(0.0),
            protocol: Fails,
            ..pictures_of_few_pixels()
        },
    ]
}

/// Number of NaN values in the rays of pictures of one row, one column or one pixel.
fn pictures_of_few_pixels() -> Case {
    let ours = tried(|| {
        let cameras: [Box<dyn Camera>; 3] = [
            Box::new(OrthographicCamera::new(Point3::ORIGIN, AHEAD, UP, 1.0)?),
            Box::new(PerspectiveCamera::new(Point3::ORIGIN, AHEAD, UP, 1.0)?),
            Box::new(PinholeCamera::new(Point3::ORIGIN, 1.0)?),
        ];
        let mut count = 0;
        for camera in cameras {
            for (width, height) in [(1, 1), (1, 9), (9, 1)] {
                let ray = camera.ray_for(Size::new(width, height)?, 0.0, 0.0);
                count += not_finite(ray.direction().to_glam().into());
                count += not_finite(ray.origin().to_glam().into());
            }
        }
        Ok(count)
    });
    let [one, nine] = [1.0, 9.0].map(|n| protocol::bracket_of_the_course(0.0, n));
    let mut theirs = 0;
    for offset in [[one, one, 0.0], [one, nine, 0.0], [nine, one, 0.0]] {
        theirs += not_finite(offset);
    }
    Case::of(ours, theirs)
}

/// How many of these are infinite or no numbers.
fn not_finite(numbers: [f64; 3]) -> usize {
    numbers.iter().filter(|x| !x.is_finite()).count()
}

/// The axis u of a camera. The protocol does not check gaze and up vector.
fn u(gaze: Vector3, up: Vector3) -> Case {
    let ours = Basis::new(Point3::ORIGIN, gaze, up).map(|basis| array(basis.u));
    let [theirs, _, _] = protocol::axes(gaze, up);
    Case::of(ours, array(theirs))
}

/// Greatest deviation of the axes from being perpendicular and of length 1.
fn defect(Basis { u, v, w, .. }: Basis) -> f64 {
    let cosines = [u.dot(v), v.dot(w), w.dot(u)];
    let lengths = [u, v, w].map(|axis| axis.dot(axis) - 1.0);
    greatest(cosines.into_iter().chain(lengths))
}

/// The greatest defect of the axes for random gazes and an up vector 2.6e-12 beside them.
fn defect_of_almost_parallel() -> Outcome {
    let mut defects = Vec::new();
    for n in 0..10_000 {
        let random = PixelRandom::new(31, n, 0);
        let [gaze, other] = [0, 3].map(|first| {
            let [x, y, z] = [0, 1, 2].map(|i| random.uniform(first + i) - 0.5);
            Vector3::new(x, y, z)
        });
        if let Some(basis) = almost_parallel(gaze, other) {
            defects.push(defect(basis));
        }
    }
    greatest(defects).into()
}

fn almost_parallel(gaze: Vector3, other: Vector3) -> Option<Basis> {
    let gaze = gaze.normalized()?;
    let across = gaze.cross(other).normalized()?;
    Basis::new(Point3::ORIGIN, gaze, gaze + across * 2.6e-12).ok()
}

fn axes() -> Vec<Case> {
    let right = Triple([1.0, 0.0, 0.0]);
    let slanted = Vector3::new(1.0, 2.0, 3.0);
    let near = Vector3::new(1.0 + 1e-11, 2.0, 3.0);
    vec![
        Case {
            id: "E12",
            what: "axes, gaze = up = (0, 1, 0)".into(),
            exact: Refused,
            protocol: Fails,
            ..u(UP, UP)
        },
        Case {
            id: "E13",
            what: "axes, gaze = 2 up, up = (1, 2, 3)".into(),
            exact: Refused,
            protocol: Fails,
            ..u(slanted * 2.0, slanted)
        },
        Case {
            id: "E14",
            what: "u of gaze (1, 2, 3) and up (1+1e-11, 2, 3)".into(),
            exact: Triple([0.0, 0.832_050_294_337_843_7, -0.554_700_196_225_229_1]),
            condition: Known(condition_of_u(slanted, near)),
            // Both crossed vectors are rounded.
            bound: Ulps(condition_of_u(slanted, near)),
            protocol: Holds,
            ..u(slanted, near)
        },
        Case {
            id: "E31",
            what:
                "gaze and up 2.6e-12 apart: how far axes are from right angles, greatest of 10,000"
                    .into(),
            exact: Number(0.0),
            bound: Absolute(4.0 * f64::EPSILON / 2.6e-12),
            ours: defect_of_almost_parallel(),
            ..Case::default()
        },
        Case {
            id: "E15",
            what: "axes, gaze = 0".into(),
            exact: Refused,
            protocol: Fails,
            ..u(Vector3::default(), UP)
        },
        Case {
            id: "E16",
            what: "u of gaze (0, 0, -1e200)".into(),
            exact: right,
            condition: Known(0.0),
            protocol: Fails,
            ..u(AHEAD * 1e200, UP)
        },
        Case {
            id: "E17",
            what: "u of up (0, 1e-170, 0)".into(),
            exact: right,
            condition: Known(0.0),
            protocol: Fails,
            ..u(AHEAD, UP * 1e-170)
        },
    ]
}

/// The direction of the pinhole camera through a position in the picture, counted from its upper
/// left corner.
fn through([width, height]: [u32; 2], x: f64, y: f64) -> Case {
    let ours = tried(|| {
        let camera = PinholeCamera::new(Point3::ORIGIN, FRAC_PI_2)?;
        let ray = camera.generate_ray(Size::new(width, height)?, x, y);
        Ok(array(ray.direction()))
    });
    let size = [width, height].map(f64::from);
    let theirs = protocol::pinhole_direction(size, x, y, FRAC_PI_2);
    Case::of(ours, array(theirs))
}

/// The direction through the middle of a pixel, where the protocol has its corner.
fn through_the_middle(size: [u32; 2], x: f64, y: f64) -> Case {
    let ours = tried(|| {
        let camera = PinholeCamera::new(Point3::ORIGIN, FRAC_PI_2)?;
        let ray = camera.ray_for(Size::new(size[0], size[1])?, x, y);
        Ok(array(ray.direction()))
    });
    Case {
        ours,
        ..through(size, x, y)
    }
}

/// The direction where the protocol halves the size as a whole number.
fn of_whole_sizes(size: [u32; 2], x: f64, y: f64) -> Case {
    let theirs = protocol::pinhole_direction_of_whole_sizes(size, x, y, FRAC_PI_2);
    Case {
        theirs: Some(array(theirs).into()),
        ..through(size, x, y)
    }
}

/// The point at t = 50 of a ray to the sky.
fn far_point() -> Case {
    let far = Vector3::new(0.0, 0.0, -2.0);
    let ours = tried(|| {
        let ray = Ray::new(Point3::ORIGIN, far)?;
        Ok(ray.bounded(f64::INFINITY)?.at(50.0).map(array))
    });
    let theirs = protocol::point_at(Point3::ORIGIN, far, 30.0, 50.0);
    Case::of(ours, theirs.map(array))
}

fn pinhole() -> Vec<Case> {
    /// 1 / sqrt(3).
    const THIRD: f64 = 0.577_350_269_189_625_8;
    vec![
        Case {
            id: "E26",
            what: "pinhole, 3x3, middle of the middle pixel: through its corner".into(),
            exact: Triple(array(AHEAD)),
            condition: Known(0.0),
            protocol: Fails,
            ..through_the_middle([3, 3], 1.0, 1.0)
        },
        Case {
            id: "E27",
            what: "pinhole, 3x601, middle (1.5, 300.5): sizes halved as whole numbers".into(),
            exact: Triple(array(AHEAD)),
            condition: Known(0.0),
            protocol: Fails,
            ..of_whole_sizes([3, 601], 1.5, 300.5)
        },
        Case {
            id: "E28",
            what: "pinhole, 10x10, corner (10, 10), which the text's loop leaves out".into(),
            exact: Triple([THIRD, -THIRD, -THIRD]),
            condition: Known(of_direction(FRAC_PI_4, [1.0, -1.0])),
            bound: Ulps(2.0),
            protocol: Holds,
            ..through([10, 10], 10.0, 10.0)
        },
        Case {
            id: "E29",
            what: "the point at t = 50 on a ray to the sky, which the text bounds by 30".into(),
            exact: Triple([0.0, 0.0, -50.0]),
            condition: Known(1.0),
            protocol: Fails,
            ..far_point()
        },
        Case {
            id: "E30",
            what: "pinhole, 2x2, upper edge in the middle: 45 degrees up".into(),
            exact: Triple([0.0, FRAC_1_SQRT_2, -FRAC_1_SQRT_2]),
            condition: Known(of_direction(FRAC_PI_4, [0.0, 1.0])),
            bound: Ulps(2.0),
            protocol: Holds,
            ..through([2, 2], 1.0, 0.0)
        },
    ]
}
