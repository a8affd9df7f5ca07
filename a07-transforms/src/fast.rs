//! Translates nodes and discs for the engine.

use std::any::Any;

use a04_intersections::Geometry;

use crate::{Disc, Mat4x4, Node, Transform};

/// Adds the engine's shapes for a geometry of this stage or of a lower one. A node adds
/// each of its children with its transform, unless rounding may destroy their normals.
pub fn shapes<'a>(geometry: &'a dyn Geometry, add: &mut dyn FnMut(engine::Shape<'a>)) {
    let any: &dyn Any = geometry;
    if let Some(boxed) = any.downcast_ref::<Box<dyn Geometry>>() {
        shapes(&**boxed, add);
    } else if let Some(node) = any.downcast_ref::<Node>()
        && let transform = transform(&node.transform)
        && transform.is_well_conditioned()
    {
        for child in &node.children {
            shapes(&**child, &mut |shape| add(shape.transformed(&transform)));
        }
    } else if let Some(disc) = any.downcast_ref::<Disc>() {
        add(engine::Shape::Disc(engine::Disc {
            plane: disc.plane.into(),
            radius: disc.r,
        }));
    } else {
        a04_intersections::fast::shapes(geometry, add);
    }
}

fn transform(transform: &Transform) -> engine::Transform {
    let [matrix, inverse] = [transform.matrix(), transform.inverse()].map(Mat4x4::to_glam);
    engine::Transform { matrix, inverse }
}
