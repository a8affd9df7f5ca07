//! Matt surfaces, compared with the solution.

use crate::prelude::*;

yours! {
    lambert => shading(lambert)
}

type Code = Shading<Color>;

pub fn exercise() -> Exercise<Code> {
    Exercise {
        picture: StudentPicture::scene("lambert", |lambert: &Code, settings| {
            shaded(scenes::lambert()?, settings, |diffuse, ray, hit, lights| {
                lambert(diffuse, ray, hit, lights)
            })
        }),
        ..materials()
    }
}
