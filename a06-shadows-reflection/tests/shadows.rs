//! Shadows: where they fall, where they must not, and at which sizes.

use std::f64::consts::FRAC_PI_4;

use a02_math::{Direction, Point3, Vector3};
use a03_rays_cameras::{PixelRandom, Ray};
use a04_intersections::{AxisAlignedBox, Geometry, Hit, Interval, Plane, Sphere, Triangle};
use a05_lighting::{DirectionalLight, Lambert, Light, PointLight, SpotLight};
use a06_shadows_reflection::{LightSource, RecursiveTracer, ShadowedWorld, Surface, secondary_ray};
use approx::assert_abs_diff_eq;
use common::Color;

const UP: Vector3 = Vector3::new(0.0, 1.0, 0.0);
const AMBIENT: Color = Color::gray(0.25);
const LIT: Color = Color::gray(1.25);

fn white() -> Box<dyn Surface> {
    Box::new(Lambert::new(Color::WHITE).unwrap())
}

fn plane(y: f64) -> Plane {
    Plane::new(Point3::new(0.0, y, 0.0), UP.as_normal()).unwrap()
}

fn sphere(x: f64, y: f64, z: f64, r: f64) -> Sphere {
    Sphere::new(Point3::new(x, y, z), r).unwrap()
}

fn point_light(x: f64, y: f64, z: f64) -> PointLight {
    PointLight::new(Color::WHITE, Point3::new(x, y, z)).unwrap()
}

/// The white floor y = 0 in a little ambient light.
fn floor() -> ShadowedWorld {
    ShadowedWorld::empty(Color::BLACK, AMBIENT)
        .unwrap()
        .with(plane(0.0), white())
}

fn lamp(light: impl Light + 'static) -> LightSource {
    LightSource::new(light, true)
}

/// What is seen of the origin from an eye far enough aside not to look through
/// what stands above it.
fn seen(world: &ShadowedWorld) -> Color {
    let eye = Point3::new(-8.0, 1.0, 0.0);
    let ray = Ray::new(eye, Point3::ORIGIN - eye).unwrap();
    RecursiveTracer::new(world).trace(&ray, 1)
}

#[test]
fn what_is_between_a_surface_and_a_light_casts_a_shadow() {
    for r in [1.0, 1e-3, 1e-9] {
        for y in [1.5, 4.0] {
            let world = floor()
                .with(sphere(0.0, y, 0.0, r), white())
                .lit_by(lamp(point_light(0.0, 6.0, 0.0)));
            assert_eq!(seen(&world), AMBIENT, "a sphere of {r} at {y}");
        }
    }
    let aside = floor()
        .with(sphere(2.0, 4.0, 0.0, 1.0), white())
        .lit_by(lamp(point_light(0.0, 6.0, 0.0)));
    assert_eq!(seen(&aside), LIT);
}

#[test]
fn every_shape_casts_a_shadow_from_both_of_its_sides() {
    let (lbf, run) = (Point3::new(-1.0, 2.0, -1.0), Point3::new(1.0, 3.0, 1.0));
    let [a, b, c] = [(-1.0, -1.0), (2.0, -1.0), (0.0, 2.0)].map(|(x, z)| Point3::new(x, 2.0, z));
    let lit = |world: ShadowedWorld| world.lit_by(lamp(point_light(0.0, 6.0, 0.0)));
    for world in [
        floor().with(AxisAlignedBox::new(lbf, run).unwrap(), white()),
        floor().with(Triangle::new(a, b, c).unwrap(), white()),
        floor().with(Triangle::new(a, c, b).unwrap(), white()),
        floor().with(plane(2.0), white()),
        floor().with(sphere(0.0, 6.0, 0.0, 2.0), white()),
    ] {
        assert_eq!(seen(&lit(world)), AMBIENT);
    }
}

