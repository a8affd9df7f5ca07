//! Extreme scenes of stage 7: discs, nodes, groups, and lamps that are fixed to them.

use a02_math::Point3;
use a03_rays_cameras::{Ray, View};
use a04_intersections::{Geometry, Interval};
use a05_lighting::PointLight;
use a06_shadows_reflection::LightSource;
use a07_transforms::{Disc, Node, Transform, traced};
use common::{ArgumentError, Color};

use crate::mirrors::world;
use crate::random_scene::Place;
use crate::same_pictures::compare_scenes;

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

fn shapes(place: &mut Place) -> Vec<Box<dyn Geometry>> {
    let mut shapes = place.shapes();
    for _ in 0..place.numbers.below(20) {
        let (centre, normal, radius) = (place.point(), place.direction(), place.length());
        if let Ok(disc) = Disc::new(centre, normal.as_normal(), radius) {
            shapes.push(Box::new(disc));
        }
    }
    shapes
}

fn view(seed: u64, mut place: Place) -> Result<View, ArgumentError> {
    let shapes = shapes(&mut place).into_iter();
    let shapes: Result<Vec<_>, _> = shapes.map(|shape| under_nodes(&mut place, shape)).collect();
    let world = world(&mut place, shapes?)?;
    Ok(traced(View::new(place.camera(seed)?, world)))
}

#[test]
fn all_renderers_draw_the_same_pictures() {
    compare_scenes(0..40, view);
}

/// Several shapes under one node, in one of six cases with a scale so unequal that the engine
/// calls the node's own `hit`.
fn group(
    place: &mut Place,
    shapes: Vec<Box<dyn Geometry>>,
) -> Result<Box<dyn Geometry>, ArgumentError> {
    let transform = match place.numbers.below(6) {
        0 => Transform::IDENTITY.scale(1.0, 1e-7, 1.0)?,
        1 => Transform::IDENTITY.rotate_y(0.3)?,
        2 => transform(place)?,
        _ => Transform::IDENTITY,
    };
    let mut node = Node::new(transform);
    for shape in shapes {
        node = node.with(shape);
    }
    Ok(Box::new(node))
}

/// A point of the geometry, where a random ray hits it.
fn point_on(place: &mut Place, geometry: &dyn Geometry) -> Option<Point3> {
    let ray = Ray::new(place.point(), place.direction()).ok()?;
    let hit = geometry.hit(&ray, Interval::AHEAD)?;
    Some(ray.at(hit.t))
}

/// Groups of shapes, some of them in groups of their own, and lamps that are fixed to them.
fn view_of_groups(seed: u64, mut place: Place) -> Result<View, ArgumentError> {
    let mut shapes = shapes(&mut place);
    let mut groups = Vec::new();
    while !shapes.is_empty() {
        let first = shapes.len().saturating_sub(1 + place.numbers.below(8));
        let mut members = shapes.split_off(first);
        if place.numbers.below(3) == 0 {
            let inner = members.split_off(members.len() / 2);
            members.push(group(&mut place, inner)?);
        }
        groups.push(group(&mut place, members)?);
    }
    let mut lamps = Vec::new();
    for _ in 0..20 {
        let at = place.numbers.below(groups.len().max(1));
        if let Some(group) = groups.get(at)
            && lamps.len() < 3
        {
            lamps.extend(point_on(&mut place, &**group));
        }
    }
    let mut world = world(&mut place, groups)?;
    for lamp in lamps {
        world = world.lit_by(LightSource::new(PointLight::new(Color::WHITE, lamp)?, true));
    }
    Ok(traced(View::new(place.camera(seed)?, world)))
}

#[test]
fn all_renderers_draw_the_same_shadows_of_groups() {
    compare_scenes(1_100..1_140, view_of_groups);
}
