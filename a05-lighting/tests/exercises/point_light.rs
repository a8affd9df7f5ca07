//! Lamps, compared with the lesson's.

use crate::prelude::*;

yours! { point_light => light_at(|(c, lamp), p| point_light(color(c), point(lamp), p)) }

type Code = LightAt<([f64; 3], [f64; 3])>;
type Other = Variant<Code>;

pub fn point_light(color: Color, lamp: Point3, point: Point3) -> Option<Illumination> {
    PointLight::new(color, lamp).ok()?.illumination(point)
}

pub fn exercise() -> Exercise<Code> {
    let lit = Lit {
        view: scenes::phong,
        name: "PointLight",
        light: ([1.0; 3], [4.0; 3]),
    };
    Exercise {
        picture: Picture::scene("phong", move |light, settings| {
            lit.rendered(light, settings)
        }),
        right: vec![Other::new("divided by the distance", light_at(divided))],
        wrong: vec![Other::from_right(
            "this lamp is as bright at every distance",
            |right| {
                light_at(move |parameters, p| {
                    let light = right(parameters, p)?;
                    let square = light.distance * light.distance;
                    Some(Illumination {
                        color: light.color * (1.0 / square),
                        ..light
                    })
                })
            },
        )],
        ..lights([Lights {
            words: "light {} at {}",
            first: ([1.0, 0.5, 0.25], LAMP),
            simple: vec![],
            others: vec![],
            any: |r| (channels(r), r.triple(5.0)),
        }])
    }
}

fn divided((c, lamp): ([f64; 3], [f64; 3]), p: Point3) -> Arriving {
    let mut light = point_light(color(c), point(lamp), p)?;
    let to_lamp = point(lamp) - p;
    light.distance = to_lamp.magnitude();
    light.direction = to_lamp * (1.0 / light.distance);
    Some(light)
}
