//! A smooth triangle and a ball that lean, compared with the solution.

use crate::prelude::*;

/// A ball, or a triangle whose corners have normals aslant.
fn upright(is_ball: bool) -> Made<Shape> {
    let ball = Box::new(Sphere::new(Point3::ORIGIN, 1.0)?);
    let triangle = Box::new(smooth_triangle(0.0)?);
    Ok(if is_ball { ball } else { triangle })
}

pub fn check<G: Geometry>(check: &mut Check, new: impl Fn(Shape, f64) -> G) {
    compare(
        check,
        "a shape (a ball: {}) sheared by {}",
        (true, 0.5),
        |r| (r.below(2) == 0, r.between(-3.0, 3.0)),
        &|(is_ball, by)| Ok(Box::new(Sheared::new(upright(is_ball)?, by))),
        &|(is_ball, by)| Ok(Box::new(new(upright(is_ball)?, by))),
    );
    let world = || {
        let beam = AxisAlignedBox::new(point([-2.3, 0.0, -0.7]), point([-1.0, 2.0, 0.7]))?;
        let floor = Plane::new(Point3::ORIGIN, Normal3::new(0.0, 1.0, 0.0))?;
        let round = Sphere::new(Point3::new(0.9, 1.0, 0.0), 1.0)?;
        let world = World::new(Color::gray(0.08))?.with(floor, Color::gray(0.6));
        let world = world.with(new(Box::new(beam), 0.6), Color::new(0.4, 0.7, 1.0));
        Ok(world.with(new(Box::new(round), 0.6), Color::new(1.0, 0.5, 0.3)))
    };
    show_lit(check, world(), [0.3, 2.6, 7.5], [0.3, 0.8, 0.0]);
}

variants! { check:
    yours => Sheared::new;
    wrong "both normals lean" => |shape, by| {
        let leaning = Sheared::new(shape, by);
        Own(move |ray: &Ray, i: Interval| {
            let Hit { t, normal, .. } = leaning.hit(ray, i)?;
            Some(Hit::new(t, normal))
        })
    };
}
