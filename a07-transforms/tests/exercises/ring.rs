//! Rings anywhere, compared with the solution.

use crate::prelude::*;

yours! {
    Ring => new_shape(|(c, n, hole, r)| Ring::new(point(c), vector(n).as_normal(), hole, r))
}

/// Makes a ring of centre, normal, and the radii of its hole and its rim.
type Code = NewShape<([f64; 3], [f64; 3], f64, f64)>;

pub fn exercise() -> Exercise<Code> {
    let eye = Eye {
        from: [1.0, 2.0, 6.0],
        to: [0.0; 3],
    };
    Exercise {
        picture: lit(eye, saturn),
        ..shapes()
    }
}

fn saturn(new: &Code) -> Made<World<Color>> {
    let ring = new(([0.0; 3], [0.3, 1.0, 0.1], 1.3, 2.2))?;
    let planet = Sphere::new(Point3::ORIGIN, 1.0)?;
    Ok(World::new(Color::gray(0.05))?
        .with(ring, Color::gray(0.8))
        .with(planet, Color::new(0.9, 0.75, 0.5)))
}
