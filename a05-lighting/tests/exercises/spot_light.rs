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
        ..lights([1.0, PI].map(|half_angle| Lights {
            words: "light {} at {}, axis {}, half angle {}",
            first: (
                Color::new(1.0, 0.5, 0.25),
                LAMP,
                [0.0, -1.0, 0.0],
                half_angle,
            ),
            simple: vec![],
            others: at_borders(),
            any,
        }))
    }
}

fn any(r: &mut Random) -> Cone {
    let [lamp, axis] = [(); 2].map(|()| r.triple(5.0));
    (r.color(), lamp, array(unit(axis)), r.between(0.05, 3.1))
}

/// Points on the axis, and just inside and outside of the cone.
fn at_borders() -> Vec<(Cone, [f64; 3])> {
    let (mut points, mut r) = (Vec::new(), Random::new(3));
    for cone in random(any) {
        let (_, lamp, axis, half_angle) = cone;
        let factor = if points.len() % 4 == 0 { -1e-6 } else { 1e-6 };
        for angle in [0.0, half_angle * (1.0 + factor)] {
            points.push((cone, at_angle(&mut r, lamp, axis, angle)));
        }
    }
    points
}
