//! Compares cameras: ray by ray, for eyes, gazes and pictures of all kinds.

use a02_math::{Point3, Vector3};
use a03_rays_cameras::Camera;
use common::{ArgumentError, Size};
use testing::exercise::{Answer, Check, random};

/// Eye, gaze, up, the camera's own parameter, width and height, and the place in the picture.
pub type View = ([f64; 3], [f64; 3], [f64; 3], f64, [u32; 2], [f64; 2]);

/// A camera at the origin that looks along -z, up along y, at these places in pictures of
/// 5 by 3 pixels.
pub fn ahead(parameter: f64) -> impl Iterator<Item = View> {
    let places = [[2.0, 1.0], [0.0, 1.0], [2.0, 0.0], [4.0, 2.0], [2.5, 0.5]];
    let (e, g, up) = ([0.0; 3], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]);
    places
        .map(|place| (e, g, up, parameter, [5, 3], place))
        .into_iter()
}

/// Compares a camera with the lesson's, for parameters of this name from 0 to `most`.
pub fn compare<L: Camera, Y: Camera>(
    check: &mut Check,
    name: &str,
    most: f64,
    lesson: impl Fn(Point3, Vector3, Vector3, f64) -> Result<L, ArgumentError>,
    yours: impl Fn(Point3, Vector3, Vector3, f64) -> Result<Y, ArgumentError>,
) {
    let words =
        format!("eye {{}}, gaze {{}}, up {{}}, {name} {{}}, picture of {{}} pixels, place {{}}");
    let any = random(|r| {
        let [e, g, up] = [(); 3].map(|()| r.triple(5.0));
        let [width, height] = [(); 2].map(|()| 2 + r.below(99));
        let [x, y] = [width, height].map(|n| r.between(-0.5, f64::from(n) - 0.5));
        (e, g, up, r.between(0.1, most), [width, height], [x, y])
    });
    check.compare(
        &words,
        ahead(1.0),
        any,
        |view| ray(view, &lesson),
        |view| ray(view, &yours),
    );
}

fn ray<C: Camera>(
    (e, g, up, parameter, [width, height], [x, y]): View,
    new: impl Fn(Point3, Vector3, Vector3, f64) -> Result<C, ArgumentError>,
) -> Answer {
    let e = Point3::from_glam(e.into());
    let [g, up] = [g, up].map(|v| Vector3::from_glam(v.into()));
    let (Ok(camera), Ok(size)) = (new(e, g, up, parameter), Size::new(width, height)) else {
        return Answer::words("no camera");
    };
    let ray = camera.ray_for(size, x, y);
    Answer::named("origin", ray.origin().to_glam().to_array())
        .and("direction", ray.direction().to_glam().to_array())
}
