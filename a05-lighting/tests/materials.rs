//! Materials: colours calculated by hand, and what must not shine.

use a02_math::{Point3, Vector3};
use a03_rays_cameras::{PixelRandom, Ray};
use a04_intersections::{Hit, Plane, Sphere};
use a05_lighting::{
    DirectionalLight, Illumination, Lambert, Lighting, LitWorld, Material, Phong, PointLight,
    SingleColor,
};
use approx::assert_abs_diff_eq;
use common::{ArgumentError, Color};

const UP: Vector3 = Vector3::new(0.0, 1.0, 0.0);
/// 0.6² + 0.8² = 1: the cosine to the normal is 0.8, and both reflect into
/// each other.
const LEFT: Vector3 = Vector3::new(-0.6, 0.8, 0.0);
const RIGHT: Vector3 = Vector3::new(0.6, 0.8, 0.0);
/// Rounding of a few products.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// Light that is all there, as it is given.
struct Given {
    ambient: Color,
    lights: Vec<Illumination>,
}

impl Lighting for Given {
    fn ambient(&self) -> Color {
        self.ambient
    }

    fn for_each_light(&self, _: &Ray, _: &Hit, shade: &mut dyn FnMut(&Illumination)) {
        self.lights.iter().for_each(shade);
    }
}

/// Lights of these colours from these directions, and no ambient light.
fn light_from(lights: &[(Color, Vector3)]) -> Given {
    let from = |&(color, direction): &(Color, Vector3)| Illumination {
        color,
        direction,
        distance: 1.0,
    };
    Given {
        ambient: Color::BLACK,
        lights: lights.iter().map(from).collect(),
    }
}

/// What an eye in the direction `e` sees of a surface that faces upwards.
fn seen_from(e: Vector3, material: &dyn Material, lighting: &dyn Lighting) -> Color {
    let ray = Ray::derived(Point3::ORIGIN + e, -e);
    material.color_for(&ray, &Hit::new(1.0, UP.as_normal()), lighting)
}

fn assert_close(color: Color, expected: Color) {
    for (channel, expected) in color.channels().into_iter().zip(expected.channels()) {
        assert_abs_diff_eq!(channel, expected, epsilon = ROUNDING);
    }
}

fn lambert(diffuse: Color) -> Lambert {
    Lambert::new(diffuse).unwrap()
}

fn phong(diffuse: Color, specular: Color, exponent: f64) -> Phong {
    Phong::new(diffuse, specular, exponent).unwrap()
}

struct NobodyMayAsk;

impl Lighting for NobodyMayAsk {
    fn ambient(&self) -> Color {
        panic!("asked for the ambient light")
    }

    fn for_each_light(&self, _: &Ray, _: &Hit, _: &mut dyn FnMut(&Illumination)) {
        panic!("asked for the lights")
    }
}

#[test]
fn a_single_color_asks_for_no_light() {
    let material = SingleColor::new(Color::MAGENTA).unwrap();
    assert_eq!(seen_from(LEFT, &material, &NobodyMayAsk), Color::MAGENTA);
}

#[test]
fn a_matt_surface_dims_with_the_cosine_of_the_light() {
    let material = lambert(Color::WHITE);
    let (half, root) = (0.5, 0.75_f64.sqrt());
    for (direction, expected) in [
        (UP, 1.0),
        (RIGHT, 0.8),
        (Vector3::new(0.0, root, half), root),
        (Vector3::new(root, half, 0.0), half),
        (Vector3::new(1.0, 0.0, 0.0), 0.0),
        (Vector3::new(0.6, -0.8, 0.0), 0.0),
        (-UP, 0.0),
    ] {
        let color = seen_from(UP, &material, &light_from(&[(Color::WHITE, direction)]));
        assert_eq!(color, Color::gray(expected));
    }
}

#[test]
fn channels_of_surface_and_light_multiply_and_lights_add_up() {
    let material = lambert(Color::new(0.5, 0.25, 1.0));
    let lighting = Given {
        ambient: Color::new(0.5, 1.0, 0.125),
        ..light_from(&[
            (Color::new(1.0, 0.5, 0.25), UP),
            (Color::new(0.0, 2.0, 4.0), RIGHT),
            (Color::WHITE, -UP),
        ])
    };
    // Ambient, and 1 times and 0.8 times a light.
    let expected = Color::new(
        0.25 + 0.5,
        0.25 + 0.125 + 0.8 * 0.5,
        0.125 + 0.25 + 0.8 * 4.0,
    );
    assert_close(seen_from(UP, &material, &lighting), expected);
}

#[test]
fn a_matt_surface_looks_the_same_from_everywhere() {
    let (material, lighting) = (lambert(Color::RED), light_from(&[(Color::WHITE, RIGHT)]));
    let expected = seen_from(UP, &material, &lighting);
    for e in [LEFT, RIGHT, Vector3::new(1.0, 1e-9, 0.0)] {
        assert_eq!(seen_from(e, &material, &lighting), expected);
    }
}

