//! Extreme scenes of stage 5, with materials and lights.

use a03_rays_cameras::View;
use a05_lighting::{
    DirectionalLight, Lambert, Light, LitWorld, Material, Phong, PointLight, SingleColor, SpotLight,
};
use common::ArgumentError;

use crate::random_scene::Place;
use crate::same_pictures::compare_scenes;

fn material(place: &mut Place) -> Result<Box<dyn Material>, ArgumentError> {
    let (diffuse, specular) = (place.color(), place.color());
    let exponent = [0.0, 1.0, 2.5, 64.0][place.numbers.below(4)];
    Ok(match place.numbers.below(3) {
        0 => Box::new(SingleColor::new(diffuse)?),
        1 => Box::new(Lambert::new(diffuse)?),
        _ => Box::new(Phong::new(diffuse, specular, exponent)?),
    })
}

fn light(place: &mut Place) -> Result<Box<dyn Light>, ArgumentError> {
    let (color, from, direction) = (place.color(), place.point(), place.direction());
    Ok(match place.numbers.below(3) {
        0 => Box::new(PointLight::new(color, from)?),
        1 => Box::new(DirectionalLight::new(color, direction)?),
        _ => Box::new(SpotLight::new(color, from, direction, 0.7)?),
    })
}

fn view(seed: u64, mut place: Place) -> Result<View, ArgumentError> {
    let mut world = LitWorld::new(place.color(), place.color())?;
    for shape in place.shapes() {
        world = world.with(shape, material(&mut place)?);
    }
    for _ in 0..2 {
        world = world.lit_by(light(&mut place)?);
    }
    let camera = place.camera(seed)?;
    Ok(View::new(camera, world).boxed())
}

#[test]
fn all_renderers_draw_the_same_pictures() {
    compare_scenes(0..40, view);
}
