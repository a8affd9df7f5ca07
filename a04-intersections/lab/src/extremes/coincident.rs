//! Coincident surfaces: two shapes in one plane, between which rounding decides.

use a02_math::{Normal3, Point3};
use a03_rays_cameras::Ray;
use common::{Color, Error};
use measure::Effort;
use measure::extremes::{Absolute, Case, Flag, Number, greatest, tried};

use super::EPSILON;
use crate::support::{Numbers, first};
use a04_intersections::{AxisAlignedBox, Interval, Plane, World};

const EYE: Point3 = Point3::new(1.3, 2.7, 5.1);

/// The plane y = 0.
fn floor() -> Result<Plane, Error> {
    Ok(Plane::new(Point3::ORIGIN, Normal3::new(0.0, 1.0, 0.0))?)
}

/// A box whose top is at this height.
fn box_below(top: f64) -> Result<AxisAlignedBox, Error> {
    let (lbf, run) = (Point3::new(-2.0, -1.0, -2.0), Point3::new(2.0, top, 2.0));
    Ok(AxisAlignedBox::new(lbf, run)?)
}

/// Rays from the eye to places on the top of the box.
fn rays(count: usize) -> Result<Vec<Ray>, Error> {
    let mut rays = Vec::new();
    for n in 0..count {
        let mut numbers = Numbers::new(54, n);
        let mut place = || numbers.between(-1.9, 1.9);
        let target = Point3::new(place(), 0.0, place());
        rays.push(Ray::new(EYE, target - EYE)?);
    }
    Ok(rays)
}

/// The number of rays whose nearest hit is on the second object of a world.
fn seeing_the_second(world: &World<usize>, rays: &[Ray]) -> usize {
    let mut seeing = 0;
    for ray in rays {
        let hit = world.hit(ray, Interval::AHEAD);
        seeing += usize::from(hit.is_some_and(|(_, object)| *object == 1));
    }
    seeing
}

/// The number of rays that see a box instead of a floor before it in the list.
fn seeing_the_box(top: f64, rays: &[Ray]) -> Result<usize, Error> {
    let world = World::new(Color::BLACK)?.with(floor()?, 0);
    Ok(seeing_the_second(&world.with(box_below(top)?, 1), rays))
}

/// The greatest difference of the `t` of the floor and of a box whose top lies in it, in `t`.
fn greatest_difference(rays: &[Ray]) -> Result<f64, Error> {
    let (floor, below) = (floor()?, box_below(0.0)?);
    let mut differences = Vec::new();
    for ray in rays {
        if let (Some(a), Some(b)) = (first(&floor, ray), first(&below, ray)) {
            differences.push((a - b).abs() / a);
        }
    }
    Ok(greatest(differences))
}

/// The number of rays that see the second of two equal boxes.
fn seeing_the_second_box(rays: &[Ray]) -> Result<usize, Error> {
    let world = World::new(Color::BLACK)?.with(box_below(0.0)?, 0);
    Ok(seeing_the_second(&world.with(box_below(0.0)?, 1), rays))
}

pub fn cases(effort: Effort) -> Vec<Case> {
    let count = effort.choose(2_000, 20_000);
    let some_see_each = tried(|| {
        let seeing = seeing_the_box(0.0, &rays(count)?)?;
        Ok(0 < seeing && seeing < count)
    });
    vec![
        Case {
            id: "S33".into(),
            what: format!(
                "a floor, and a box whose top lies in it, {count} rays: \
                 greatest difference of t, in t"
            ),
            exact: Number(0.0),
            // The floor divides, with one rounding. The box multiplies by a rounded inverse, with
            // two. The exact t are equal, so that the two differ by at most 3 u = 1.5 eps of them.
            bound: Absolute(1.5 * EPSILON),
            ours: tried(|| greatest_difference(&rays(count)?)),
            ..Case::default()
        },
        Case {
            id: "S34".into(),
            what: "the same two: rounding decides, and some rays see the floor and some the box"
                .into(),
            exact: Flag(true),
            ours: some_see_each,
            ..Case::default()
        },
        Case {
            id: "S35".into(),
            what: format!("the same, the top 1e-9 lower, {count} rays: see the box"),
            exact: Number(0.0),
            ours: tried(|| seeing_the_box(-1e-9, &rays(count)?)),
            ..Case::default()
        },
        Case {
            id: "S36".into(),
            what: format!("the same box twice, {count} rays: see the second"),
            exact: Number(0.0),
            ours: tried(|| seeing_the_second_box(&rays(count)?)),
            ..Case::default()
        },
    ]
}
