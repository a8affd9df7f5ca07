//! The time of single steps of the tracer.
//!
//! ```console
//! $ cargo bench -p a07-transforms --bench kernels            all of them
//! $ cargo bench -p a07-transforms --bench kernels -- shapes  the shapes only
//! ```
//!
//! Each step is taken for 65,536 different rays in a row, so that the processor
//! cannot learn the outcomes by heart, and about half of the rays meet the shape:
//! a test that always fails is cheaper. Read the figures as ratios of one run;
//! a factor that comes and goes with the next build comes from the layout of the
//! program, not from its arithmetic.

use std::f64::consts::FRAC_PI_4;
use std::hint::black_box;

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::{
    Camera, OrthographicCamera, PerspectiveCamera, PinholeCamera, PixelRandom, Ray,
};
use a04_intersections::{AxisAlignedBox, Geometry, Hit, Interval, Plane, Sphere, Triangle};
use a05_lighting::{Lambert, LitWorld, Material, Phong, PointLight, SingleColor};
use a06_shadows_reflection::Reflective;
use a07_transforms::{Disc, Node, Transform};
use common::{Color, Size};
use divan::Bencher;
use divan::counter::ItemsCount;

fn main() {
    divan::main();
}

const RAYS: usize = 65_536;

/// Rays from all around towards the surroundings of the origin, so far beside
/// it that a sphere of radius 1 is met by half of them.
fn rays() -> Vec<Ray> {
    let ray = |i: usize| {
        let random = PixelRandom::new(1, i as u32, 0);
        let at = |n| 2.0 * random.uniform(n) - 1.0;
        let from = Vector3::new(at(0), at(1), at(2)).normalized()?;
        let aim = Point3::new(at(3), at(4), at(5));
        let origin = Point3::ORIGIN + from * 5.0;
        Ray::new(
            origin,
            (aim - origin) + Vector3::new(at(6), at(7), at(8)) * 0.6,
        )
        .ok()
    };
    (0..2 * RAYS).filter_map(ray).take(RAYS).collect()
}

fn count(bencher: Bencher, step: impl Fn(&Ray) -> bool + Sync) {
    let rays = rays();
    bencher
        .counter(ItemsCount::new(rays.len()))
        .bench(|| rays.iter().filter(|ray| step(black_box(ray))).count());
}

fn hits(bencher: Bencher, geometry: &dyn Geometry) {
    count(bencher, |ray| geometry.hit(ray, Interval::AHEAD).is_some());
}

fn at(x: f64, y: f64, z: f64) -> Point3 {
    Point3::new(x, y, z)
}

const UP: Normal3 = Normal3::new(0.0, 1.0, 0.0);

#[divan::bench_group]
mod shapes {
    use super::{Bencher, Disc, Plane, Point3, Triangle, UP, at, hits};

    #[divan::bench]
    fn plane(bencher: Bencher) {
        hits(bencher, &Plane::new(Point3::ORIGIN, UP).unwrap());
    }

    #[divan::bench]
    fn sphere(bencher: Bencher) {
        hits(bencher, &super::sphere());
    }

    #[divan::bench]
    fn axis_aligned_box(bencher: Bencher) {
        hits(bencher, &super::aab());
    }

    #[divan::bench]
    fn triangle(bencher: Bencher) {
        let corners = (at(-2.0, -1.5, 0.0), at(2.0, -1.5, 0.3), at(0.0, 2.0, -0.3));
        hits(
            bencher,
            &Triangle::new(corners.0, corners.1, corners.2).unwrap(),
        );
    }

    #[divan::bench]
    fn disc(bencher: Bencher) {
        hits(bencher, &Disc::new(Point3::ORIGIN, UP, 1.5).unwrap());
    }
}

fn sphere() -> Sphere {
    Sphere::new(Point3::ORIGIN, 1.0).unwrap()
}

fn aab() -> AxisAlignedBox {
    AxisAlignedBox::new(at(-0.8, -0.8, -0.8), at(0.8, 0.8, 0.8)).unwrap()
}

