//! Discs anywhere, compared with the solution.

use crate::prelude::*;

yours! { Disc => new_shape(|(c, n, r)| Disc::new(point(c), vector(n).as_normal(), r)) }

/// Makes a disc of centre, normal and radius.
type Code = NewShape<([f64; 3], [f64; 3], f64)>;

const SCENE: LitScene = LitScene {
    name: "disc",
    eye: 8.0,
    lamp: [8.0; 3],
    casts_shadows: true,
    ambient: 0.1,
};

pub fn exercise() -> Exercise<Code> {
    Exercise {
        picture: SCENE.with(|new: &Code, world| {
            let (half, up) = (Color::gray(0.5), [0.0, 1.0, 0.0]);
            let plane = Plane::new(Point3::ORIGIN, vector(up).as_normal())?;
            let red = Reflective::new(Color::RED, Color::BLACK, 64.0, half)?;
            let disc = new(([0.0, 0.001, 0.0], up, 5.0))?;
            let green = Reflective::new(Color::GREEN, Color::WHITE, 2000.0, half)?;
            Ok(world.with(plane, Box::new(red)).with(disc, Box::new(green)))
        }),
        ..shapes()
    }
}
