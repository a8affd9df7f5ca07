//! Parallel cameras anywhere, compared with the solution.

use crate::prelude::*;

yours! {
    OrthographicCamera => new_camera(|([e, g, t], s): ([_; 3], _)| {
        OrthographicCamera::new(point(e), vector(g), vector(t), s)
    })
}

/// Makes a camera of eye, gaze and up vector, and the height of its picture.
type Code = NewCamera<([[f64; 3]; 3], f64)>;
type Other = Variant<Code>;

const AHEAD: [[f64; 3]; 3] = [[0.0; 3], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]];

pub fn exercise() -> Exercise<Code> {
    Exercise {
        picture: Picture::scene("scene-6", |new: &Code, settings| {
            let world = Box::new(scene_6()?.world)
                .recorded(a03_rays_cameras::instruments::Instruments::LESSON);
            let camera = new((AHEAD, 3.0))?;
            paint(&*camera, &|ray: &Ray| world.radiance(ray, 1), settings)
        }),
        wrong: vec![
            Other::new(
                "a wide picture shows more to the sides",
                variant(|[w, h], [x, y]| [from_middle(x, w), from_middle(y, h)]),
            ),
            Other::new(
                "s is the height of the picture, not its width",
                variant(|[w, h], [x, y]| [from_middle(x, w), h / w * from_middle(y, h)]),
            ),
            Other::new(
                "a single row or column is in the middle, where 0 / 0 is not a number",
                variant(|[w, h], [x, y]| [w / h * (x / (w - 1.0) - 0.5), y / (h - 1.0) - 0.5]),
            ),
        ],
        ..cameras(Cameras {
            words: "eye, gaze and up {}, s = {}",
            first: (AHEAD, 1.0),
            further: vec![
                ([[0.0; 3], [0.0, 0.0, -1.0], [0.0, 2.0, 1.0]], 1.0),
                ([[1.0, 2.0, 3.0], [0.0, 1.0, -1.0], [0.0, 1.0, 0.0]], 1.0),
                ([[0.0; 3], [0.0, 0.0, -1e-18], [0.0, 1e-18, 0.0]], 1.0),
                ([[0.0; 3], [0.0, 0.0, -1e18], [0.0, 1e18, 0.0]], 1.0),
            ],
            any: |r| ([(); 3].map(|()| r.triple(5.0)), r.between(0.5, 9.0)),
        })
    }
}

/// The place of a pixel of n in a row or column, from -1/2 to 1/2; the only one is in the middle.
fn from_middle(pixel: f64, n: f64) -> f64 {
    if n == 1.0 {
        0.0
    } else {
        pixel / (n - 1.0) - 0.5
    }
}

/// A camera whose rays begin at a position of the picture, in its heights.
fn variant(position: fn([f64; 2], [f64; 2]) -> [f64; 2]) -> Code {
    new_camera(move |([e, g, t], s): ([_; 3], _)| {
        let Basis { e, u, v, w } = Basis::new(point(e), vector(g), vector(t))?;
        Ok(OwnCamera(move |size: [f64; 2], [x, y]: [f64; 2]| {
            let [right, up] = position(size, [x, y]);
            Ray::derived(e + u * (s * right) + v * (s * up), -w)
        }))
    })
}
