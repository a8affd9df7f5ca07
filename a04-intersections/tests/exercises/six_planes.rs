//! Boxes of six planes anywhere, compared with the solution.

use crate::prelude::*;

yours! { SixPlanes => new_shape(|(lbf, run)| SixPlanes::new(point(lbf), point(run))) }

type Code = NewShape<Corners>;
type Other = Variant<Code>;

pub fn exercise() -> Exercise<Code> {
    let eye = Eye {
        from: [2.0, 2.2, 2.9],
        to: [0.05, 0.6, 0.0],
    };
    Exercise {
        picture: shown(([-0.3, 0.1, -0.7], [0.4, 1.2, 0.6]), eye),
        wrong: vec![Other::from_right(
            "rounding puts a hit beside its own plane",
            |right| {
                new_shape(move |(lbf, run)| {
                    let planes = right((lbf, run))?;
                    let [lbf, run] = [lbf, run].map(|corner| point(corner).to_glam());
                    Ok(own(move |ray: &Ray, within| {
                        let hit = planes.hit(ray, within)?;
                        let p = ray.at(hit.t).to_glam();
                        Some(hit).filter(|_| lbf.min(p) == lbf && run.max(p) == run)
                    }))
                })
            },
        )],
        ..shapes(boxes())
    }
}
