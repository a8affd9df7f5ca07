//! Rays and normals under chains of steps, compared with the solution.

use crate::prelude::*;

yours! {
    ray_to_object, normal_from_object => crate::under_transform::Code {
        ray_to_object,
        normal_from_object,
    }
}

#[derive(Clone, Copy)]
pub struct Code {
    pub ray_to_object: fn(&Transform, &Ray) -> Ray,
    pub normal_from_object: fn(&Transform, Normal3) -> Option<Normal3>,
}

const SCENE: LitScene = LitScene {
    name: "sphere-transformation",
    eye: 20.0,
    ..BOX_SCENE
};

pub fn exercise() -> Exercise<Code> {
    Exercise {
        picture: SCENE.with(|code: &Code, world| {
            let material = Phong::new(Color::new(0.6, 0.0, 0.0), Color::WHITE, 64.0)?;
            Ok(world.with(ellipsoid(*code)?, Box::new(material)))
        }),
        ..Exercise::asked(|code: &Code, (steps, [o, d, n]): (Vec<Step>, [_; 3])| {
            let transform = transform(&steps);
            let ray = Ray::derived(point(o), vector(d));
            let ray = (code.ray_to_object)(&transform, &ray);
            let n = (code.normal_from_object)(&transform, vector(n).as_normal());
            Answer::named("origin", array(ray.origin()))
                .and("direction", array(ray.direction()))
                .and("the normal", n.map(array))
        })
    }
}

fn ellipsoid(code: Code) -> Made<impl Geometry> {
    let transform = Transform::IDENTITY.scale(6.0, 1.2, 4.0)?;
    let child = Sphere::new(Point3::ORIGIN, 1.0)?;
    Ok(OwnShape(move |ray: &Ray, within: Interval| {
        let hit = child.hit(&(code.ray_to_object)(&transform, ray), within)?;
        let normal = (code.normal_from_object)(&transform, hit.normal)?;
        Some(Hit::new(hit.t, normal))
    }))
}
