//! Perspective cameras anywhere, compared with the solution.

use crate::prelude::*;

yours! {
    PerspectiveCamera => new_camera(|([e, g, t], angle): ([_; 3], _)| {
        PerspectiveCamera::new(point(e), vector(g), vector(t), angle)
    })
}

/// Makes a camera of eye, gaze and up vector, and an angle.
type Code = NewCamera<([[f64; 3]; 3], f64)>;
type Other = Variant<Code>;

const AHEAD: [[f64; 3]; 3] = [[0.0; 3], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]];

pub fn exercise() -> Exercise<Code> {
    let mut wrong = mistakes_with_angle(|([e, g, t], angle): ([[f64; 3]; 3], f64)| {
        Ok((Basis::new(point(e), vector(g), vector(t))?, angle))
    });
    wrong.push(Other::new(
        "v is perpendicular to w, and t is not",
        with_v(|_, t| t),
    ));
    Exercise {
        picture: scene(|new: &Code, settings, View { world: sky, .. }| {
            let camera = new((AHEAD, FRAC_PI_2))?;
            paint(&*camera, &|ray| sky.color_for(ray), settings)
        }),
        drawing: drawing(floor),
        wrong,
        ..cameras(Cameras {
            words: "eye, gaze and up {}, field of view {}",
            first: (AHEAD, FRAC_PI_2),
            further: vec![
                ([[0.0; 3], [0.0, 0.0, -1.0], [0.0, 2.0, 1.0]], 1.0),
                ([[1.0, 2.0, 3.0], [0.0, 1.0, -1.0], [0.0, 1.0, 0.0]], 1.0),
                ([[0.0; 3], [0.0, 0.0, -1e-18], [0.0, 1e-18, 0.0]], 1.0),
                ([[0.0; 3], [0.0, 0.0, -1e18], [0.0, 1e18, 0.0]], 1.0),
            ],
            any: |r| ([(); 3].map(|()| r.triple(5.0)), r.between(0.2, 2.8)),
            section: "a03-rays-cameras.md#perspective",
        })
    }
}

/// A camera with another v, which follows from w and the up vector.
fn with_v(v: fn(Vector3, Vector3) -> Vector3) -> Code {
    new_camera(move |([e, g, t], angle): ([_; 3], f64)| {
        let (e, w) = (point(e), unit(-vector(g)));
        let v = unit(v(w, vector(t)));
        Ok(OwnCamera(
            move |[width, height]: [f64; 2], [x, y]: [f64; 2]| {
                // The height of the picture is 2.
                let [x, y] = [x - (width - 1.0) / 2.0, y - (height - 1.0) / 2.0];
                let aside = (v.cross(w) * x + v * y) * (2.0 / height);
                Ray::derived(e, unit(aside - w * (1.0 / libm::tan(angle / 2.0))))
            },
        ))
    })
}

fn unit(v: Vector3) -> Vector3 {
    v.normalized().unwrap_or_default()
}

/// A floor of squares below the sky, by a camera that looks down aslant. The corners of some squares
/// lie below the black crosses.
fn floor(new: &Code, settings: &Settings) -> Result<Image, Error> {
    let angle = 0.9;
    let [e, g, t] = [[3.0, 3.0, 6.0], [-2.5, -2.5, -6.0], [-0.2, 1.0, 0.0]];
    let camera = new(([e, g, t], angle))?;
    let color = |ray: &Ray| {
        let d = ray.direction();
        if d.y() >= 0.0 {
            return Color::new(0.35, 0.55, 0.9) * (1.0 - 0.6 * d.y());
        }
        let point = ray.at(-ray.origin().y() / d.y());
        if point.x().abs() > 4.0 || point.z().abs() > 4.0 {
            return Color::new(0.15, 0.3, 0.15);
        }
        if (point.x().floor() + point.z().floor()) % 2.0 == 0.0 {
            Color::new(0.9, 0.75, 0.45)
        } else {
            Color::new(0.6, 0.25, 0.1)
        }
    };
    let mut image = paint(&*camera, &color, settings)?;
    let Basis { e, u, v, w } = Basis::new(point(e), vector(g), vector(t))?;
    let pixels = f64::from(settings.size.height()) / 2.0 / libm::tan(angle / 2.0);
    let mut corners = Vec::new();
    for [x, z] in [
        [-4.0, -4.0],
        [4.0, -4.0],
        [0.0, 0.0],
        [-2.0, 2.0],
        [2.0, 2.0],
        [-4.0, 4.0],
        [2.0, -2.0],
        [-2.0, -2.0],
    ] {
        let to_corner = Point3::new(x, 0.0, z) - e;
        let depth = -to_corner.dot(w);
        corners.push([u, v].map(|axis| to_corner.dot(axis) / depth * pixels));
    }
    mark(&mut image, &corners);
    Ok(image)
}