#[test]
fn without_lights_the_ambient_light_is_left() {
    let lighting = Given {
        ambient: Color::gray(0.25),
        ..light_from(&[])
    };
    let diffuse = Color::new(0.5, 1.0, 0.0);
    let expected = Color::new(0.125, 0.25, 0.0);
    let shiny = phong(diffuse, Color::WHITE, 64.0);
    assert_eq!(seen_from(UP, &lambert(diffuse), &lighting), expected);
    assert_eq!(seen_from(UP, &shiny, &lighting), expected);
}

/// The light comes from the right; its mirror direction is on the left. The
/// cosine between that and the eye is 1 there, 0.8 from above, and 0.28 =
/// 0.8² - 0.6² from where the light is.
#[test]
fn a_highlight_is_the_power_of_the_cosine_to_the_mirrored_light() {
    let (diffuse, specular) = (Color::new(0.5, 0.0, 0.25), Color::new(0.0, 0.5, 1.0));
    let light = Color::new(1.0, 1.0, 0.5);
    let lighting = light_from(&[(light, RIGHT)]);
    for (e, cosine) in [(LEFT, 1.0), (UP, 0.8), (RIGHT, 0.28)] {
        let square: f64 = cosine * cosine;
        for (exponent, power) in [
            (0.0, 1.0),
            (1.0, cosine),
            (2.0, square),
            (0.5, cosine.sqrt()),
        ] {
            let color = seen_from(e, &phong(diffuse, specular, exponent), &lighting);
            let matt = diffuse * light * 0.8;
            assert_close(color, matt + specular * light * power);
        }
    }
}

#[test]
fn highlights_of_several_lights_add_up_and_the_surface_does_not_tint_them() {
    let material = phong(Color::RED, Color::WHITE, 2.0);
    let lighting = Given {
        ambient: Color::new(0.125, 1.0, 1.0),
        ..light_from(&[(Color::GREEN, RIGHT), (Color::gray(0.5), LEFT)])
    };
    let highlight = 0.8 * 0.8;
    let expected = Color::new(
        0.125 + 0.5 * 0.8 + 0.5 * highlight,
        1.5 * highlight,
        0.5 * highlight,
    );
    assert_close(seen_from(UP, &material, &lighting), expected);
}

/// 0 to the power of 0 is 1: it must not light what faces away.
#[test]
fn where_nothing_is_mirrored_there_is_no_highlight_at_any_exponent() {
    let lighting = light_from(&[(Color::WHITE, RIGHT)]);
    // Perpendicular to the mirror direction (-0.6, 0.8), and beyond.
    for e in [
        Vector3::new(0.8, 0.6, 0.0),
        Vector3::new(1.0, 0.0, 0.0),
        Vector3::new(0.0, 0.0, 1.0) - LEFT * 0.01,
    ] {
        for exponent in [0.0, 1e-300, 1.0, 64.0] {
            let color = seen_from(e, &phong(Color::BLACK, Color::WHITE, exponent), &lighting);
            assert_eq!(color, Color::BLACK);
        }
    }
}

/// A light below the surface or exactly in its plane would be mirrored towards
/// eyes just above it.
#[test]
fn light_from_behind_makes_no_highlight() {
    for exponent in [0.0, 1.0, 64.0] {
        let material = phong(Color::WHITE, Color::WHITE, exponent);
        for direction in [
            Vector3::new(0.6, -0.8, 0.0),
            Vector3::new(1.0, 0.0, 0.0),
            -UP,
        ] {
            let lighting = light_from(&[(Color::WHITE, direction)]);
            for e in [UP, LEFT, Vector3::new(-1.0, 1e-9, 0.0)] {
                assert_eq!(seen_from(e, &material, &lighting), Color::BLACK);
            }
        }
    }
}

/// Cosines of rounded vectors exceed 1 by a few units of rounding, which a
/// high power turns into millions.
#[test]
fn no_highlight_is_brighter_than_its_light() {
    let material = phong(Color::BLACK, Color::WHITE, 1e17);
    let mut peaks = 0;
    for n in 0..10_000 {
        let random = PixelRandom::new(9, n, 0);
        let [x, z] = [0, 1].map(|i| random.uniform(i) * 4.0 - 2.0);
        let l = Vector3::new(x, 1.0, z).normalized().unwrap();
        let mirrored = Vector3::new(-l.x(), l.y(), -l.z());
        let color = seen_from(mirrored, &material, &light_from(&[(Color::WHITE, l)]));
        assert!((0.0..=1.0).contains(&color.r), "{color:?}");
        peaks += u32::from(color.r == 1.0);
    }
    assert!(peaks > 1000, "the clamp is tested");
}

