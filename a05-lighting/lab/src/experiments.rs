//! Error against run time for lights and materials.

mod phong;

use std::f64::consts::PI;
use std::rc::Rc;

use a02_math::{Direction, Point3, Vector3};
use a03_rays_cameras::{OrthographicCamera, PixelRandom, render};
use a04_intersections::Sphere;
use common::{ArgumentError, Color, Error, Settings, Size};
use measure::experiment::{Axis, Curve, Experiment, Point, Unit};

use crate::protocol;
use a05_lighting::{DirectionalLight, Lambert, Light, LitWorld, SpotLight};

pub fn experiments() -> Vec<Experiment<'static>> {
    vec![lambert_phase(), phong::power(), spot_rim()]
}

const VIEW: f64 = 2.4;

/// The whole renderer against a closed form: the brightness of a matt ball, the
/// moon for example, depends only on the angle between the light and the eye. At
/// the phase angle a its mean brightness is `(2/3) (sin a + (π - a) cos a) / π`.
/// (Lambert, Photometria, 1760)
///
/// The pixels at the edge count as a whole or not at all: an error of `n^(-3/2)`
/// for n pixels across. At full moon the edge is dark, and the error of these
/// pixels is smaller: `n^-2`.
fn lambert_phase() -> Experiment<'static> {
    Experiment::new("lambert-phase")
        .asking("How many pixels does the mean brightness of a matt ball need?")
        .of_problems()
        .over(Axis::Work, "pixels across", "rays")
        .with_error("rms error of the mean brightness")
        .with_unit(Unit::Other("full moon = 2/3"))
        .with_exact("against the closed form, for random balls")
        .with_seeds(&[1760])
        .with_curves(|effort| {
            let balls = effort.choose(48, 96) as u32;
            let sizes = &[32, 48, 64, 96, 128, 192, 256][..effort.choose(5, 7)];
            let point = |phase: f64, pixels: u32| {
                let mean = move |ball| mean_brightness(phase, pixels, ball).unwrap_or(f64::NAN);
                let sin = libm::sin(phase);
                let exact = 2.0 / 3.0 * (sin + (PI - phase) * libm::cos(phase)) / PI;
                let errors: Vec<_> = (0..balls).map(|ball| mean(ball) - exact).collect();
                let pixels = f64::from(pixels);
                let rays = f64::from(balls) * pixels * pixels;
                Point::new(pixels, rays, errors, move || {
                    (0..balls).map(mean).sum::<f64>()
                })
            };
            let curve = |phase, method, slope: f64| {
                let points = sizes.iter().map(|pixels| point(phase, *pixels));
                Curve::new(method, points).with_slope(slope, (0.0, f64::INFINITY))
            };
            vec![
                curve(0.0, "full", -1.0),
                curve(0.5, "phase 0.5", -0.75),
                curve(1.0, "phase 1", -0.75),
                curve(2.0, "phase 2", -0.75),
            ]
        })
}

/// The mean brightness of a ball whose centre and radius are no multiples of a
/// pixel.
fn mean_brightness(phase: f64, pixels: u32, ball: u32) -> Result<f64, Error> {
    let across = f64::from(pixels);
    let pixel = VIEW / across;
    let random = PixelRandom::new(1760, ball, 0);
    let centre = Point3::new(random.uniform(0) * pixel, random.uniform(1) * pixel, 0.0);
    let radius = 0.8 + 0.3 * random.uniform(2);
    let light = Vector3::new(-libm::sin(phase), 0.0, -libm::cos(phase));
    let white = Box::new(Lambert::new(Color::WHITE)?);
    let world = LitWorld::new(Color::BLACK, Color::BLACK)?
        .with(Sphere::new(centre, radius)?, white)
        .lit_by(Box::new(DirectionalLight::new(Color::WHITE, light)?));

    // The camera's `s` is the distance from the first row of pixels to the last.
    let (gaze, up) = (Vector3::new(0.0, 0.0, -1.0), Vector3::new(0.0, 1.0, 0.0));
    let s = pixel * (across - 1.0);
    let camera = OrthographicCamera::new(Point3::new(0.0, 0.0, 9.0), gaze, up, s)?;
    let settings = Settings {
        size: Size::new(pixels, pixels)?,
        ..Settings::default()
    };
    let image = render(&camera, |ray| world.color_for(ray), &settings, &())?;
    let sum: f64 = image.pixels().iter().map(|color| color.r).sum();
    Ok(sum * pixel * pixel / (PI * radius * radius))
}