#[test]
fn what_is_behind_the_light_or_below_the_surface_casts_none() {
    for (y, r) in [(8.0, 1.0), (6.001_001, 0.001), (-1.5, 1.0), (-0.002, 0.001)] {
        let world = floor()
            .with(sphere(0.0, y, 0.0, r), white())
            .lit_by(lamp(point_light(0.0, 6.0, 0.0)));
        assert_eq!(seen(&world), LIT, "a sphere of {r} at {y}");
    }
}

/// A lamp that is fixed to the ceiling: it lies in the object, and lights the
/// room all the same, from wherever that is seen and however low the ceiling.
/// A ceiling a millionth lower hides the lamp.
///
/// Tolerance: the eye looks at a slope of 0.3 / 1000 at most, so that the place
/// it sees is wrong by up to 1e4 eps of its distance, and the cosine by as much
/// relative to the height: 1e7 eps.
#[test]
fn an_object_at_the_light_itself_is_not_in_its_way() {
    for height in [1e-3, 1.0, 6.0, 1e3] {
        for distance in [height, 30.0 * height, 1e3 * height] {
            for (x, z) in [
                (0.0, 0.0),
                (0.3, -0.7),
                (-1.0, 0.1),
                (5.0, 0.0),
                (-9.0, 30.0),
            ] {
                // The eye is below the ceiling, and looks at the floor aslant.
                let place = Point3::new(x * height, 0.0, z * height);
                let eye = place + Vector3::new(0.6 * distance, 0.3 * height, -0.8 * distance);
                let ray = Ray::new(eye, place - eye).unwrap();
                let cosine = 1.0 / (1.0 + x * x + z * z).sqrt();
                for (ceiling, lit) in [(1.0, cosine), (1.0 - 1e-6, 0.0)] {
                    let world = floor()
                        .with(plane(ceiling * height), white())
                        .lit_by(lamp(point_light(0.0, height, 0.0)));
                    let color = RecursiveTracer::new(&world).trace(&ray, 1);
                    assert_abs_diff_eq!(color.r, 0.25 + lit, epsilon = 1e7 * f64::EPSILON);
                }
            }
        }
    }
}

#[test]
fn a_light_without_shadows_shines_through_everything() {
    let through = LightSource::new(point_light(0.0, 6.0, 0.0), false);
    assert!(!through.casts_shadows());
    assert!(lamp(point_light(0.0, 6.0, 0.0)).casts_shadows());
    let world = floor()
        .with(sphere(0.0, 3.0, 0.0, 1.0), white())
        .lit_by(through);
    assert_eq!(seen(&world), LIT);
}

/// The source answers for the light in it, shadows or not.
#[test]
fn a_light_source_is_the_light_it_holds() {
    let light = point_light(0.0, 6.0, 0.0);
    for casts_shadows in [true, false] {
        let source = LightSource::new(light, casts_shadows);
        for point in [Point3::ORIGIN, Point3::new(0.0, 6.0, 0.0)] {
            assert_eq!(source.illumination(point), light.illumination(point));
            assert_eq!(source.illuminates(point), light.illuminates(point));
        }
    }
}

#[test]
fn each_light_has_its_own_shadow() {
    let lights = |world: ShadowedWorld| {
        world
            .lit_by(lamp(
                PointLight::new(Color::RED, Point3::new(0.0, 6.0, 0.0)).unwrap(),
            ))
            .lit_by(lamp(DirectionalLight::new(Color::GREEN, -UP).unwrap()))
            .lit_by(LightSource::new(
                DirectionalLight::new(Color::BLUE, -UP).unwrap(),
                false,
            ))
    };
    for (y, expected) in [
        (3.0, Color::BLUE),
        (9.0, Color::MAGENTA),
        (-3.0, Color::WHITE),
    ] {
        let world = lights(floor().with(sphere(0.0, y, 0.0, 1.0), white()));
        assert_eq!(seen(&world), AMBIENT + expected);
    }
}

