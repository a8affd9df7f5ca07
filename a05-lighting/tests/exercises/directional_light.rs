//! Far lights, compared with the lesson's.

use crate::prelude::*;

yours! {
    directional_light => light_at(|(c, direction), _| {
        directional_light(color(c), vector(direction))
    })
}

type Code = LightAt<([f64; 3], [f64; 3])>;
type Other = Variant<Code>;

pub fn directional_light(color: Color, direction: Vector3) -> Option<Illumination> {
    let sun = DirectionalLight::new(color, direction);
    sun.ok()?.illumination(Point3::ORIGIN)
}

pub fn exercise() -> Exercise<Code> {
    let lit = Lit {
        view: scenes::phong_directional,
        name: "DirectionalLight",
        light: ([1.0; 3], [-1.0; 3]),
    };
    Exercise {
        picture: Picture::scene("phong-directional", move |light, settings| {
            lit.rendered(light, settings)
        }),
        right: vec![Other::new("divided by the length", light_at(divided))],
        ..lights([Lights {
            words: "light {} that travels along {}",
            first: ([1.0, 0.5, 0.25], [0.0, -2.0, 0.0]),
            any: |r| {
                let length = r.scale();
                (channels(r), r.triple(5.0).map(|x| x * length))
            },
        }])
    }
}

fn divided((c, direction): ([f64; 3], [f64; 3]), _: Point3) -> Arriving {
    let direction = vector(direction);
    let mut light = directional_light(color(c), direction)?;
    light.direction = direction * (-1.0 / direction.magnitude());
    Some(light)
}
