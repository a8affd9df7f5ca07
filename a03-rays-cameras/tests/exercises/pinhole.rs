//! Pinhole cameras anywhere, compared with the solution.

use crate::prelude::*;

yours! { PinholeCamera => new_camera(|(e, angle)| PinholeCamera::new(point(e), angle)) }

/// Makes a camera of a pinhole and an angle.
type Code = NewCamera<([f64; 3], f64)>;
pub fn exercise() -> Exercise<Code> {
    Exercise {
        picture: Picture::own(corridor),
        wrong: mistakes_with_angle(|(e, angle)| Ok((axes(e)?, angle))),
        ..cameras(Cameras {
            words: "pinhole at {}, field of view {}",
            first: ([0.0; 3], FRAC_PI_2),
            further: vec![],
            any: |r| (r.triple(9.0), r.between(0.2, 2.8)),
        })
    }
}

/// A pinhole at a point, as a camera that looks along -z.
fn axes(e: [f64; 3]) -> Made<Basis> {
    let (gaze, up) = (Vector3::new(0.0, 0.0, -1.0), Vector3::new(0.0, 1.0, 0.0));
    Basis::new(point(e), gaze, up)
}

/// Half of the width and of the height of the corridor.
const HALF: [f64; 2] = [1.6, 1.0];

/// A corridor along -z with a brown floor and a white ceiling, blue on the left and green on the
/// right. Its rings begin at each whole number; there the corners lie below the black crosses.
fn corridor(new: &Code, settings: &Settings) -> Result<Image, Error> {
    let angle = FRAC_PI_3;
    let camera = new(([0.0; 3], angle))?;
    let color = |ray: &Ray| {
        let [x, y, z] = array(ray.direction());
        let (aside, upwards) = (x.abs() / HALF[0], y.abs() / HALF[1]);
        let depth = -z / aside.max(upwards);
        let wall = match (aside > upwards, x > 0.0, y > 0.0) {
            (true, false, _) => Color::new(0.2, 0.35, 0.8),
            (true, true, _) => Color::new(0.2, 0.6, 0.3),
            (false, _, true) => Color::gray(0.9),
            (false, _, false) => Color::new(0.5, 0.3, 0.15),
        };
        if !(0.0..12.0).contains(&depth) {
            Color::gray(0.4)
        } else if (depth as u32).is_multiple_of(2) {
            wall
        } else {
            wall * 0.75
        }
    };
    let mut image = paint(&*camera, &color, settings)?;
    let pixels = f64::from(settings.size.height()) / 2.0 / libm::tan(angle / 2.0);
    let mut corners = Vec::new();
    for depth in 2..7 {
        for [x, y] in [[-1.0, -1.0], [-1.0, 1.0], [1.0, -1.0], [1.0, 1.0]] {
            let [x, y] = [x * HALF[0], y * HALF[1]].map(|n| n / f64::from(depth) * pixels);
            corners.push([x, y]);
        }
    }
    mark(&mut image, &corners);
    Ok(image)
}
