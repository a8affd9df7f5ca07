//! Cubes whose colour is known from three whole numbers, and points of
//! surfaces that lie just where two cubes meet.

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{AxisAlignedBox, Geometry, Interval, Plane, World};
use common::{ArgumentError, Color};
use measure::extremes::Bound;
use testing::exercise::{Check, Random};

use crate::shape::show_world;

/// Of the cube whose smallest corner is (`i`, `j`, `k`).
fn color_of(i: i32, j: i32, k: i32) -> Color {
    let is_even = (i + j + k) & 1 == 0;
    if is_even { Color::WHITE } else { Color::BLACK }
}

pub fn check(check: &mut Check, checkerboard: impl Fn(Point3, Normal3) -> Color + Sync) {
    let up = Normal3::new(0.0, 1.0, 0.0);
    let mut cube = |[i, j, k]: [i32; 3]| {
        let middle = [i, j, k].map(|n| f64::from(n) + 0.5);
        let got = checkerboard(Point3::from_glam(middle.into()), up).channels();
        let what = format!("in the middle of the cube ({i}, {j}, {k})");
        check.expect(what, color_of(i, j, k).channels(), Bound::Equal, got);
    };
    for i in -2..=1 {
        for j in -2..=1 {
            for k in -2..=1 {
                cube([i, j, k]);
            }
        }
    }
    cube([1_000_001, 0, 0]);
    cube([0, -1_000_001, 1_000_001]);

    let mut random = Random::new(4);
    for _ in 0..60 {
        let cube = [(); 3].map(|()| f64::from(random.below(2001)) - 1000.0);
        let place = cube.map(|low| low + random.between(0.01, 0.99));
        let p = Point3::from_glam(place.into());
        let [x, y, z] = [(); 3].map(|()| random.between(-1.0, 1.0));
        let normal = Vector3::new(x, y, z).normalized().map(Vector3::as_normal);
        let got = checkerboard(p, normal.unwrap_or(up)).channels();
        let what = format!("at {place:?}");
        let [i, j, k] = cube.map(|n| n as i32);
        check.expect(what, color_of(i, j, k).channels(), Bound::Equal, got);
    }

    // Rays to middles of squares, where rounding leaves the hit above, below or
    // on the face.
    let eye = Point3::new(0.3, 5.7, 0.2);
    for (axis, name) in [(0, "x"), (1, "y"), (2, "z")] {
        for place in [-3, 0, 2] {
            let mut normal = [0.0; 3];
            normal[axis] = if eye.to_glam()[axis] < f64::from(place) {
                -1.0
            } else {
                1.0
            };
            // A surface shows the cube on the side that it does not face.
            let below = if normal[axis] < 0.0 { place } else { place - 1 };
            let normal = Normal3::from_glam(normal.into());
            for (i, j) in (-8..8).flat_map(|i| (-8..8).map(move |j| (i, j))) {
                let mut cube = [i; 3];
                cube[(axis + 1) % 3] = j;
                cube[axis] = below;
                let mut at = cube.map(|n| f64::from(n) + 0.5);
                at[axis] = f64::from(place);
                let at = Point3::from_glam(at.into());
                let hit = Plane::new(at, normal)
                    .ok()
                    .zip(Ray::new(eye, at - eye).ok());
                let hit = hit.and_then(|(plane, ray)| {
                    let hit = plane.hit(&ray, Interval::AHEAD)?;
                    Some(checkerboard(ray.at(hit.t), hit.normal).channels())
                });
                let [i, j, k] = cube;
                let what = format!(
                    "a ray from {} to the plane {name} = {place} at {}, the face of a cube",
                    eye.to_glam(),
                    at.to_glam()
                );
                let exact = Some(color_of(i, j, k).channels());
                check.expect(what, exact, Bound::Equal, hit);
            }
        }
    }

    let (eye, at) = (Point3::new(3.0, 4.0, 7.0), Point3::new(0.0, 0.6, 0.0));
    show_world(check, floor_and_box(), eye, at, |p, n| {
        checkerboard(p, n) * 0.7 + Color::gray(0.15)
    });
}

fn floor_and_box() -> Result<World<()>, ArgumentError> {
    let floor = Plane::new(Point3::ORIGIN, Normal3::new(0.0, 1.0, 0.0))?;
    let (lbf, run) = (Point3::new(-2.0, 0.0, -2.0), Point3::new(1.0, 2.0, 1.0));
    let world = World::new(Color::gray(0.1))?.with(floor, ());
    Ok(world.with(AxisAlignedBox::new(lbf, run)?, ()))
}
