//! Rays into glass and out of it, also just before and beyond total reflection, compared with
//! the solution.

use crate::prelude::*;

yours! { refracted }

/// The direction beyond a surface: by the direction before, the normal, and the index.
type Code = fn(Vector3, Normal3, f64) -> Option<Vector3>;

pub fn exercise() -> Exercise<Code> {
    // Straight in and out, aslant in, mirrored, and aslant out.
    let directions = [
        [0.0, -1.0],
        [0.0, 1.0],
        [0.8, -0.6],
        [0.8, 0.6],
        [0.28, 0.96],
    ];
    let rays = Questions {
        words: "direction {}, normal {}, index {}",
        simple: directions
            .map(|[x, y]| ([x, y, 0.0], [0.0, 1.0, 0.0], 2.0))
            .to_vec(),
        others: random(|r| {
            let (d, n) = (array(unit(r.triple(1.0))), unit(r.triple(1.0)));
            let index = r.between(1.1, 2.5);
            let aside = unit(array(n.cross(vector(d))));
            // Just before and beyond the angle from which on all light is mirrored.
            let sin = (1.0 + [1e-6, -1e-6][r.below(2) as usize]) / index;
            let limit = array(aside * sin + n * (1.0 - sin * sin).sqrt());
            ([d, limit][r.below(2) as usize], array(n), index)
        }),
        answer: |refracted: &Code, (d, n, index)| {
            refracted(unit(d), unit(n).as_normal(), index).map(array)
        },
    };
    Exercise {
        questions: rays.into(),
        picture: Picture::own(under_water),
        ..Exercise::default()
    }
}

/// Objects below the surface of a water, seen from above.
fn under_water(refracted: &Code, settings: &Settings) -> Result<Image, Error> {
    let (surface, up) = (2.5, Normal3::new(0.0, 1.0, 0.0));
    rendered(&scenes::sphere()?, settings, |world, ray, depth| {
        let Some(below) = refracted(ray.direction(), up, 4.0 / 3.0) else {
            return Color::BLACK;
        };
        let t = (surface - ray.origin().y()) / ray.direction().y();
        RecursiveTracer::new(world).trace(&Ray::derived(ray.at(t), below), depth)
    })
}