#[test]
fn spot_and_directional_lights_cast_shadows_too() {
    let spot = SpotLight::new(Color::WHITE, Point3::new(0.0, 6.0, 0.0), -UP, FRAC_PI_4);
    let sun = DirectionalLight::new(Color::WHITE, -UP).unwrap();
    let [bright_spot, bright_sun, dark_spot, dark_sun, far_sun] = [
        floor().lit_by(lamp(spot.clone().unwrap())),
        floor().lit_by(lamp(sun)),
        floor()
            .with(sphere(0.0, 3.0, 0.0, 1.0), white())
            .lit_by(lamp(spot.clone().unwrap())),
        floor()
            .with(sphere(0.0, 3.0, 0.0, 1.0), white())
            .lit_by(lamp(sun)),
        // However far away.
        floor()
            .with(sphere(0.0, 1e12, 0.0, 1.0), white())
            .lit_by(lamp(sun)),
    ]
    .map(|world| seen(&world));
    assert_eq!((bright_spot, bright_sun), (LIT, LIT));
    assert_eq!((dark_spot, dark_sun, far_sun), (AMBIENT, AMBIENT, AMBIENT));
    // Beside the cone nothing needs to be in the way.
    let beside = floor().lit_by(lamp(
        SpotLight::new(Color::WHITE, Point3::new(7.0, 6.0, 0.0), -UP, FRAC_PI_4).unwrap(),
    ));
    assert_eq!(seen(&beside), AMBIENT);
}

/// Much closer than any fixed length that a shadow ray might skip.
#[test]
fn a_light_just_above_a_surface_lights_it() {
    for height in [1e-3, 1e-6, 1e-9] {
        let world = floor().lit_by(lamp(point_light(0.0, height, 0.0)));
        assert_eq!(seen(&world), LIT, "at {height}");
    }
}

/// A scene of size `s` around a middle that is not the origin.
struct Scene {
    s: f64,
    middle: Point3,
    light: Point3,
}

impl Scene {
    fn new(s: f64) -> Self {
        let middle = Point3::new(3.0 * s, -2.0 * s, 5.0 * s);
        let light = middle + Vector3::new(1.0, 8.0, 3.0) * s;
        Self { s, middle, light }
    }

    fn at(&self, x: f64, y: f64, z: f64) -> Point3 {
        self.middle + Vector3::new(x, y, z) * self.s
    }

    /// Rays from an eye that sees the lit side from another direction.
    fn rays(&self) -> impl Iterator<Item = Ray> {
        let (middle, s) = (self.middle, self.s);
        let eye = self.at(-6.0, 5.0, -4.0);
        (0..2000).map(move |n| {
            let random = PixelRandom::new(11, n, 0);
            let aim = [0, 1, 2].map(|i| (2.4 * random.uniform(i) - 1.2) * s);
            Ray::new(eye, middle + Vector3::from_glam(aim.into()) - eye).unwrap()
        })
    }

    /// Counts, of the places where the light shines on `shape` from outside,
    /// not quite grazing: all of them, those that the shape shades itself, and
    /// those that stay lit behind a ball at a distance of `s` / 10,000.
    fn count(&self, shape: impl Geometry + Copy + 'static) -> [usize; 3] {
        let mut counts = [0; 3];
        for ray in self.rays() {
            let world = || {
                let black = ShadowedWorld::empty(Color::BLACK, Color::BLACK).unwrap();
                let light = PointLight::new(Color::WHITE, self.light).unwrap();
                black.with(shape, white()).lit_by(lamp(light))
            };
            let Some((hit, _)) = world().objects().hit(&ray, Interval::AHEAD) else {
                continue;
            };
            let p = ray.at(hit.t);
            let l = (self.light - p).normalized().unwrap();
            if hit.normal.dot(l) < 1e-3 {
                continue;
            }
            let ball = Sphere::new(p + l * (1e-4 * self.s), 2e-5 * self.s).unwrap();
            let trace = |world: ShadowedWorld| RecursiveTracer::new(&world).trace(&ray, 1);
            counts[0] += 1;
            counts[1] += usize::from(trace(world()) == Color::BLACK);
            counts[2] += usize::from(trace(world().with(ball, white())) != Color::BLACK);
        }
        counts
    }
}

