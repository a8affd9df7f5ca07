//! Pictures of all shapes, compared with the solution.

use crate::prelude::*;

pub fn check(check: &mut Check, yours: &dyn Fn(Size) -> Result<Image, Error>) {
    // With an odd number of steps, the line never passes half way between two pixels, where
    // both are right.
    let sizes = random(|r| (1 + r.below(99), 1 + r.below(99)));
    check.compare(
        "a picture of {}x{}",
        [(3, 3), (4, 2), (2, 4), (6, 3), (1, 1), (4, 1), (1, 4)],
        sizes.filter(|(w, h)| w.max(h) % 2 == 0),
        [&line as _, yours],
        |line, size| painted(size, line),
    );
    check.picture(|settings| yours(settings.size));
}

variants! { steps:
    yours => &line;
    wrong "a high picture has a pixel in every row" => |right, _| right, nearest;
    wrong "the nearest pixel need not be the one below" => u32::max, |i, length, steps| {
        i * length / steps
    };
    wrong "a slope is no whole number" => u32::max, |i, length, steps| i * (length / steps);
}

fn nearest(i: u32, length: u32, steps: u32) -> u32 {
    (i * length + steps / 2) / steps
}

/// Steps from corner to corner, whose number follows from the last column and row; and the
/// place on a side after i of them.
fn steps(c: &mut Check, count: fn(u32, u32) -> u32, place: fn(u32, u32, u32) -> u32) {
    check(c, &|size| {
        let mut image = Image::black(size)?;
        let (right, bottom) = (size.width() - 1, size.height() - 1);
        let steps = count(right, bottom);
        for i in 0..=steps {
            let [x, up] = [right, bottom].map(|length| place(i, length, steps.max(1)));
            image.set(x, bottom.saturating_sub(up), Color::BLUE);
        }
        Ok(image)
    });
}
