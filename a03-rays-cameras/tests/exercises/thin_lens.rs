//! Rays through all places of lenses, compared with the solution.

use crate::prelude::*;

type Through = fn(&Basis, f64, &Ray, (f64, f64)) -> Ray;

pub fn check(check: &mut Check, yours: Through) {
    let camera = |e, gaze| {
        let up = vector([0.0, 1.0, 0.0]);
        PerspectiveCamera::new(point(e), vector(gaze), up, FRAC_PI_4)
    };
    let places = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
    check.compare(
        "eye {}, gaze {}, focus {}, ray through {} of 5 by 3 pixels, place {} of the lens",
        places.map(|place| ([0.0; 3], [0.0, 0.0, -1.0], 2.0, [4.0, 1.0], place)),
        random(|r| {
            let (focus, place) = (r.between(0.1, 20.0), [(); 2].map(|()| r.between(-0.5, 0.5)));
            let pixel = [r.between(-0.5, 4.5), r.between(-0.5, 2.5)];
            (r.triple(9.0), r.triple(3.0), focus, pixel, place)
        }),
        [through_lens, yours],
        |through, (e, gaze, focus, [x, y], place)| {
            let camera = camera(e, gaze).ok()?;
            let ray = camera.ray_for(Size::new(5, 3).ok()?, x, y);
            Some(answer(&through(&camera.basis(), focus, &ray, place.into())))
        },
    );
    // Three walls of holes, one behind the other; the middle one is in focus.
    check.picture(|settings| {
        let camera = camera([0.0; 3], [0.0, 0.0, -1.0])?;
        let (size, samples) = (settings.size, 64_u32);
        let bottom = f64::from(size.height() - 1);
        Image::from_fn(size, |x, y| {
            let ray = camera.ray_for(size, x.into(), bottom - f64::from(y));
            let random = PixelRandom::new(0, x, y);
            let mut sum = Color::BLACK;
            for n in (0..u64::from(samples)).map(|n| 2 * n) {
                let lens = [n, n + 1].map(|n| 0.3 * (random.uniform(n) - 0.5));
                sum += wall(&yours(&camera.basis(), 5.0, &ray, lens.into()));
            }
            sum.map(|channel| channel / f64::from(samples))
        })
    });
}

/// The colour of the nearest disc: a row of each, at three distances.
fn wall(ray: &Ray) -> Color {
    let (o, d) = (ray.origin(), ray.direction());
    for (z, middle, color) in [
        (-2.5, -0.7, Color::new(1.0, 0.3, 0.2)),
        (-5.0, 0.0, Color::new(0.3, 0.9, 0.3)),
        (-15.0, 4.0, Color::new(0.4, 0.5, 1.0)),
    ] {
        let p = ray.at((z - o.z()) / d.z());
        // As large in the picture at every distance.
        let (x, y) = (p.x() / z, (p.y() - middle) / z);
        let x = (x * 5.0 - (x * 5.0).round()) / 5.0;
        if x * x + y * y < 0.006 {
            return color;
        }
    }
    Color::gray(0.05)
}

variants! { check:
    yours => through_lens;
    wrong "the focus is a plane, not a ball" => |basis, focus, ray, place| {
        through_lens(basis, focus * -basis.w.dot(ray.direction()), ray, place)
    };
    wrong "the direction has length 1" => |basis, focus, ray, place| {
        let ray = through_lens(basis, focus, ray, place);
        Ray::derived(ray.origin(), ray.direction() * focus)
    };
    wrong "from another place, the direction is another" => |basis, focus, ray, place| {
        Ray::derived(
            through_lens(basis, focus, ray, place).origin(),
            ray.direction(),
        )
    };
}