#[test]
fn with_a_black_specular_a_shiny_surface_is_matt() {
    let diffuse = Color::new(0.3, 0.6, 0.9);
    for exponent in [0.0, 1.0, 64.0] {
        let dull = phong(diffuse, Color::BLACK, exponent);
        for e in [UP, LEFT, RIGHT] {
            let lighting = light_from(&[(Color::new(0.7, 0.1, 2.0), RIGHT), (Color::RED, LEFT)]);
            let expected = seen_from(e, &lambert(diffuse), &lighting);
            assert_eq!(seen_from(e, &dull, &lighting), expected);
        }
    }
}

fn empty() -> LitWorld {
    LitWorld::new(Color::BLUE, Color::gray(0.25)).unwrap()
}

fn floor() -> Plane {
    Plane::new(Point3::ORIGIN, UP.as_normal()).unwrap()
}

#[test]
fn a_lit_world_shades_the_nearest_object_with_all_its_lights() {
    let world = empty()
        .with(floor(), Box::new(lambert(Color::WHITE)))
        .lit_by(Box::new(DirectionalLight::new(Color::RED, -UP).unwrap()))
        .lit_by(Box::new(
            PointLight::new(Color::GREEN, Point3::new(3.0, 4.0, 0.0)).unwrap(),
        ));
    let down = Ray::new(Point3::new(0.0, 2.0, 0.0), -UP).unwrap();
    assert_close(world.color_for(&down), Color::new(1.25, 1.05, 0.25));
    let up = Ray::new(Point3::new(0.0, 2.0, 0.0), UP).unwrap();
    assert_eq!(world.color_for(&up), Color::BLUE);
    assert_eq!(world.ambient(), Color::gray(0.25));
    assert_eq!(world.objects().background(), Color::BLUE);
    assert_eq!(world.lights().len(), 2);
}

/// Lights under the floor, in its plane, and exactly where the ray meets it.
#[test]
fn lights_that_cannot_shine_on_a_surface_leave_the_ambient_light() {
    for y in [-1.0, -1e-9, 0.0] {
        for x in [0.0, 2.0] {
            let light = PointLight::new(Color::WHITE, Point3::new(x, y, 0.0)).unwrap();
            let world = empty()
                .with(floor(), Box::new(phong(Color::WHITE, Color::WHITE, 0.0)))
                .lit_by(Box::new(light));
            let down = Ray::new(Point3::new(0.0, 2.0, 0.0), -UP).unwrap();
            assert_eq!(world.color_for(&down), Color::gray(0.25));
        }
    }
}

/// Camera and light in the centre: `n · l = 1` everywhere.
#[test]
fn a_sphere_is_lit_from_inside() {
    let c = Point3::new(1.0, -2.0, 3.0);
    let world = LitWorld::new(Color::BLACK, Color::BLACK)
        .unwrap()
        .with(
            Sphere::new(c, 2.0).unwrap(),
            Box::new(lambert(Color::WHITE)),
        )
        .lit_by(Box::new(PointLight::new(Color::WHITE, c).unwrap()));
    for n in 0..1000 {
        let random = PixelRandom::new(10, n, 0);
        let d = [0, 1, 2].map(|i| random.uniform(i) - 0.5);
        let ray = Ray::new(c, Vector3::from_glam(d.into())).unwrap();
        assert_close(world.color_for(&ray), Color::WHITE);
    }
}

fn refusal<T: std::fmt::Debug>(result: Result<T, ArgumentError>) -> String {
    result.unwrap_err().to_string()
}

/// Light and surface of 1e50 make 1e100 of ambient light, of matt light and of
/// a highlight. Tolerance: rounding of a few products.
#[test]
fn the_brightest_colors_make_a_number() {
    let brightest = Color::gray(1e50);
    let material = phong(brightest, brightest, 1.0);
    let lighting = Given {
        ambient: brightest,
        ..light_from(&[(brightest, UP)])
    };
    for channel in seen_from(UP, &material, &lighting).channels() {
        assert_abs_diff_eq!(channel / 1e100, 3.0, epsilon = ROUNDING);
    }
}

#[test]
fn bad_colors_are_refused_by_name() {
    let white = Color::WHITE;
    for bad in [f64::NAN, f64::INFINITY, -1e-9, 1e51] {
        let color = Color::new(bad, 1.0, 1.0);
        for (said, name) in [
            (refusal(SingleColor::new(color)), "colour is"),
            (refusal(Lambert::new(color)), "diffuse is"),
            (refusal(Phong::new(color, white, 1.0)), "diffuse is"),
            (refusal(Phong::new(white, color, 1.0)), "specular is"),
            (refusal(LitWorld::new(color, white)), "background is"),
            (refusal(LitWorld::new(white, color)), "ambient light is"),
        ] {
            assert!(said.starts_with(name), "{said}");
            assert!(said.contains("channels from 0 to 1e50"), "{said}");
        }
    }
}

#[test]
fn bad_exponents_are_refused_by_name() {
    for bad in [-1.0, -1e-300, f64::NAN, f64::INFINITY] {
        let said = refusal(Phong::new(Color::WHITE, Color::WHITE, bad));
        assert!(said.starts_with("exponent is"), "{said}");
        assert!(said.contains("finite number of at least 0"), "{said}");
    }
}