const HALF_ANGLE: f64 = 1e-3;
const COS_HALF_ANGLE: f64 = 0.999_999_500_000_041_7;
const DIRECTION: Vector3 = Vector3::new(1.0, 2.0, 3.0);

/// One half of the points lies inside and one outside, all at the same distance from the rim;
/// every eighth lies straight behind.
fn spot_rim() -> Experiment<'static> {
    Experiment::new("spot-rim")
        .asking("How near to the rim of a spot light is inside told from outside?")
        .over(Axis::Parameter, "from rim (half angles)", "points")
        .with_error("fraction of points judged wrongly")
        .with_unit(Unit::Share)
        .with_exact("against the side on which a point was put; one in eight lies behind")
        .with_seeds(&[12])
        .with_curves(|effort| {
            let count = effort.choose(4_096, 65_536) as u32;
            let parameters = [1e-2, 1e-4, 1e-6, 1e-8, 1e-9, 1e-10, 1e-11];
            let tasks = parameters
                .map(|parameter| (parameter, tasks(parameter, count).unwrap_or_default()));
            let curve = |method, illuminates: fn(&SpotLight, Point3) -> bool| {
                let lit = move |(light, point, _): &Task| illuminates(light, *point);
                Curve::of_decisions(method, &tasks, lit, |(.., is_lit), lit| lit != *is_lit)
            };
            // Rounding is far below a billionth of the half angle.
            let far = 1e-9..=1.0;
            vec![
                curve("arc cosine (protocol)", |_, p| {
                    protocol::spot_light_illuminates(Point3::ORIGIN, DIRECTION, HALF_ANGLE, p)
                }),
                // As the renderer's light decides, but without a direction of length 1.
                curve("cosines", |_, p| {
                    let v = p - Point3::ORIGIN;
                    let lengths = (v.dot(v) * DIRECTION.dot(DIRECTION)).sqrt();
                    v.dot(DIRECTION) >= COS_HALF_ANGLE * lengths
                })
                .with_bound(0.0, far.clone()),
                curve("cosines, as rendered", Light::illuminates).with_bound(0.0, far),
                curve("arc tangent", |_, p| {
                    DIRECTION.angle(p - Point3::ORIGIN) <= HALF_ANGLE
                }),
            ]
        })
}

/// A light at the origin, and a point on which it shines or not.
type Task = (SpotLight, Point3, bool);

/// Points near the rim of the light's cone.
fn tasks(parameter: f64, count: u32) -> Result<Rc<[Task]>, ArgumentError> {
    let light = SpotLight::new(Color::WHITE, Point3::ORIGIN, DIRECTION, HALF_ANGLE)?;
    let w = DIRECTION.unit("direction")?;
    let u = w.cross(Vector3::new(0.0, 1.0, 0.0)).unit("u")?;
    let v = w.cross(u);
    let points = (0..count).map(|i| {
        let random = PixelRandom::new(12, i, 0);
        let distance = 1.0 + 9.0 * random.uniform(0);
        if i % 8 == 0 {
            return (light, Point3::ORIGIN - DIRECTION * distance, false);
        }
        let inside = random.uniform(1) < 0.5;
        let angle = HALF_ANGLE
            * if inside {
                1.0 - parameter
            } else {
                1.0 + parameter
            };
        let around = 6.3 * random.uniform(2);
        let aside = u * libm::cos(around) + v * libm::sin(around);
        let way = w * libm::cos(angle) + aside * libm::sin(angle);
        (light, Point3::ORIGIN + way * distance, inside)
    });
    Ok(points.collect())
}
