//! The scenes of this stage, with the student's code in them; and rays of cameras whose
//! opening and axes are known.

use std::f64::consts::FRAC_PI_2;

use a02_math::{Direction, Point3, Vector3};
use a03_rays_cameras::{Camera, PinholeCamera, StripeRule, StripedSky, stage};
use common::{ArgumentError, Error, Image, Settings, Size};
use measure::extremes::Bound;
use testing::exercise::{Check, Random};

/// Some roundings of coordinates up to 10.
const BOUND: Bound = Bound::Absolute(1e-12);

/// The camera of both scenes: the origin and an opening of 90 degrees.
pub fn camera() -> Result<PinholeCamera, ArgumentError> {
    PinholeCamera::new(Point3::ORIGIN, FRAC_PI_2)
}

/// Compares the scene of a rule with its lock.
pub fn expect_scene(
    check: &mut Check,
    rule: StripeRule,
    render: impl FnOnce(&Settings, &StripedSky) -> Result<Image, Error>,
) {
    let name = match rule {
        StripeRule::Direction => "striped-sky",
        StripeRule::Wall => "striped-sky-straight",
    };
    check.scene(&stage(), name, |settings| {
        let sky = StripedSky::new(&camera()?, settings.size, 10, rule)?;
        render(settings, &sky)
    });
}

/// A point of hundredths.
pub fn point(random: &mut Random) -> Point3 {
    Point3::from_glam(random.triple(9.0).into())
}

/// The axes of space.
pub fn axes() -> [Vector3; 3] {
    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    axes.map(|axis| Vector3::from_glam(axis.into()))
}

/// Three unit vectors perpendicular to each other.
pub fn frame(random: &mut Random) -> [Vector3; 3] {
    random.frame().map(|v| Vector3::from_glam(v.into()))
}

pub fn triple(v: Vector3) -> [f64; 3] {
    v.to_glam().to_array()
}

/// A camera of which everything is known: the eye, the axes to the right, upwards and
/// against the gaze, and the opening angle.
pub struct Known<'a> {
    pub camera: &'a dyn Camera,
    pub e: Point3,
    pub axes: [Vector3; 3],
    pub angle: f64,
    pub words: String,
}

impl Known<'_> {
    /// Expects the rays through the middle, the edges and other places of a picture.
    pub fn expect_rays(&self, check: &mut Check, random: &mut Random) {
        let (width, height) = (2 + random.below(90), 2 + random.below(90));
        let Ok(size) = Size::new(width, height) else {
            return;
        };
        let [w, h] = [width, height].map(f64::from);
        let mut at = |place: &str, right: f64, up: f64| {
            // From the middle of the picture, in halves of its height.
            let (x, y) = (
                (w - 1.0) / 2.0 + right * h / 2.0,
                (h - 1.0) / 2.0 + up * h / 2.0,
            );
            let tangent = libm::tan(self.angle / 2.0);
            let [u, v, w] = self.axes;
            let way = u * (right * tangent) + v * (up * tangent) - w;
            let exact = way * (1.0 / way.dot(way).sqrt());
            let ray = self.camera.ray_for(size, x, y);
            let words = format!("{}, picture of {size}, x = {x}, y = {y}", self.words);
            let origin = (ray.origin() - Point3::ORIGIN, self.e - Point3::ORIGIN);
            check.expect(
                format!("the origin; {words}"),
                triple(origin.1),
                BOUND,
                triple(origin.0),
            );
            let what = format!("the length of the direction; {words}");
            check.expect(what, 1.0, BOUND, ray.direction().magnitude());
            let what = format!("the direction {place}; {words}");
            check.expect(what, triple(exact), BOUND, triple(ray.direction()));
        };
        at("through the middle", 0.0, 0.0);
        at("at the upper edge", 0.0, 1.0);
        at("at the lower edge", 0.0, -1.0);
        at("at the right edge", w / h, 0.0);
        let (right, up) = (random.between(-1.0, 1.0), random.between(-1.0, 1.0));
        at("anywhere", right * w / h, up);
    }
}
