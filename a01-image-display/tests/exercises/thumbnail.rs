//! Pictures of random greys, compared with the solution.

use crate::prelude::*;

pub fn check(check: &mut Check, yours: &dyn Fn(&Image, u32) -> Result<Image, Error>) {
    check.compare(
        "a picture of {}x{} with the greys {}, by {}",
        [(2, 2, 2), (4, 1, 3)].map(|(w, h, n)| (w, h, vec![0.0, 1.0, 3.0, 4.0], n)),
        random(|r| {
            let (w, h, n) = (1 + r.below(7), 1 + r.below(7), 1 + r.below(4));
            (w, h, (0..w * h).map(|_| r.between(0.0, 2.0)).collect(), n)
        }),
        [&thumbnail as _, yours],
        |thumbnail, (w, h, greys, n): (_, _, Vec<f64>, _)| {
            let color = |x, y| Color::gray(greys[(y * w + x) as usize]);
            let image = Image::from_fn(Size::new(w, h).ok()?, color).ok()?;
            let small = thumbnail(&image, n).ok()?;
            let greys: Vec<f64> = small.pixels().iter().map(|color| color.g).collect();
            let size = Answer::words(small.size().to_string());
            Some(Answer::named("size", size).and("greys", greys))
        },
    );
    check.picture(|_| yours(&ShowImage::test_card()?.into_image(), 4));
}

variants! { mean:
    yours => &thumbnail;
    wrong "a mean is over the whole square, not one pixel" => |greys, _| greys[0];
    wrong "a square that the edge cuts off has fewer pixels" => |greys, n| {
        greys.iter().sum::<f64>() / (n * n)
    };
    wrong "a square has n times n pixels" => |greys, n| greys.iter().sum::<f64>() / n;
}

/// Another mean of the greys in a square of n by n.
fn mean(c: &mut Check, mean: fn(Vec<f64>, f64) -> f64) {
    check(c, &|image, n| {
        Image::from_fn(thumbnail(image, n)?.size(), |column, row| {
            let places = (0..n * n).map(|i| (column * n + i % n, row * n + i / n));
            let greys = places.filter_map(|(x, y)| Some(image.get(x, y)?.g));
            Color::gray(mean(greys.collect(), n.into()))
        })
    });
}
