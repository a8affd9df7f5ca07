//! Cubes whose colour is known from three whole numbers, and points of
//! surfaces that lie just where two cubes meet.

use a02_math::{Normal3, Point3};
use a03_rays_cameras::Ray;
use a04_intersections::{AxisAlignedBox, Geometry, Interval, Plane, World};
use common::{ArgumentError, Color};
use measure::extremes::Bound;
use testing::exercise::Check;

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
            let mut wrong: usize = 0;
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
                    Some(checkerboard(ray.at(hit.t), hit.normal))
                });
                let [i, j, k] = cube;
                wrong += usize::from(hit != Some(color_of(i, j, k)));
            }
            let what = format!("wrong ones of 256 squares in the plane {name} = {place}");
            check.expect(what, 0, Bound::Equal, wrong);
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
