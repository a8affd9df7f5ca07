//! Translates geometries into the numbers of the engine.

use std::collections::HashMap;

use a03_rays_cameras::Ray;

use super::{Content, ShapeKind, Shapes, Shared};
use crate::{Geometry, Hit, Interval, World};

/// The engine's instances of shared shapes, by the numbers of these.
type Instances<'a> = HashMap<usize, engine::Instance<'a>>;

/// Takes a shape of the engine.
type Add<'f, 'a> = &'f mut dyn FnMut(engine::Shape<'a>);

impl Shapes {
    /// Adds the objects of a world to a scene of the engine, in their order.
    pub fn add_objects<'a, S>(
        self,
        scene: &mut engine::Scene<'a>,
        world: &'a World<S>,
        surface: impl Fn(&'a S) -> engine::Surface<'a>,
    ) {
        let mut instances = Instances::new();
        for (geometry, own) in world.objects() {
            let index = scene.add_surface(surface(own));
            let mut add = |shape| scene.add_shape(shape, index);
            self.add_shapes(geometry, &mut instances, &mut add);
        }
    }

    /// Adds the engine's shapes for a geometry: of its children, unless rounding in their
    /// transform may destroy their normals; numbers if the engine has its type; otherwise a
    /// function.
    fn add_shapes<'a>(
        self,
        geometry: &'a dyn Geometry,
        instances: &mut Instances<'a>,
        add: Add<'_, 'a>,
    ) {
        let kind = self.row(geometry).and_then(|row| row.get(geometry));
        if let Some(shape) = kind.and_then(ShapeKind::for_engine) {
            return add(shape);
        }
        if let Some(shared) = kind.and_then(ShapeKind::as_shared)
            && shared.is_worth_sharing()
        {
            return add(engine::Shape::Instance(self.instance(shared, instances)));
        }
        match kind.map(ShapeKind::content) {
            Some(Content::Children {
                shapes,
                transform: None,
            }) => {
                for child in shapes {
                    self.add_shapes(child, instances, add);
                }
            }
            Some(Content::Children {
                shapes,
                transform: Some(transform),
            }) if transform.is_well_conditioned() => {
                for child in shapes {
                    let mut add = |shape: engine::Shape<'a>| add(shape.transformed(&transform));
                    self.add_shapes(child, instances, &mut add);
                }
            }
            _ => add(by_function(geometry)),
        }
    }

    /// The engine's instance of shared shapes, whose numbers it has once.
    fn instance<'a>(
        self,
        shared: &'a Shared,
        instances: &mut Instances<'a>,
    ) -> engine::Instance<'a> {
        if let Some(known) = instances.get(&shared.id()) {
            return known.clone();
        }
        let mut shapes = Vec::new();
        for shape in shared.shapes() {
            self.add_shapes(shape, instances, &mut |shape| shapes.push(shape));
        }
        let instance = engine::Instance::new(shapes);
        instances.insert(shared.id(), instance.clone());
        instance
    }
}

/// A shape of the engine that asks a geometry, ray by ray.
fn by_function(geometry: &dyn Geometry) -> engine::Shape<'_> {
    engine::Shape::compound(
        |ray| {
            let hit = geometry.hit(&Ray::from(ray), Interval::AHEAD);
            hit.map(Into::into)
        },
        |ray, before, counts| {
            let counts = |hit: &Hit| counts(&engine::Hit::from(*hit));
            geometry.any_hit(&Ray::from(ray), Interval::before(before), &counts)
        },
    )
}