/// A sphere under nodes that need more and more of a matrix.
#[divan::bench_group]
mod nodes {
    use super::{Bencher, Node, Transform, at, hits};

    fn under(bencher: Bencher, transform: Transform) {
        hits(bencher, &Node::new(transform).with(super::sphere()));
    }

    #[divan::bench]
    fn identity(bencher: Bencher) {
        under(bencher, Transform::IDENTITY);
    }

    #[divan::bench]
    fn translation(bencher: Bencher) {
        under(
            bencher,
            Transform::IDENTITY.translate(at(0.1, 0.2, 0.3)).unwrap(),
        );
    }

    #[divan::bench]
    fn stretched_and_turned(bencher: Bencher) {
        let stretched = Transform::IDENTITY.scale(1.2, 0.8, 1.0).unwrap();
        under(bencher, stretched.rotate_y(0.3).unwrap());
    }
}

#[divan::bench_group]
mod cameras {
    use super::{
        Bencher, Camera, FRAC_PI_4, OrthographicCamera, PerspectiveCamera, PinholeCamera, Point3,
        Size, Vector3, count,
    };

    fn directions(bencher: Bencher, camera: &dyn Camera) {
        let size = Size::COURSE;
        count(bencher, |ray| {
            let (x, y) = (ray.origin().x() * 60.0, ray.origin().y() * 60.0);
            camera.ray_for(size, x, y).direction().x() > 0.0
        });
    }

    const GAZE: Vector3 = Vector3::new(0.0, 0.0, -1.0);
    const UPWARDS: Vector3 = Vector3::new(0.0, 1.0, 0.0);

    #[divan::bench]
    fn orthographic(bencher: Bencher) {
        let camera = OrthographicCamera::new(Point3::ORIGIN, GAZE, UPWARDS, 3.0);
        directions(bencher, &camera.unwrap());
    }

    #[divan::bench]
    fn perspective(bencher: Bencher) {
        let camera = PerspectiveCamera::new(Point3::ORIGIN, GAZE, UPWARDS, FRAC_PI_4);
        directions(bencher, &camera.unwrap());
    }

    #[divan::bench]
    fn pinhole(bencher: Bencher) {
        directions(
            bencher,
            &PinholeCamera::new(Point3::ORIGIN, FRAC_PI_4).unwrap(),
        );
    }
}

/// The colour of each hit of a sphere under one light.
#[divan::bench_group]
mod materials {
    use super::{
        Bencher, Color, Hit, Lambert, LitWorld, Material, Phong, Point3, PointLight, Ray,
        Reflective, SingleColor, at, count,
    };

    fn colors(bencher: Bencher, material: &dyn Material) {
        let light = PointLight::new(Color::WHITE, at(5.0, 8.0, 3.0)).unwrap();
        let world = LitWorld::new(Color::BLACK, Color::gray(0.1)).unwrap();
        let world = world.lit_by(Box::new(light));
        let normal = |ray: &Ray| (ray.origin() - Point3::ORIGIN).normalized();
        let hit = |ray: &Ray| Some(Hit::new(4.0, normal(ray)?.as_normal()));
        count(bencher, |ray| {
            hit(ray).is_some_and(|hit| material.color_for(ray, &hit, &world) != Color::BLACK)
        });
    }

    const RED: Color = Color::RED;

    #[divan::bench]
    fn single_color(bencher: Bencher) {
        colors(bencher, &SingleColor::new(RED).unwrap());
    }

    #[divan::bench]
    fn lambert(bencher: Bencher) {
        colors(bencher, &Lambert::new(RED).unwrap());
    }

    #[divan::bench]
    fn phong(bencher: Bencher) {
        colors(bencher, &Phong::new(RED, Color::WHITE, 64.0).unwrap());
    }

    #[divan::bench]
    fn reflective(bencher: Bencher) {
        let half = Color::gray(0.5);
        colors(
            bencher,
            &Reflective::new(RED, Color::WHITE, 64.0, half).unwrap(),
        );
    }
}
