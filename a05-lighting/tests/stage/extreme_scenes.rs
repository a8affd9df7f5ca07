//! All renderers draw the same pictures of random scenes of extreme numbers, with materials and
//! lights.
//!
//! `RANDOM_SCENES=6000 cargo test --release -p a05-lighting --test stage extreme` compares thousands, in minutes.

use a03_rays_cameras::View;
use a04_lab::random_scene::Place;
use a04_lab::same_pictures::compare_scenes;
use a05_lighting::{
    DirectionalLight, Lambert, Light, LitWorld, Material, Phong, PointLight, SingleColor, SpotLight,
};
use common::{ArgumentError, Color};

fn color(place: &mut Place) -> Color {
    let [r, g, b] = [(); 3].map(|()| place.numbers.between(0.0, 1.0));
    Color::new(r, g, b)
}

fn material(place: &mut Place) -> Result<Box<dyn Material>, ArgumentError> {
    let (diffuse, specular) = (color(place), color(place));
    let exponent = [0.0, 1.0, 2.5, 64.0][place.numbers.below(4)];
    Ok(match place.numbers.below(3) {
        0 => Box::new(SingleColor::new(diffuse)?),
        1 => Box::new(Lambert::new(diffuse)?),
        _ => Box::new(Phong::new(diffuse, specular, exponent)?),
    })
}

fn light(place: &mut Place) -> Result<Box<dyn Light>, ArgumentError> {
    let (color, from, direction) = (color(place), place.point(), place.direction());
    Ok(match place.numbers.below(3) {
        0 => Box::new(PointLight::new(color, from)?),
        1 => Box::new(DirectionalLight::new(color, direction)?),
        _ => Box::new(SpotLight::new(color, from, direction, 0.7)?),
    })
}

fn view(seed: u64, mut place: Place) -> Result<View, ArgumentError> {
    let mut world = LitWorld::new(color(&mut place), color(&mut place))?;
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
