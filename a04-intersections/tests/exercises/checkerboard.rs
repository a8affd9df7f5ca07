//! Points in cubes and on their faces, compared with the solution.

use crate::prelude::*;

yours! { checkerboard }

type Code = fn(Point3, Normal3) -> Color;

pub fn exercise() -> Exercise<Code> {
    Exercise {
        picture: StudentPicture::own(|checkerboard: &Code, settings| {
            let eye = Eye {
                from: [3.0, 4.0, 7.0],
                to: [0.0, 0.6, 0.0],
            };
            eye.show(&floor_and_box()?, settings, &|_, p, n| {
                checkerboard(p, n) * 0.7 + Color::gray(0.15)
            })
        }),
        ..Exercise::asked(|checkerboard: &Code, (p, n)| {
            checkerboard(point(p), vector(n).as_normal()).channels()
        })
    }
}

fn floor_and_box() -> Made<World<Color>> {
    let floor = Plane::new(Point3::ORIGIN, Normal3::new(0.0, 1.0, 0.0))?;
    let cube = AxisAlignedBox::new(point([-2.0, 0.0, -2.0]), point([1.0, 2.0, 1.0]))?;
    Ok(World::new(Color::gray(0.1))?
        .with(floor, Color::WHITE)
        .with(cube, Color::WHITE))
}
