//! All renderers draw the same pictures of random scenes of extreme numbers, with discs and nodes,
//! after shadows and mirrors.

use a03_rays_cameras::View;
use a04_intersections::Geometry;
use a04_lab::random_scene::{Place, compare_all};
use a06_lab::random_scene::world;
use a07_transforms::{Disc, Node, Transform, traced};
use common::ArgumentError;

/// Moves along axes, turns by quarters or any angle, stretches and mirrors.
fn transform(place: &mut Place) -> Result<Transform, ArgumentError> {
    let to = place.point();
    let quarters = place.numbers.below(5) as f64 * std::f64::consts::FRAC_PI_2;
    let angle = [0.0, -0.0, quarters, 0.3][place.numbers.below(4)];
    let factors = [1.0, 2.0, 0.5, 1e-9, 1e60];
    let [x, y, z] = [(); 3].map(|()| {
        let factor = factors[place.numbers.below(factors.len() - 1)];
        place.signed(factor)
    });
    Transform::IDENTITY
        .translate(to)?
        .rotate_y(angle)?
        .scale(x, y, z)
}

/// The shape, in one of four cases under one or two nodes.
fn under_nodes(
    place: &mut Place,
    shape: Box<dyn Geometry>,
) -> Result<Box<dyn Geometry>, ArgumentError> {
    if place.numbers.below(4) > 0 {
        return Ok(shape);
    }
    let inner = Node::new(transform(place)?).with(shape);
    if place.numbers.below(2) == 0 {
        return Ok(Box::new(inner));
    }
    Ok(Box::new(Node::new(transform(place)?).with(inner)))
}

fn view(seed: u64, mut place: Place) -> Result<View, ArgumentError> {
    let mut shapes = place.shapes();
    for _ in 0..place.numbers.below(20) {
        let (centre, normal, radius) = (place.point(), place.direction(), place.length());
        if let Ok(disc) = Disc::new(centre, normal.as_normal(), radius) {
            shapes.push(Box::new(disc));
        }
    }
    let shapes = shapes.into_iter();
    let shapes: Result<Vec<_>, _> = shapes.map(|shape| under_nodes(&mut place, shape)).collect();
    let world = world(&mut place, shapes?)?;
    Ok(traced(View::new(place.camera(seed)?, world)))
}

#[test]
fn all_renderers_draw_the_same_pictures() {
    let (pictures, colorful) = compare_all(0..40, view);
    assert!(pictures > 30 && colorful > 20, "{pictures}, {colorful}");
}

/// Takes minutes: `cargo test --release -p a07-transforms --test stage -- --ignored`.
#[test]
#[ignore = "takes minutes"]
fn all_renderers_draw_the_same_five_thousand_pictures() {
    let (pictures, colorful) = compare_all(1_000..7_000, view);
    assert!(pictures > 5_000, "{pictures}, {colorful}");
}
