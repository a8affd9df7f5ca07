//! Scenes of all sizes: no surface shades itself, and nothing close is overlooked.

use a02_math::{Direction, Point3, Vector3};
use a03_rays_cameras::{PixelRandom, Ray};
use a04_intersections::{AxisAlignedBox, Geometry, Hit, Interval, Plane, Sphere, Triangle};
use a05_lighting::PointLight;
use a06_shadows_reflection::{RecursiveTracer, ShadowedWorld, secondary_ray};
use approx::assert_abs_diff_eq;
use common::Color;

use super::{UP, lamp, white};

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
fn no_surface_shades_itself_and_nothing_close_is_overlooked() {
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