/// Neither acne, where a surface shades itself because its hit was rounded to
/// a place below it, nor light that leaks in under an object nearby: at no size.
#[test]
fn surfaces_do_not_shade_themselves_and_nothing_close_is_overlooked() {
    for s in [1e-6, 1.0, 1e6, 1e9] {
        let scene = Scene::new(s);
        let [a, b, c] = [(-1.1, -1.0), (1.2, -0.9), (0.1, 1.3)];
        let corner = |(x, z): (f64, f64)| scene.at(x, 0.3 * x - 0.2 * z, z);
        let tilted = Vector3::new(0.3, 1.0, -0.2).as_normal();
        for [all, dark, leaks] in [
            scene.count(Sphere::new(scene.middle, s).unwrap()),
            scene.count(Plane::new(scene.middle, UP.as_normal()).unwrap()),
            scene.count(Plane::new(scene.middle, tilted).unwrap()),
            scene.count(
                AxisAlignedBox::new(scene.at(-0.9, -0.7, -0.8), scene.at(0.8, 0.9, 0.7)).unwrap(),
            ),
            scene.count(Triangle::new(corner(a), corner(b), corner(c)).unwrap()),
        ] {
            assert!(all > 400, "{all} places are tested");
            assert_eq!((dark, leaks), (0, 0), "of {all} places at size {s}");
        }
    }
}

/// Camera and light inside: everything is lit.
#[test]
fn a_closed_room_does_not_shade_its_walls() {
    for s in [1e-6, 1.0, 1e9] {
        let scene = Scene::new(s);
        let light = PointLight::new(Color::WHITE, scene.at(0.3, 0.2, -0.4)).unwrap();
        let room = AxisAlignedBox::new(scene.at(-1.0, -1.0, -1.0), scene.at(1.0, 1.0, 1.0));
        let black = || ShadowedWorld::empty(Color::BLACK, Color::BLACK).unwrap();
        for world in [
            black().with(Sphere::new(scene.middle, s).unwrap(), white()),
            black().with(room.unwrap(), white()),
        ] {
            let world = world.lit_by(lamp(light));
            let tracer = RecursiveTracer::new(&world);
            for n in 0..2000 {
                let random = PixelRandom::new(12, n, 0);
                let d = [0, 1, 2].map(|i| random.uniform(i) - 0.5);
                let eye = scene.at(-0.5, 0.1, 0.2);
                let ray = Ray::new(eye, Vector3::from_glam(d.into())).unwrap();
                assert!(tracer.trace(&ray, 1).r > 0.0, "{ray:?} at size {s}");
            }
        }
    }
}

/// The lift is 64 eps of the greatest of: the coordinates of origin and hit,
/// and t. Here that is t = 5.
#[test]
fn a_secondary_ray_starts_on_the_side_to_which_it_goes() {
    let eye = Point3::new(3.0, 4.0, 0.0);
    let ray = Ray::new(eye, Point3::ORIGIN - eye).unwrap();
    let hit = Hit::new(5.0, UP.as_normal());
    let place = ray.at(5.0);
    for (direction, side) in [
        (Vector3::new(0.6, 0.8, 0.0), 1.0),
        (Vector3::new(-1.0, 1e-300, 0.0), 1.0),
        (Vector3::new(0.6, -0.8, 0.0), -1.0),
    ] {
        let leaving = secondary_ray(&ray, &hit, direction);
        assert_eq!(leaving.direction(), direction);
        let lift = leaving.origin() - place;
        let expected = UP * (side * 64.0 * f64::EPSILON * 5.0);
        assert_abs_diff_eq!(lift, expected, epsilon = f64::EPSILON);
    }
}
