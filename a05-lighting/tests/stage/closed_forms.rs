//! Whole pictures against integrals that are known in closed form: camera,
//! intersection, light and material together.
//!
//! A picture is a grid of samples at a distance of h. Where the integrand jumps
//! along a circle of radius r, about 8 r / h cells are cut and counted wrongly
//! by up to half of themselves, as if at random: of the area π r² that is a
//! standard deviation of sqrt(8 r / h / 12) h² / (π r²) = 0.26 (h / r)^1.5. The
//! tolerance is five deviations. Centres lie off the grid, lest the errors of
//! all octants be equal.

use std::f64::consts::PI;

use a02_math::{Point3, Vector3};
use a03_rays_cameras::{OrthographicCamera, render};
use a04_intersections::{Plane, Sphere};
use a05_lighting::{DirectionalLight, Lambert, LitWorld, Material, Phong, SpotLight};
use approx::assert_abs_diff_eq;
use common::{Color, Sampling, Settings, Size};

/// Pixels along each side of the pictures, samples along each side of a pixel,
/// and the side of the square that the pictures show.
const PIXELS: u32 = 200;
const SAMPLES: u32 = 3;
const VIEW: f64 = 2.2;
/// The distance from the middle of the first pixel to the middle of the last is `VIEW`.
const PIXEL: f64 = VIEW / (PIXELS as f64 - 1.0);

fn tolerance(r: f64) -> f64 {
    let h_by_r = PIXEL / f64::from(SAMPLES) / r;
    5.0 * 0.26 * h_by_r * h_by_r.sqrt()
}

/// The integral of the red channel over the view of a camera straight above the
/// origin.
fn integral(world: &LitWorld) -> f64 {
    let (e, down) = (Point3::new(0.0, 0.0, 9.0), Vector3::new(0.0, 0.0, -1.0));
    let camera = OrthographicCamera::new(e, down, Vector3::new(0.0, 1.0, 0.0), VIEW).unwrap();
    let settings = Settings {
        size: Size::new(PIXELS, PIXELS).unwrap(),
        sampling: Sampling::Regular,
        samples: SAMPLES * SAMPLES,
        ..Settings::default()
    };
    let image = render(&camera, |ray| world.color_for(ray), &settings, &()).unwrap();
    assert_eq!(image.count_non_finite(), 0);
    image.pixels().iter().map(|color| color.r).sum::<f64>() * PIXEL * PIXEL
}

/// Half way between places of the grid and others, in no simple relation.
const CENTRE: Point3 = Point3::new(0.012_3, -0.027_1, 0.0);

fn dark() -> LitWorld {
    LitWorld::new(Color::BLACK, Color::BLACK).unwrap()
}

/// The unit sphere, under a directional light that comes from `angle` beside
/// the camera.
fn lit_sphere(material: impl Material + 'static, angle: f64) -> LitWorld {
    let travel = Vector3::new(-libm::sin(angle), 0.0, -libm::cos(angle));
    dark()
        .with(Sphere::new(CENTRE, 1.0).unwrap(), Box::new(material))
        .lit_by(Box::new(
            DirectionalLight::new(Color::WHITE, travel).unwrap(),
        ))
}

/// Lambert's phase law: at a phase angle a, the mean over the disc is
/// (2/3) (sin a + (π - a) cos a) / π.
#[test]
fn a_matt_sphere_has_the_phases_of_the_moon() {
    for a in [0.0, 0.5, 1.0, 2.0, 3.0, PI] {
        let world = lit_sphere(Lambert::new(Color::WHITE).unwrap(), a);
        let expected = 2.0 / 3.0 * (libm::sin(a) + (PI - a) * libm::cos(a)) / PI;
        assert_abs_diff_eq!(integral(&world) / PI, expected, epsilon = tolerance(1.0));
    }
}

/// With the light behind the eye, `e · r = 1 - 2 s` where s is the squared
/// distance from the middle; its power, where positive, has the mean
/// 1 / (2 (p + 1)). At p = 0 the highlight ends abruptly at s = 1/2, and the
/// common mistake of taking 0 to the power of 0 gives 1 instead of 1/2.
#[test]
fn the_mean_highlight_of_a_sphere_is_known_for_every_exponent() {
    for p in [0.0, 1.0, 4.0] {
        let material = Phong::new(Color::BLACK, Color::WHITE, p).unwrap();
        let mean = integral(&lit_sphere(material, 0.0)) / PI;
        let expected = 1.0 / (2.0 * (p + 1.0));
        assert_abs_diff_eq!(mean, expected, epsilon = tolerance(0.5_f64.sqrt()));
    }
}

/// A smooth highlight is integrated by a grid to the last digits: nearly
/// exp(-2 p s), its error is about exp(-π² / (2 p h²)), below 1e-300 at these p
/// and h. The remaining error is the rounding of the cosine, p times as large as
/// power, 4 eps each.
#[test]
fn the_mean_of_a_smooth_highlight_is_right_to_rounding() {
    for p in [64.0, 256.0] {
        let material = Phong::new(Color::BLACK, Color::WHITE, p).unwrap();
        let mean = integral(&lit_sphere(material, 0.0)) / PI;
        let expected = 1.0 / (2.0 * (p + 1.0));
        let rounding = 4.0 * f64::EPSILON * p * expected;
        assert_abs_diff_eq!(mean, expected, epsilon = rounding);
    }
}

/// A spot light at height h above a plane lights a disc of radius
/// h tan(half angle), here made 0.9; at each of its points `n · l` is
/// h / sqrt(h² + s²), whose integral is 2 π h (sqrt(h² + r²) - h).
#[test]
fn a_spot_light_lights_the_disc_in_its_cone() {
    let (r, down) = (0.9, Vector3::new(0.0, 0.0, -1.0));
    for half_angle in [0.2, 0.8, 1.4] {
        let height = r / libm::tan(half_angle);
        let place = CENTRE - down * height;
        let spot = SpotLight::new(Color::WHITE, place, down, half_angle).unwrap();
        let floor = Plane::new(Point3::ORIGIN, (-down).as_normal()).unwrap();
        let matt = Lambert::new(Color::WHITE).unwrap();
        let world = dark().with(floor, Box::new(matt)).lit_by(Box::new(spot));
        let expected = 2.0 * PI * height * ((height * height + r * r).sqrt() - height);
        let area = PI * r * r;
        assert_abs_diff_eq!(
            integral(&world) / area,
            expected / area,
            epsilon = tolerance(r)
        );
    }
}
