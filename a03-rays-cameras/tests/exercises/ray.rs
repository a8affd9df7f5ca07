//! Points of rays and beside them, compared with the solution.

use a01_image_display::Canvas;

use crate::prelude::*;

yours! { at, t_of => crate::ray::Code { at, t_of } }

#[derive(Clone, Copy)]
pub struct Code {
    pub at: fn(&Ray, f64) -> Point3,
    pub t_of: fn(&Ray, Point3) -> f64,
}

pub fn exercise() -> Exercise<Code> {
    Exercise {
        picture: StudentPicture::own(points_and_feet),
        ..Exercise::asked(|code: &Code, (o, d, t, p)| {
            let ray = Ray::derived(point(o), vector(d));
            Answer::named("at", array((code.at)(&ray, t))).and("t_of", (code.t_of)(&ray, point(p)))
        })
    }
}

/// Rays with directions of different lengths, each an arrow; their points at t = 0, 1, 2 and so on, in
/// blue; and a point beside each, with a line to the nearest point of the ray, in red.
fn points_and_feet(code: &Code, settings: &Settings) -> Result<Image, Error> {
    let mut canvas = Canvas::new(settings.size, Color::WHITE)?;
    let (blue, red) = (Color::new(0.1, 0.3, 0.8), Color::new(0.8, 0.1, 0.1));
    let ink = Color::gray(0.15);
    let place = |p: Point3| (p.x(), 240.0 - p.y());
    for (o, d, steps, beside) in [
        ([20.0, 150.0, 0.0], [90.0, 20.0, 0.0], 3, [80.0, 215.0, 0.0]),
        ([30.0, 80.0, 0.0], [35.0, -4.0, 0.0], 8, [235.0, 100.0, 0.0]),
        ([25.0, 15.0, 0.0], [60.0, 3.0, 0.0], 4, [120.0, 50.0, 0.0]),
    ] {
        let (ray, beside) = (Ray::derived(point(o), vector(d)), point(beside));
        canvas.arrow(place(ray.origin()), place(ray.at(1.0)), 2.0, ink);
        let foot = ray.at((code.t_of)(&ray, beside));
        canvas.line(place(beside), place(foot), 1.0, red);
        canvas.line(place(beside), place(beside), 6.0, ink);
        canvas.line(place(foot), place(foot), 6.0, red);
        for t in 0..=steps {
            let at = place((code.at)(&ray, f64::from(t)));
            canvas.line(at, at, 6.0, blue);
        }
    }
    Ok(canvas.into_image())
}
