//! Cones of light of all angles, compared with the solution.

use std::f64::consts::PI;

use crate::prelude::*;

yours! {
    spot_light => light_at(|(c, lamp, axis, half_angle), p| {
        spot_light(c, point(lamp), unit(axis), half_angle, p)
    })
}

type Code = LightAt<Cone>;

/// Colour, place and axis of a lamp, and the half angle.
type Cone = (Color, [f64; 3], [f64; 3], f64);

pub fn exercise() -> Exercise<Code> {
    let lit = Lit {
        view: scenes::phong_spot,
        name: "SpotLight",
        light: (Color::WHITE, [4.0; 3], [-1.0; 3], PI / 14.0),
    };
    Exercise {
        picture: lit.scene("phong-spot"),
        ..lights()
    }
}
