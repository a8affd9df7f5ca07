//! A smooth triangle and a ball that lean, compared with the solution.

use crate::prelude::*;

yours! {
    Sheared => |upright: Shape, by| -> Shape { Box::new(Sheared::new(upright, by)) }
}

/// Makes a shape lean by this much.
type Code = fn(Shape, f64) -> Shape;

pub fn exercise() -> Exercise<Code> {
    let eye = Eye {
        from: [0.3, 2.6, 7.5],
        to: [0.3, 0.8, 0.0],
    };
    let mut forms =
        hits_and_parts(|new: &Code, by| Ok(new(Box::new(Sphere::new(Point3::ORIGIN, 1.0)?), by)));
    forms.extend(hits_and_parts(|new: &Code, by| {
        Ok(new(Box::new(smooth_triangle(0.0)?), by))
    }));
    Exercise {
        forms,
        picture: lit(eye, beam_and_ball),
        ..Exercise::default()
    }
}

fn beam_and_ball(new: &Code) -> Made<World<Color>> {
    let floor = Plane::new(Point3::ORIGIN, Normal3::new(0.0, 1.0, 0.0))?;
    let beam = AxisAlignedBox::new(point([-2.3, 0.0, -0.7]), point([-1.0, 2.0, 0.7]))?;
    let ball = Sphere::new(Point3::new(0.9, 1.0, 0.0), 1.0)?;
    Ok(World::new(Color::gray(0.08))?
        .with(floor, Color::gray(0.6))
        .with(new(Box::new(beam), 0.6), Color::new(0.4, 0.7, 1.0))
        .with(new(Box::new(ball), 0.6), Color::new(1.0, 0.5, 0.3)))
}
