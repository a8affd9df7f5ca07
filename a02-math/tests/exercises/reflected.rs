//! Vectors on both sides of surfaces, compared with the solution.

use a01_image_display::Canvas;

use crate::prelude::*;

yours! { reflected }

type Code = fn(Vector3, Normal3) -> Vector3;
pub fn exercise() -> Exercise<Code> {
    Exercise {
        picture: StudentPicture::own(parabola),
        ..Exercise::asked(|reflected: &Code, (v, n)| {
            array(reflected(vector(v), vector(n).as_normal()))
        })
    }
}

/// Distance of the focus of the mirror from its lowest point, in pixels.
const FOCUS: f64 = 110.0;

/// A parabola, which mirrors all light along its axis into its focus, a dot; and light from below,
/// which its back mirrors outwards.
fn parabola(reflected: &Code, settings: &Settings) -> Result<Image, Error> {
    let mut canvas = Canvas::new(settings.size, Color::WHITE)?;
    let (blue, red, gray) = (
        Color::new(0.1, 0.3, 0.8),
        Color::new(0.8, 0.1, 0.1),
        Color::gray(0.5),
    );
    let height = |x: f64| x * x / (4.0 * FOCUS);
    let place = |x: f64, up: f64| (160.0 + x, 175.0 - up);
    for x in -140..140 {
        let [from, to] = [f64::from(x), f64::from(x + 1)];
        canvas.line(place(from, height(from)), place(to, height(to)), 3.0, gray);
    }
    let up = Vector3::new(0.0, 1.0, 0.0);
    for x in [-125.0, -95.0, -65.0, -35.0, 35.0, 65.0, 95.0, 125.0] {
        let normal = Vector3::new(-x / (2.0 * FOCUS), 1.0, 0.0);
        let normal = normal.normalized().unwrap_or_default().as_normal();
        for (to_light, far, length, color) in [(up, 175.0, 150.0, red), (-up, -65.0, 45.0, gray)] {
            let at = height(x);
            let away = reflected(to_light, normal) * length;
            canvas.line(place(x, far), place(x, at), 1.5, blue);
            canvas.arrow(place(x, at), place(x + away.x(), at + away.y()), 1.5, color);
        }
    }
    let focus = place(0.0, FOCUS);
    canvas.line(focus, focus, 12.0, Color::gray(0.15));
    Ok(canvas.into_image())
}
