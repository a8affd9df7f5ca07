//! Rays in random worlds of mirrors, compared with the solution.

use crate::prelude::*;

yours! { trace }

type Code = fn(&ShadowedWorld, &Ray, u32) -> Color;

pub fn exercise() -> Exercise<Code> {
    Exercise {
        forms: vec![
            Form::new(
                |trace: &Code, ((centre, radius), reflection, [o, d], depth): (_, _, [_; 2], _)| {
                    let world = mirrors(centre, radius, reflection).ok()?;
                    let ray = Ray::derived(point(o), unit(d));
                    Some(trace(&world, &ray, depth).channels())
                },
            ),
            Form::new(|trace: &Code, (height, reflection, depth)| {
                let world = two_mirrors(height, reflection).ok()?;
                let origin = Point3::new(0.0, height / 2.0, 0.0);
                let ray = Ray::derived(origin, Vector3::new(0.6, 0.8, 0.0));
                Some(trace(&world, &ray, depth).channels())
            }),
        ],
        picture: StudentPicture::scene("sphere", |trace: &Code, settings| {
            traced_picture(scenes::sphere()?, settings, |world, ray, depth| {
                trace(world, ray, depth)
            })
        }),
        ..Exercise::default()
    }
}
