//! Spots with narrow and wide rims, compared with the solution.

use crate::prelude::*;

yours! {
    soft_spot => light_at(|(c, lamp, direction, angles), p| {
        soft_spot(c, point(lamp), vector(direction), angles, p)
    })
}

type Code = LightAt<Spot>;

/// Colour, place and direction of a lamp, and the inner and the outer angle.
type Spot = (Color, [f64; 3], [f64; 3], [f64; 2]);

pub fn exercise() -> Exercise<Code> {
    let lit = Lit {
        view: scenes::phong_spot,
        name: "",
        light: (Color::WHITE, [4.0; 3], [-1.0; 3], [0.1, 0.3]),
    };
    Exercise {
        picture: lit.own(),
        ..lights()
    }
}
