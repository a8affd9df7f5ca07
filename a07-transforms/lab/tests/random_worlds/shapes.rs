//! Extreme scenes of stage 4, in which each shape has a colour.

use a03_rays_cameras::View;
use a04_intersections::World;
use common::{ArgumentError, Color};

use crate::random_scene::Place;
use crate::same_pictures::compare_scenes;

/// A scene of shapes with a colour each.
fn view(seed: u64, mut place: Place) -> Result<View, ArgumentError> {
    let mut world = World::new(Color::BLACK)?;
    for (i, shape) in place.shapes().into_iter().enumerate() {
        world = world.with(shape, Color::gray(1.0 + i as f64));
    }
    let camera = place.camera(seed)?;
    Ok(View::new(camera, world).boxed())
}

#[test]
fn all_renderers_draw_the_same_pictures() {
    compare_scenes(0..60, view);
}
