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

const COLOR: Color = Color::new(1.0, 0.5, 0.25);
const ANGLES: [f64; 2] = [0.5, 1.0];

pub fn exercise() -> Exercise<Code> {
    let lit = Lit {
        view: scenes::phong_spot,
        name: "",
        light: (Color::WHITE, [4.0; 3], [-1.0; 3], [0.1, 0.3]),
    };
    Exercise {
        picture: lit.own(),
        ..lights([Lights {
            words: "light {} at {}, which shines along {}, inner and outer angle {}",
            first: (COLOR, LAMP, [0.0, -2.0, 0.0], ANGLES),
            simple: vec![
                ((COLOR, LAMP, [0.0, -1e-18, 0.0], ANGLES), [0.0; 3]),
                ((COLOR, LAMP, [0.0, -1e18, 0.0], ANGLES), [3.0, 0.0, 0.0]),
            ],
            others: at_borders(),
            any,
        }])
    }
}

fn any(r: &mut Random) -> Spot {
    let inner = r.between(0.0, 1.4);
    let angles = [inner, inner + r.between(0.05, 1.6)];
    (r.color(), r.triple(5.0), r.triple(5.0), angles)
}

/// Points on the axis, and just inside and outside of the angles.
fn at_borders() -> Vec<(Spot, [f64; 3])> {
    let (mut points, mut r) = (Vec::new(), Random::new(3));
    for spot in random(any) {
        let (_, lamp, direction, [inner, outer]) = spot;
        let angles = [0.0, inner, outer * (1.0 - 1e-6), outer * (1.0 + 1e-6)];
        let angle = angles[points.len() % 4];
        points.push((spot, at_angle(&mut r, lamp, direction, angle)));
    }
    points
}
