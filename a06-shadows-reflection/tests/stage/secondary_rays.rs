//! Rays that leave a surface, in scenes of all sizes: none hits its own surface again,
//! and none skips an object nearby.

use a02_math::{Direction, Point3, Vector3};
use a03_rays_cameras::{PixelRandom, Ray};
use a04_intersections::{AxisAlignedBox, Geometry, Hit, Interval, Plane, Sphere, Triangle, World};
use a05_lighting::Illumination;
use a06_shadows_reflection::{is_shadowed, secondary_ray};
use approx::assert_abs_diff_eq;
use common::Color;

const UP: Vector3 = Vector3::new(0.0, 1.0, 0.0);

/// A scene of size `s` around a middle that is not the origin.
#[derive(Clone, Copy)]
struct Place {
    s: f64,
}

impl Place {
    fn at(self, x: f64, y: f64, z: f64) -> Point3 {
        let Self { s } = self;
        Point3::new((3.0 + x) * s, (y - 2.0) * s, (5.0 + z) * s)
    }

    fn random(self, random: PixelRandom, first: u64, width: f64) -> Point3 {
        let [x, y, z] = [0, 1, 2].map(|i| width * (2.0 * random.uniform(first + i) - 1.0));
        self.at(x, y, z)
    }

    /// The places of a shape that are seen from `eye`, each with a light that shines on its
    /// front, not quite grazing: neither acne, where a surface shades itself because its
    /// hit was rounded to a point below it, nor light that passes a ball at a distance of
    /// `s` / 10,000. From inside a closed shape the light is inside, too.
    fn check(self, shape: &(impl Geometry + Clone), eye: Point3, light_width: f64) {
        let world = || World::new(Color::BLACK).unwrap().with(shape.clone(), ());
        let alone = world();
        let mut places = 0;
        for n in 0..2000 {
            let random = PixelRandom::new(11, n, 0);
            let ray = Ray::new(eye, self.random(random, 0, 1.2) - eye).unwrap();
            let Some((hit, ())) = alone.hit(&ray, Interval::AHEAD) else {
                continue;
            };
            let way = self.random(random, 3, light_width) - ray.at(hit.t);
            let light = Illumination {
                color: Color::WHITE,
                direction: way.normalized().unwrap(),
                distance: way.magnitude(),
            };
            if hit.normal.dot(light.direction) < 1e-3 {
                continue;
            }
            let c = ray.at(hit.t) + light.direction * (1e-4 * self.s);
            let ball = Sphere::new(c, 2e-5 * self.s).unwrap();
            let lit = format!("{shape:?}, ray {n}");
            assert!(!is_shadowed(&alone, &ray, &hit, &light), "acne: {lit}");
            assert!(
                is_shadowed(&world().with(ball, ()), &ray, &hit, &light),
                "leak: {lit}"
            );
            places += 1;
        }
        assert!(places > 200, "{places} places of {shape:?}");
    }
}

#[test]
fn no_surface_shades_itself_and_nothing_close_is_skipped() {
    for s in [1e-6, 1.0, 1e6, 1e9] {
        let place = Place { s };
        let middle = place.at(0.0, 0.0, 0.0);
        let [a, b, c] =
            [(-1.1, -1.0), (1.2, -0.9), (0.1, 1.3)].map(|(x, z)| place.at(x, 0.3 * x - 0.2 * z, z));
        let tilted = Vector3::new(0.3, 1.0, -0.2).as_normal();
        let ball = Sphere::new(middle, s).unwrap();
        let room = AxisAlignedBox::new(place.at(-0.9, -0.7, -0.8), place.at(0.8, 0.9, 0.7));
        let room = room.unwrap();

        let (outside, inside) = (place.at(-6.0, 5.0, -4.0), place.at(-0.5, 0.1, 0.2));
        place.check(&ball, outside, 8.0);
        place.check(&Plane::new(middle, UP.as_normal()).unwrap(), outside, 8.0);
        place.check(&Plane::new(middle, tilted).unwrap(), outside, 8.0);
        place.check(&room, outside, 8.0);
        place.check(&Triangle::new(a, b, c).unwrap(), outside, 8.0);
        place.check(&ball, inside, 0.5);
        place.check(&room, inside, 0.5);
    }
}

/// Along the face, not the shading normal. The offset is 64 eps of the greatest of: `t`, 5
/// here, and the coordinates of origin and hit.
#[test]
fn a_secondary_ray_starts_on_the_side_to_which_it_goes() {
    let leaning = Vector3::new(0.6, 0.8, 0.0).as_normal();
    let hit = Hit {
        normal: leaning,
        ..Hit::new(5.0, UP.as_normal())
    };
    for (eye, place, greatest) in [
        (Point3::new(3.0, 4.0, 0.0), Point3::ORIGIN, 5.0),
        (Point3::new(3.0, 0.0, 0.0), Point3::new(-2.0, 0.0, 0.0), 5.0),
        (Point3::new(3.0, 0.0, 0.0), Point3::new(8.0, 0.0, 0.0), 8.0),
        (
            Point3::new(-9.0, 4.0, 0.0),
            Point3::new(-9.0, -1.0, 0.0),
            9.0,
        ),
    ] {
        let ray = Ray::new(eye, place - eye).unwrap();
        for (direction, side) in [
            (Vector3::new(0.6, 0.8, 0.0), 1.0),
            (Vector3::new(-1.0, 1e-300, 0.0), 1.0),
            (Vector3::new(0.6, -0.8, 0.0), -1.0),
        ] {
            let leaving = secondary_ray(&ray, &hit, direction);
            assert_eq!(leaving.direction(), direction);
            let offset = leaving.origin() - ray.at(5.0);
            let expected = UP * (side * 64.0 * f64::EPSILON * greatest);
            assert_abs_diff_eq!(offset, expected, epsilon = 4.0 * f64::EPSILON);
        }
    }
}
