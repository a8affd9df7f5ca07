//! All renderers draw the same pictures of random scenes of extreme numbers.

use a03_rays_cameras::View;
use a04_intersections::World;
use a04_lab::random_scene::Place;
use a04_lab::same_pictures::{compare_all, compare_thousands};
use common::{ArgumentError, Color};

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
    let (pictures, colorful) = compare_all(0..60, view);
    assert!(pictures > 40 && colorful > 10, "{pictures}, {colorful}");
}

/// Takes minutes: `cargo test --release -p a04-intersections --test stage -- --ignored`.
#[test]
#[ignore = "takes minutes"]
fn all_renderers_draw_the_same_five_thousand_pictures() {
    compare_thousands(1_000..7_000, view);
}
