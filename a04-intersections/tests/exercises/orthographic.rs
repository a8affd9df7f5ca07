//! Parallel cameras anywhere, compared with the solution.

use crate::prelude::*;

yours! {
    OrthographicCamera => new_camera(|([e, g, t], s): ([_; 3], _)| {
        OrthographicCamera::new(point(e), vector(g), vector(t), s)
    })
}

/// Makes a camera of eye, gaze and up vector, and the height of its picture.
type Code = NewCamera<([[f64; 3]; 3], f64)>;

const AHEAD: [[f64; 3]; 3] = [[0.0; 3], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]];

pub fn exercise() -> Exercise<Code> {
    Exercise {
        picture: StudentPicture::scene("scene-6", |new: &Code, settings| {
            let world = Box::new(scene_6()?.world)
                .instrumented(a03_rays_cameras::instruments::Instruments::LESSON);
            let camera = new((AHEAD, 3.0))?;
            paint(&*camera, &|ray: &Ray| world.radiance(ray, 1), settings)
        }),
        ..cameras()
    }
}
