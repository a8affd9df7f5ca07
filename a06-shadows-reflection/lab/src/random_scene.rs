//! Random worlds of extreme numbers, whose surfaces mirror and whose lights cast shadows.

use a04_intersections::Geometry;
use a04_lab::random_scene::Place;
use a05_lighting::{DirectionalLight, Lambert, Phong, PointLight, SpotLight};
use a06_shadows_reflection::{LightSource, Reflective, ShadowedWorld, Surface};
use common::{ArgumentError, Color};

fn color(place: &mut Place) -> Color {
    let [r, g, b] = [(); 3].map(|()| place.numbers.between(0.0, 1.0));
    Color::new(r, g, b)
}

/// Two of three surfaces mirror.
fn surface(place: &mut Place) -> Result<Box<dyn Surface>, ArgumentError> {
    let (diffuse, specular, reflection) = (color(place), color(place), color(place));
    let exponent = [0.0, 1.0, 2.5, 64.0][place.numbers.below(4)];
    Ok(match place.numbers.below(6) {
        0 => Box::new(Lambert::new(diffuse)?),
        1 => Box::new(Phong::new(diffuse, specular, exponent)?),
        _ => Box::new(Reflective::new(diffuse, specular, exponent, reflection)?),
    })
}

fn light(place: &mut Place) -> Result<LightSource, ArgumentError> {
    let (color, from, direction) = (color(place), place.point(), place.direction());
    let casts_shadows = place.numbers.below(4) > 0;
    Ok(match place.numbers.below(3) {
        0 => LightSource::new(PointLight::new(color, from)?, casts_shadows),
        1 => LightSource::new(DirectionalLight::new(color, direction)?, casts_shadows),
        _ => LightSource::new(SpotLight::new(color, from, direction, 0.7)?, casts_shadows),
    })
}

/// The world of these shapes, with random surfaces and up to three lights.
pub fn world(
    place: &mut Place,
    shapes: Vec<Box<dyn Geometry>>,
) -> Result<ShadowedWorld, ArgumentError> {
    let mut world = ShadowedWorld::empty(color(place), color(place))?;
    for shape in shapes {
        world = world.with(shape, surface(place)?);
    }
    for _ in 0..place.numbers.below(4) {
        world = world.lit_by(light(place)?);
    }
    Ok(world)
}
