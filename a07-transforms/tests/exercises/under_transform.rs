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

type Other = Variant<Code>;

const SCENE: LitScene = LitScene {
    name: "sphere-transformation",
    eye: 20.0,
    ..BOX_SCENE
};

pub fn exercise() -> Exercise<Code> {
    let [o, d, n] = [[0.0; 3], [0.0, 0.0, -2.0], [0.6, 0.8, 0.0]];
    let chains = Questions {
        words: "chain {}; origin and direction of the ray, and normal {}",
        simple: vec![
            (vec![Step::Translate([2.0, 0.0, 0.0])], [o, d, n]),
            (vec![Step::Scale([2.0; 3])], [o, d, n]),
            (vec![Step::Scale([2.0, 1.0, 1.0])], [[1.0; 3], d, n]),
            (vec![Step::Scale([-1.0, 1.0, 1.0])], [[1.0; 3], d, n]),
            (vec![Step::Scale([1e12; 3])], [o, d, n]),
            (vec![Step::Scale([1e-12; 3])], [o, d, n]),
            (vec![], [o, d, [0.0; 3]]),
        ],
        others: random(|r| (Step::random(r), [(); 3].map(|()| r.triple(5.0)))),
        answer: |code: &Code, (steps, [o, d, n]): (Vec<Step>, [_; 3])| {
            let transform = transform(&steps);
            let ray = Ray::derived(point(o), vector(d));
            let ray = (code.ray_to_object)(&transform, &ray);
            let n = (code.normal_from_object)(&transform, vector(n).as_normal());
            Answer::named("origin", array(ray.origin()))
                .and("direction", array(ray.direction()))
                .and("the normal", n.map(array))
        },
    };
    Exercise {
        questions: chains.into(),
        picture: SCENE.with(|code: &Code, world| {
            let material = Phong::new(Color::new(0.6, 0.0, 0.0), Color::WHITE, 64.0)?;
            Ok(world.with(ellipsoid(*code)?, Box::new(material)))
        }),
        wrong: vec![
            Other::from_right("the inverse leads to the object", |right| Code {
                ray_to_object: forward,
                ..right
            }),
            Other::from_right("the direction keeps its length", |right| Code {
                ray_to_object: shortened,
                ..right
            }),
            Other::from_right(
                "a direction is not moved, because it is no point",
                |right| Code {
                    ray_to_object: |t, ray| {
                        let d = ray.direction();
                        let end = t.inverse() * Point3::new(d.x(), d.y(), d.z());
                        Ray::derived(t.inverse() * ray.origin(), end - Point3::ORIGIN)
                    },
                    ..right
                },
            ),
            Other::from_right("an origin is moved, because it is no direction", |right| {
                Code {
                    ray_to_object: |t, ray| {
                        let o = t.inverse() * (ray.origin() - Point3::ORIGIN);
                        Ray::derived(Point3::ORIGIN + o, t.inverse() * ray.direction())
                    },
                    ..right
                }
            }),
            Other::from_right("a normal is no vector", |right| Code {
                normal_from_object: |t, n| unit(t.matrix() * Vector3::from(n)),
                ..right
            }),
        ],
        ..Exercise::default()
    }
}

fn ellipsoid(code: Code) -> Made<impl Geometry> {
    let transform = Transform::IDENTITY.scale(6.0, 1.2, 4.0)?;
    let child = Sphere::new(Point3::ORIGIN, 1.0)?;
    Ok(own(move |ray: &Ray, within| {
        let hit = child.hit(&(code.ray_to_object)(&transform, ray), within)?;
        let normal = (code.normal_from_object)(&transform, hit.normal)?;
        Some(Hit::new(hit.t, normal))
    }))
}

fn unit(v: Vector3) -> Option<Normal3> {
    v.normalized().map(Vector3::as_normal)
}

fn forward(t: &Transform, ray: &Ray) -> Ray {
    Ray::derived(t.matrix() * ray.origin(), t.matrix() * ray.direction())
}

fn shortened(t: &Transform, ray: &Ray) -> Ray {
    let ray = t.ray_to_object(ray);
    let d = ray.direction().normalized();
    Ray::derived(ray.origin(), d.unwrap_or_default())
}
